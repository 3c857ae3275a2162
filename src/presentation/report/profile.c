/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Roughness of a profile as text, measure by measure with JRC and Hurst exponent (docs/profile.md),
 * and its facets as CSV. */

#include "common/host.h"
#include "output/encode.h"
#include "report/notes.h"
#include "report/words.h"
#include "terms/names.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { DIGITS = 5, LABEL = 34 };

static void add_bounded(tp_text *t, const char *label, tp_bounded number, const char *unit) {
  char n[TP_NUMBER_SIZE];
  tp_text_add(t, "  %-*s %s%s%s\n", LABEL, label, tp_text_significant(n, number, DIGITS),
              unit[0] != '\0' && strcmp(unit, "°") != 0 ? " " : "", unit);
}

static void add_head(tp_text *t, const tp_profile *p) {
  const tp_profile_options *o = &p->options;
  if (p->title != NULL) {
    tp_encode_plain(t, p->title);
    tp_text_add(t, "\n\n");
  }
  tp_text_add(t, "Roughness of %s, lengths in %s\n",
              p->origin == TP_PROFILE_MATED_BASE ? "the mated base, where the block touches it"
              : p->origin == TP_PROFILE_BASE     ? "the base profile"
                                                 : "the profile",
              p->length_unit);
  if (o->step > 0) {
    tp_text_add(t, "%zu points every %.6g, %s between the %zu that are given", p->point_count,
                o->step, o->resampling == TP_RESAMPLE_SPLINE ? "by a spline" : "straight",
                p->given_points);
  } else if (p->even) {
    tp_text_add(t, "%zu points every %.6g", p->point_count, p->step);
  } else {
    tp_text_add(t, "%zu points at distances from %.6g to %.6g", p->point_count, p->least_step,
                p->largest_step);
  }
  if (o->mirrored) tp_text_add(t, "; mirrored");
  if (o->scale != 1) tp_text_add(t, "; scaled by %.6g", o->scale);
  if (o->detrend == TP_DETREND_TURN) {
    tp_text_add(t, "\nturned onto its mean plane, by %.6g°\n\n", p->trend_deg.value);
  } else {
    tp_text_add(t, "\n%s\n\n",
                o->detrend == TP_DETREND_LINE   ? "the line of least squares is subtracted"
                : o->detrend == TP_DETREND_ENDS ? "the line through both ends is subtracted"
                                                : "no line is subtracted");
  }
}

static void add_shape(tp_text *t, const tp_profile *p) {
  const char *unit = p->length_unit;
  add_bounded(t, "length", p->length, unit);
  add_bounded(t, "length along the profile", p->length_along, unit);
  add_bounded(t, "amplitude A", p->amplitude, unit);
  add_bounded(t, "RMS height", p->rms_height, unit);
  add_bounded(t, "lean against x", p->trend_deg, "°");
  add_bounded(t, "mean slope", p->mean_slope, "");
  add_bounded(t, "mean size of the slope", p->mean_absolute_slope, "");
  add_bounded(t, "Z2, RMS slope", p->z2, "");
  add_bounded(t, "i, of the mean size of the slope", p->effective_angle_deg, "°");
  add_bounded(t, "Rp, along over straight", p->rp, "");
  if (p->has_sf) {
    char square[16];
    snprintf(square, sizeof square, "%s²", unit);
    add_bounded(t, "SF at the step", p->sf, square);
  }
}

static void add_facing(tp_text *t, const tp_profile *p) {
  tp_text_add(t, "\nFacets that a block sliding there must climb\n");
  tp_text_add(t, "  %-8s %8s %10s %10s %10s %8s %16s\n", "towards", "facets", "share", "i",
              "steepest", "C", "steepest/(C+1)");
  for (int d = 0; d < 2; d++) {
    const tp_profile_facing *f = p->facing + d;
    char share[TP_NUMBER_SIZE], angle[TP_NUMBER_SIZE], steepest[TP_NUMBER_SIZE];
    tp_text_add(t, "  %-8s %8zu %10s %9s° %9s°", tp_direction_name((tp_direction)d), f->facets,
                tp_text_fixed(share, f->share, 4), tp_text_fixed(angle, f->angle_deg, 3),
                tp_text_fixed(steepest, f->steepest_deg, 3));
    if (f->facets > 0) {
      tp_text_add(t, " %8.3f %15.3f°\n", f->exponent, f->roughness_deg);
    } else {
      tp_text_add(t, " %8s %16s\n", "none", "none");
    }
  }
}

/* The correlations of one state, below its heading. */
static void add_correlations(tp_text *t, const tp_profile *p, tp_jrc_state state) {
  char n[TP_NUMBER_SIZE];
  bool any = false;
  for (size_t k = 0; k < p->correlation_count; k++) {
    const tp_profile_jrc *own = p->correlations + k;
    if (own->state != state) continue;
    if (!any && state != TP_JRC_MEANT) tp_text_add(t, "  %s:\n", tp_jrc_state_name(state));
    any = true;
    tp_text_add(t, "  %-26s %-30s %6s%s%s\n", own->source, own->equation,
                state == TP_JRC_NO_NUMBER ? "none" : tp_text_fixed(n, own->jrc, 1),
                own->meant_for_step[0] != '\0' ? "  " : "", own->meant_for_step);
  }
}

static void add_jrc(tp_text *t, const tp_profile *p) {
  char n[3][TP_NUMBER_SIZE];
  tp_text_add(t, "\nJRC\n");
  if (p->jrc_meant > 1) {
    tp_text_add(t, "  %s to %s, in the middle %s, by the %zu correlations meant for it:\n",
                tp_text_fixed(n[0], p->jrc_low, 1), tp_text_fixed(n[1], p->jrc_high, 1),
                tp_text_fixed(n[2], p->jrc_median, 1), p->jrc_meant);
  } else if (p->jrc_meant == 1) {
    tp_text_add(t, "  %s by the one correlation that is meant for it:\n",
                tp_text_fixed(n[0], p->jrc_low, 1));
  } else {
    tp_text_add(t, "  no correlation is meant for this profile and its points\n");
  }
  for (int k = 0; k <= TP_JRC_NO_NUMBER; k++) add_correlations(t, p, (tp_jrc_state)k);
  if (!p->has_eq_10) return;
  tp_text_add(t, "  from JCS and the normal stress:\n  %-26s %-30s %6s\n",
              "Alejano et al., Eq. (10)", "i / log10(JCS / stress)",
              tp_text_fixed(n[0], p->jrc_eq_10, 1));
  tp_text_add(t, "    with JCS %.6g MPa and a normal stress of %.6g kPa\n", p->jcs_mpa,
              p->normal_stress_kpa);
}

static void add_hurst(tp_text *t, const char *by, const tp_profile_estimate *own,
                      const double fit[2], const char *what, const char *unit) {
  if (!own->found) {
    tp_text_add(t, "  %-*s none: too few points\n", LABEL, by);
    return;
  }
  tp_text_add(t, "  %-*s %.3f", LABEL, by, own->value);
  if (own->has_range) tp_text_add(t, ", %.3f to %.3f (95 %%)", own->low, own->high);
  tp_text_add(t, "\n  %-*s by %s %.4g to %.4g %s\n", LABEL, "", what, fit[0], fit[1], unit);
  if (own->value <= 0 || own->value >= 1) {
    tp_text_add(t, "  %-*s outside 0 to 1: not self-affine there\n", LABEL, "");
  }
}

static void add_series(tp_text *t, const tp_profile *p) {
  char cycles[32];
  tp_text_add(t, "\nSeries of heights\n");
  if (p->series != TP_SERIES_GIVEN) {
    tp_text_add(t,
                p->series == TP_SERIES_UNEVEN
                    ? "  none: the points lie at uneven distances; --step samples them anew\n"
                    : "  none: fewer than %d points\n",
                TP_PROFILE_SERIES_LEAST);
    return;
  }
  if (p->correlation_length.found) {
    tp_text_add(t, "  %-*s %.4g %s\n", LABEL, "autocorrelation falls to 1/e within",
                p->correlation_length.value, p->length_unit);
  } else {
    tp_text_add(t, "  %-*s none within half the length\n", LABEL, "autocorrelation length");
  }
  snprintf(cycles, sizeof cycles, "cycles/%s", p->length_unit);
  add_hurst(t, "self-affine H, structure function", &p->hurst_by_structure, p->structure_fit,
            "distances", p->length_unit);
  if (p->hurst_by_structure.found) {
    tp_text_add(t, "  %-*s biased to the middle by cut-off waves\n", LABEL, "");
  }
  add_hurst(t, "self-affine H, spectrum", &p->hurst_by_spectrum, p->spectrum_fit, "frequencies",
            cycles);
}

tp_status tp_report_profile(char **text, const tp_profile *p) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(NULL, text);
  TP_REFUSE_NULL(NULL, p);
  tp_text t = {0};
  add_head(&t, p);
  add_shape(&t, p);
  add_facing(&t, p);
  add_jrc(&t, p);
  add_series(&t, p);
  if (p->notes.count > 0) tp_text_add(&t, "\n");
  tp_text_notes(&t, &p->notes);
  return tp_text_finish(&t, text);
}

tp_status tp_report_profile_csv(char **text, const tp_profile *p) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(NULL, text);
  TP_REFUSE_NULL(NULL, p);
  static const double degrees = 57.295779513082323;
  tp_text t = {0};
  tp_text_add(&t, "facet,x0,y0,x1,y1,length,slope,angle_deg,faces\n");
  for (size_t k = 1; k < p->point_count; k++) {
    const double dx = p->x[k] - p->x[k - 1], dy = p->y[k] - p->y[k - 1], slope = dy / dx;
    tp_text_add(&t, "%zu,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%s\n", k, p->x[k - 1],
                p->y[k - 1], p->x[k], p->y[k], sqrt(dx * dx + dy * dy), slope,
                atan(slope) * degrees,
                slope > 0   ? tp_direction_name(TP_TOWARDS_RIGHT)
                : slope < 0 ? tp_direction_name(TP_TOWARDS_LEFT)
                            : "neither");
  }
  return tp_text_finish(&t, text);
}
