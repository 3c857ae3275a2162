/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A solid as text, with the bounds of its numbers, as JSON, and its roses as CSV
 * (docs/solids.md). */

#include "common/host.h"
#include "number/shortest.h"
#include "output/encode.h"
#include "report/notes.h"
#include "report/results.h"
#include "report/solid_page.h"
#include "terms/names.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { DIGITS = 9, TILT = TP_SOLID_TILT_DIGITS, LABEL = 18, POSES = 12 };

static void add_bounded(tp_text *t, const char *label, tp_bounded number, const char *unit) {
  char n[TP_NUMBER_SIZE];
  if (fabs(number.value) <= number.error) {
    tp_text_add(t, "  %-*s 0 ± %.1e %s\n", LABEL, label, fabs(number.value) + number.error, unit);
    return;
  }
  tp_text_add(t, "  %-*s %s %s  ± %.1e\n", LABEL, label, tp_text_significant(n, number, DIGITS),
              unit, number.error);
}

tp_mechanism tp_solid_row_verdict(const tp_solid *solid) {
  const tp_solid_band *own = tp_solid_band_that_governs(solid);
  return own->has_stance ? own->stance.verdict : TP_TOPPLES;
}

static void add_parts(tp_text *t, const tp_solid *s) {
  for (size_t k = 0; k < s->part_count; k++) {
    const tp_solid_part *own = s->parts + k;
    char n[TP_SHORTEST_SIZE];
    add_bounded(t, own->is_hole ? "hole" : "part", own->volume_m3, "m³");
    tp_text_add(t, "    in ");
    tp_encode_plain(t, own->file);
    if (!own->is_hole) tp_text_add(t, ", %s kN/m³", tp_shortest(n, own->unit_weight_kn_m3));
    tp_text_add(t, "\n");
  }
}

static void add_body(tp_text *t, const tp_solid *s) {
  static const char *const axes[] = {"x", "y", "z"};
  static const char *const pairs[] = {"xx", "yy", "zz", "yz", "zx", "xy"};
  char label[32];
  if (s->title != NULL) {
    tp_encode_plain(t, s->title);
    tp_text_add(t, "\n");
  }
  tp_encode_plain(t, s->file);
  tp_text_add(t, "\n\n");
  if (s->of_scene) tp_text_solid_answer_wrapped(t, s);
  tp_text_add(t, "%s of %zu triangles, %zu points; ", s->has_wedge ? "Wedge" : "Solid",
              s->triangles, s->vertices);
  if (s->of_scene) {
    char metres[TP_SHORTEST_SIZE];
    tp_text_add(t, "a length of the mesh is %s m\n", tp_shortest(metres, s->metres_per_unit));
  } else {
    tp_text_add(t, "lengths of the mesh in %s\n", s->length_unit);
  }
  if (s->has_below) {
    tp_text_add(
        t,
        "  %-*s %.6g %s over its lowest point by a plane across up: what lies below is ground,\n"
        "  %-*s and all that follows is of what lies above, which rests on the section\n",
        LABEL, "cut", s->below, s->length_unit, LABEL, "");
  }
  add_bounded(t, "volume", s->volume_m3, "m³");
  if (s->has_weight) add_bounded(t, "weight", s->weight_n, "N");
  add_parts(t, s);
  for (int k = 0; k < 3; k++) {
    snprintf(label, sizeof label, "centroid %s", axes[k]);
    add_bounded(t, label, s->centroid_m[k], "m");
  }
  for (int k = 0; k < 6; k++) {
    snprintf(label, sizeof label, "inertia %s", pairs[k]);
    add_bounded(t, label, s->inertia_m5[k], "m⁵");
  }
  tp_text_add(t, "  %-*s %s\n", LABEL, "moments summed in",
              s->level == TP_LEVEL_EXACT ? "whole numbers" : "doubles with bounds");
}

/* ---- as it lies --------------------------------------------------------------------------------
 */

/* Nine digits: a millimetre of a hundred kilometres. */
static void add_point(tp_text *t, const double point[3]) {
  tp_text_add(t, "(%.9g, %.9g, %.9g)", point[0], point[1], point[2]);
}

static bool is_same_point(const double a[3], const double b[3]) {
  return a[0] == b[0] && a[1] == b[1] && a[2] == b[2];
}

/* About which edge, once for bands in a row that have the same. */
static void add_edges(tp_text *t, const tp_solid *s) {
  const tp_solid_tilt *last = NULL;
  for (size_t k = 0; k < s->band_count; k++) {
    const tp_solid_band *b = s->bands + k;
    const tp_solid_tilt *own = &b->least;
    if (!b->stands) continue;
    const bool same = last != NULL && is_same_point(own->edge_from, last->edge_from) &&
                      is_same_point(own->edge_to, last->edge_to);
    last = own;
    if (same) continue;
    tp_text_add(t, "  %s %.6g %s: about the edge of the mesh from ", tp_text_solid_band_word(s),
                b->band, s->length_unit);
    add_point(t, own->edge_from);
    tp_text_add(t, " to ");
    add_point(t, own->edge_to);
    tp_text_add(t, ", ± %.1e°\n", own->tilt_deg.error);
  }
}

static void add_band(tp_text *t, const tp_solid *s, const tp_solid_band *b) {
  char tilt[TP_NUMBER_SIZE], azimuth[TP_NUMBER_SIZE], critical[TP_NUMBER_SIZE];
  tp_text_add(t, "  %10.6g %9zu %9zu", b->band, b->touching, b->corner_count);
  if (!b->stands) {
    tp_text_add(t, "  %s\n",
                b->corner_count < 3 ? "does not stand: a point or a line touches"
                                    : "does not stand: the centroid is beyond the support");
    return;
  }
  tp_text_add(t, "  %11s° %9s°", tp_text_significant(tilt, b->least.tilt_deg, TILT),
              tp_text_fixed(azimuth, b->least.azimuth_deg, 3));
  if (s->has_friction) {
    tp_text_add(t, "  %11s°  %s", tp_text_significant(critical, b->critical_deg, TILT),
                tp_mechanism_name(b->mechanism));
  }
  tp_text_add(t, "\n");
}

/* How the least tilt goes with the band, which decides more than any digit of it. */
static void add_range(tp_text *t, const tp_solid *s) {
  double least = INFINITY, most = -INFINITY;
  bool falls = false;
  for (size_t k = 0; k < s->band_count; k++) {
    const tp_solid_band *b = s->bands + k;
    falls = falls || !b->stands;
    if (!b->stands) continue;
    least = fmin(least, b->least.tilt_deg.value);
    most = fmax(most, b->least.tilt_deg.value);
  }
  if (s->band_count > 1 && (falls || most > least)) {
    tp_text_add(
        t, "  The results depend on which points are taken to touch: choose bands by the noise of "
           "the\n  survey, and rely on the least value of their range.\n");
  }
}

static void add_bands(tp_text *t, const tp_solid *s) {
  char band[TP_SOLID_BAND_SIZE];
  tp_text_add(t, "\nAs it lies, up (%.6g, %.6g, %.6g), %s", s->up[0], s->up[1], s->up[2],
              s->is_on_slope ? "tilted from where its base, which dips, would be level"
              : s->has_below ? "on the section"
                             : "on a plane base");
  if (s->has_friction) tp_text_add(t, ", friction angle %.6g°", s->friction_angle_deg);
  tp_text_add(t, "\n  %10s %9s %9s  %12s %10s%s\n", tp_text_solid_band(band, s), "touching",
              "corners", "least tilt", "azimuth", s->has_friction ? "         moves" : "");
  for (size_t k = 0; k < s->band_count; k++) add_band(t, s, s->bands + k);
  add_edges(t, s);
  add_range(t, s);
}

/* The least tilt towards each of eight azimuths, or all where they are fewer. */
static void add_rose(tp_text *t, const tp_solid *s) {
  enum { COLUMNS = 8 };
  char band[TP_SOLID_BAND_SIZE];
  const tp_solid_band *b = s->bands;
  while (b < s->bands + s->band_count && !b->stands) b++;
  if (b == s->bands + s->band_count) return;
  const size_t step = (b->rose_count + COLUMNS - 1) / COLUMNS;
  tp_text_add(t, "\nTilt at which it %s towards an azimuth; --csv and --json have all %zu\n  %10s",
              s->has_friction ? "moves" : "topples", b->rose_count, tp_text_solid_band(band, s));
  for (size_t k = 0; k < b->rose_count; k += step) {
    tp_text_add(t, " %8.4g°", b->rose[k].azimuth_deg);
  }
  tp_text_add(t, "\n");
  for (size_t n = 0; n < s->band_count; n++) {
    b = s->bands + n;
    if (!b->stands) continue;
    tp_text_add(t, "  %10.6g", b->band);
    for (size_t k = 0; k < b->rose_count; k += step) {
      char n_text[TP_NUMBER_SIZE];
      tp_text_add(t, " %8s°", tp_text_fixed(n_text, b->rose[k].critical_deg, 3));
    }
    tp_text_add(t, "\n");
  }
}

/* ---- poses -------------------------------------------------------------------------------------
 */

/* In metres, a few digits: the noise of a survey has none. */
static const char *add_rise(char text[TP_NUMBER_SIZE + 4], const tp_solid_pose *p) {
  if (!p->has_persistence) return "the lowest";
  snprintf(text, TP_NUMBER_SIZE + 4, "%.3g m", p->persistence_m.value);
  return text;
}

static void add_lasting(tp_text *t, const tp_solid *s) {
  if (s->band_count == 0 || s->pose_count < 2 || s->has_below) return;
  tp_text_add(t, "  Poses that last where each point is off by a band, for their persistence is "
                 "more than twice it:");
  for (size_t k = 0; k < s->band_count; k++) {
    tp_text_add(t, "%s %zu at %.6g", k == 0 ? "\n " : ",", s->bands[k].lasting_poses,
                s->bands[k].band);
  }
  tp_text_add(t, "\n");
}

static void add_poses(tp_text *t, const tp_solid *s) {
  tp_text_add(t,
              "\n%zu pose%s in which it can rest on a plane by itself, of %zu facets of its convex "
              "hull\n",
              s->pose_count, s->pose_count == 1 ? "" : "s", s->facets);
  tp_text_add(t, "  %9s %9s  %-27s %12s %10s %12s\n", "share", "facet", "down", "least tilt",
              "azimuth", "persistence");
  for (size_t k = 0; k < s->pose_count && k < POSES; k++) {
    const tp_solid_pose *p = s->poses + k;
    char share[TP_NUMBER_SIZE], own[TP_NUMBER_SIZE], tilt[TP_NUMBER_SIZE], azimuth[TP_NUMBER_SIZE];
    char down[64], rise[TP_NUMBER_SIZE + 4];
    snprintf(down, sizeof down, "(%.4f, %.4f, %.4f)", p->down[0], p->down[1], p->down[2]);
    tp_text_add(t, "  %9s %9s  %-27s %11s° %9s° %11s\n", tp_text_fixed(share, p->share, 6),
                tp_text_fixed(own, p->facet_share, 6), down,
                tp_text_significant(tilt, p->least.tilt_deg, TILT),
                tp_text_fixed(azimuth, p->least.azimuth_deg, 3), add_rise(rise, p));
  }
  if (s->pose_count > POSES) {
    tp_text_add(t, "  and %zu more of smaller shares, which --json has\n", s->pose_count - POSES);
  }
  add_lasting(t, s);
}

tp_status tp_report_solid(char **text, const tp_solid *solid) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(NULL, text);
  TP_REFUSE_NULL(NULL, solid);
  tp_text t = {0};
  add_body(&t, solid);
  tp_text_solid_repair(&t, solid);
  tp_text_solid_thinning(&t, solid);
  if (solid->band_count > 0) add_bands(&t, solid);
  tp_text_solid_stances(&t, solid);
  tp_text_solid_contacts(&t, solid);
  tp_text_solid_wedge(&t, solid);
  add_rose(&t, solid);
  if (!solid->has_wedge) add_poses(&t, solid);
  if (solid->notes.count > 0) tp_text_add(&t, "\n");
  tp_text_notes(&t, &solid->notes);
  return tp_text_finish(&t, text);
}

/* ---- for programs ------------------------------------------------------------------------------
 */

tp_status tp_report_solid_json(char **text, const tp_solid *solid) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(NULL, text);
  TP_REFUSE_NULL(NULL, solid);
  tp_json_subject x = {.s = NULL};
  return tp_json_document_of_solid(text, solid, &x);
}

tp_status tp_report_solid_csv(char **text, const tp_solid *solid) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(NULL, text);
  TP_REFUSE_NULL(NULL, solid);
  tp_text t = {0};
  tp_text_add(&t, "band,azimuth_deg,toppling_deg,toppling_error,critical_deg,critical_error,"
                  "mechanism\n");
  for (size_t n = 0; n < solid->band_count; n++) {
    const tp_solid_band *b = solid->bands + n;
    for (size_t k = 0; k < b->rose_count; k++) {
      const tp_solid_azimuth *a = b->rose + k;
      tp_text_add(&t, "%.17g,%.17g,%.17g,%.3g,%.17g,%.3g,%s\n", b->band, a->azimuth_deg,
                  a->toppling_deg.value, a->toppling_deg.error, a->critical_deg.value,
                  a->critical_deg.error, tp_mechanism_name(a->mechanism));
    }
  }
  return tp_text_finish(&t, text);
}

tp_status tp_report_solid_row_csv(char **text, const tp_solid *solid) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(NULL, text);
  TP_REFUSE_NULL(NULL, solid);
  tp_text t = {0};
  const tp_json_subject x = {.s = NULL};
  tp_text_add(&t, "scene");
  tp_csv_names_of_solid_row(&t);
  tp_text_add(&t, "\n");
  tp_encode_csv(&t, solid->scene != NULL ? solid->scene : solid->file);
  tp_csv_fields_of_solid_row(&t, solid, &x);
  tp_text_add(&t, "\n");
  return tp_text_finish(&t, text);
}
