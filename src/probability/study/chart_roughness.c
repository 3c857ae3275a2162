/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The critical angle by moments of each sample against a number of roughness of its base, beside
 * the angles of Eqs. (15) and (16): curves, where either goes one way as the number rises, as
 * against A of one block; else, where they scatter themselves, points. */

#include "study/chart_panels.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_DRAWN = 3000 };

const tp_chart_style tp_study_bound_line = {TP_MARK_LINE, TP_COLOUR_BLACK, TP_DASH_SOLID, 0.7};
const tp_chart_style tp_study_bound_points = {TP_MARK_POINTS, TP_COLOUR_GREY, TP_DASH_DASHED, 0};

/* A sample: its number, and the two angles. */
typedef struct bracket {
  double x, valley, peak;
} bracket;

static int compare(const void *one, const void *other) {
  const double a = ((const bracket *)one)->x, b = ((const bracket *)other)->x;
  return (a > b) - (a < b);
}

/* The columns of what is measured are the last. */
static const double *column_of(const tp_study_result *r, size_t measure) {
  return r->columns[r->column_count - r->roughness_count + measure].values;
}

/* Those drawn that have all three, by rising number; NULL when memory is exhausted. */
static bracket *sort(size_t *count, const tp_study_view *v, size_t measure, size_t stride) {
  const tp_study_result *r = v->result;
  const double *x = column_of(r, measure);
  const double *peak = column_of(r, r->roughness_count - 2);
  const double *valley = column_of(r, r->roughness_count - 1);
  bracket *own = calloc(v->kept / stride + 1, sizeof *own);
  *count = 0;
  for (size_t k = 0; own != NULL && k < v->kept; k += stride) {
    if (isnan(x[k]) || isnan(peak[k]) || isnan(valley[k])) continue;
    own[(*count)++] = (bracket){x[k], valley[k], peak[k]};
  }
  if (own != NULL) qsort(own, *count, sizeof *own, compare);
  return own;
}

static double angle_of(const bracket *own, bool peak) {
  return peak ? own->peak : own->valley;
}

/* Does the angle rise all the way, or fall? Digits of the last places do not count. */
static bool goes_one_way(const bracket *own, size_t count, bool peak) {
  static const double digits = 1e-9;
  bool rises = true, falls = true;
  for (size_t k = 1; k < count; k++) {
    const double before = angle_of(own + k - 1, peak), after = angle_of(own + k, peak);
    rises = rises && after >= before * (1 - digits);
    falls = falls && after <= before * (1 + digits);
  }
  return rises || falls;
}

static void add_bound(tp_chart *chart, const bracket *own, size_t count, bool peak, bool curve,
                      const char *name) {
  tp_chart_add_series(chart, curve ? tp_study_bound_line : tp_study_bound_points,
                      (const char *const[]){name, peak ? "Eq. (15), peak" : "Eq. (16), valley"});
  for (size_t k = 0; k < count; k++) {
    tp_chart_add_point(chart, tp_chart_exactly(own[k].x),
                       tp_chart_exactly(angle_of(own + k, peak)));
  }
}

static void add_samples(tp_chart *chart, const tp_study_view *v, size_t measure, size_t stride,
                        tp_study_outcome outcome) {
  const double *x = column_of(v->result, measure);
  bool begun = false;
  for (size_t k = 0; k < v->kept; k += stride) {
    if ((int)v->outcomes[k] != (int)outcome || isnan(x[k]) || !isfinite(v->angles_deg[k])) continue;
    if (!begun) {
      tp_chart_add_series(chart, tp_study_chart_points(outcome),
                          (const char *const[]){v->result->roughness[measure].name,
                                                tp_study_outcome_name(outcome)});
    }
    begun = true;
    tp_chart_add_point(chart, tp_chart_exactly(x[k]), tp_chart_exactly(v->angles_deg[k]));
  }
}

static void write_label(char *label, size_t size, const tp_study_measure *own) {
  static const struct {
    const char *name, *label;
  } labels[] = {{"amplitude", "Amplitude A"},
                {"rms_height", "RMS height"},
                {"z2", "Z₂"},
                {"effective_angle_deg", "i"},
                {"jrc", "JRC"}};
  const char *shown = own->name;
  for (size_t k = 0; k < sizeof labels / sizeof labels[0]; k++) {
    if (strcmp(own->name, labels[k].name) == 0) shown = labels[k].label;
  }
  if (own->unit == NULL) {
    snprintf(label, size, "%s", shown);
  } else {
    snprintf(label, size, "%s (%s)", shown, strcmp(own->unit, "deg") == 0 ? "°" : own->unit);
  }
}

static tp_chart_range range_of(const tp_study_view *v, const bracket *own, size_t count) {
  double least = v->least, greatest = v->greatest;
  for (size_t k = 0; k < count; k++) {
    least = fmin(least, own[k].valley);
    greatest = fmax(greatest, own[k].peak);
  }
  return tp_study_range(least, greatest);
}

bool tp_study_add_roughness(tp_chart *chart, const tp_study_view *v, size_t measure,
                            bool *has_curves, bool *has_points) {
  const tp_study_measure *own = v->result->roughness + measure;
  const size_t stride = (v->kept + MOST_DRAWN - 1) / MOST_DRAWN;
  size_t count = 0;
  char label[64];
  if (own->samples == 0 || v->finite == 0) return true;
  bracket *brackets = sort(&count, v, measure, stride);
  if (brackets == NULL) return false;
  write_label(label, sizeof label, own);
  tp_chart_add_panel(
      chart, count > 0 ? "Beside Eqs. (15) and (16)" : "Roughness of the base",
      (tp_panel_axis){.label = label, .range = tp_study_range(own->least, own->greatest)},
      (tp_panel_axis){.label = tp_study_angle_label(v), .range = range_of(v, brackets, count)});
  const bool curves = goes_one_way(brackets, count, true) && goes_one_way(brackets, count, false);
  for (int peak = 1; peak >= 0 && count > 0; peak--) {
    add_bound(chart, brackets, count, peak == 1, curves, own->name);
    *(curves ? has_curves : has_points) = true;
  }
  for (int k = 0; k < TP_STUDY_OUTCOMES; k++) {
    add_samples(chart, v, measure, stride, (tp_study_outcome)k);
  }
  free(brackets);
  return true;
}
