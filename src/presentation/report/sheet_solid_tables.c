/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The account of a solid on a plane, by bands and by azimuths, with the governing edge as a
 * formula; its moments, and the poses in which it can rest. */

#include "report/sheet_solid.h"

#include "number/shortest.h"
#include "terms/names.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

/* So many rows of a table; --json has all. */
enum { MOST_ROWS = 60, ROSE_ROWS = 24, POSE_ROWS = 12 };

static const double radian = 3.14159265358979323846 / 180;

/* A number within an equation, in brackets where it is below zero. */
typedef struct number {
  char text[TP_NUMBER_SIZE + 4];
} number;

static number bracketed(double value) {
  number own;
  snprintf(own.text, sizeof own.text, value < 0 ? "(%.7g)" : "%.7g", value);
  return own;
}

/* ---- on a plane --------------------------------------------------------------------------------
 */

static void add_band_table(tp_solid_sheet *s) {
  static const char *const heads[] = {"Points", "Corners", "Height of G (m)", "Least tilt (°)",
                                      "Towards (°)"};
  const tp_solid *own = s->solid;
  tp_document *d = &s->document;
  tp_document_table(
      d, TP_TABLE_OF_COLUMNS, own->has_friction ? 8 : 6, own->has_friction ? 0x7f : 0x3f,
      own->has_below ? "The section, and the least tilt, from level, at which it moves"
                     : "What touches in each band, and the least tilt, from level, at which it "
                       "moves");
  tp_document_cell(d, own->has_below ? "Below (%s)" : "Band (%s)", own->length_unit);
  tp_sheet_add_heads(d, heads, sizeof heads / sizeof heads[0]);
  if (own->has_friction) {
    tp_document_word(d, "Moves at (°)");
    tp_document_word(d, "Motion");
  }
  for (size_t k = 0; k < own->band_count && k < MOST_ROWS; k++) {
    const tp_solid_band *b = own->bands + k;
    char n[TP_SHORTEST_SIZE];
    tp_document_cell(d, "%s", tp_shortest(n, b->band));
    tp_document_cell(d, "%zu", b->touching);
    tp_document_cell(d, "%zu", b->corner_count);
    tp_sheet_add_number(d, b->height_m, 6);
    tp_sheet_add_number_if(d, b->stands, b->least.tilt_deg, 8);
    tp_sheet_add_number_if(d, b->stands, b->least.azimuth_deg, 6);
    if (!own->has_friction) continue;
    tp_sheet_add_number_if(d, b->stands, b->critical_deg, 8);
    tp_document_word(d, b->stands ? tp_mechanism_name(b->mechanism) : "–");
  }
  tp_sheet_add_rest(d, own->band_count, MOST_ROWS);
}

/* The corner of the support that is farthest towards an azimuth: an end of the edge across it. */
static const tp_solid_corner *farthest(const tp_solid_band *b, double azimuth_deg) {
  const double east = sin(radian * azimuth_deg), north = cos(radian * azimuth_deg);
  const tp_solid_corner *best = b->support;
  for (size_t k = 1; k < b->corner_count; k++) {
    const tp_solid_corner *own = b->support + k;
    if (east * (own->east_m - best->east_m) + north * (own->north_m - best->north_m) > 0) {
      best = own;
    }
  }
  return best;
}

static void add_edge_formula(tp_solid_sheet *s, const tp_solid_band *b) {
  tp_document *d = &s->document;
  char n[3][TP_NUMBER_SIZE];
  const tp_solid_corner *p = farthest(b, b->least.azimuth_deg.value);
  const double way = radian * b->least.azimuth_deg.value;
  const number x = bracketed(p->east_m), y = bracketed(p->north_m);
  tp_text_fixed(n[0], b->least.azimuth_deg, 5);
  tp_text_significant(n[1], b->height_m, 8);
  tp_text_significant(n[2], b->least.tilt_deg, 6);
  tp_document_add(
      d, TP_PASSAGE_PARAGRAPH,
      s->solid->has_below
          ? "The least tilt, by hand: the edge of the section that it topples about is at the "
            "distance a from the foot of the centroid, towards the azimuth θ; x to the east and "
            "y to the north, from that foot, are a corner on it, and H is the height of the "
            "centroid over the section."
          : "The least tilt in the governing band, by hand: the edge that it topples about is "
            "at the distance a from the foot of the centroid, towards the azimuth θ; x to the "
            "east and y to the north, from that foot, are a corner on it, and H is the height "
            "of the centroid.");
  tp_document_add(d, TP_PASSAGE_EQUATION,
                  "a = x \\sin θ + y \\cos θ = %s \\sin %s° + %s \\cos %s° = %s \\\\"
                  "α = \\arctan \\frac{a}{H} = \\arctan \\frac{%s}{%s} = %s°",
                  x.text, n[0], y.text, n[0],
                  bracketed(p->east_m * sin(way) + p->north_m * cos(way)).text,
                  bracketed(p->east_m * sin(way) + p->north_m * cos(way)).text, n[1], n[2]);
}

/* Factors as they are printed, by which the least is repeated with a calculator. */
typedef struct printed_factors {
  char text[3][TP_NUMBER_SIZE];
  int count;
} printed_factors;

static const char *print_factor(printed_factors *p, tp_bounded factor) {
  return tp_text_significant_down(p->text[p->count++], factor, 6);
}

/* The factor of safety is the least of these, unless another state has a lesser one. */
static void add_least_factor(tp_document *d, const printed_factors *p,
                             const tp_solid_safety *safety) {
  tp_text list = {0};
  const char *least = p->text[0];
  if (p->count < 2 || safety->states->most > safety->most) return;
  for (int k = 0; k < p->count; k++) {
    tp_text_add(&list, "%s%s", k > 0 ? ", " : "", p->text[k]);
    if (strtod(p->text[k], NULL) < strtod(least, NULL)) least = p->text[k];
  }
  if (list.failed) {
    d->failed = true;
  } else {
    tp_document_add(d, TP_PASSAGE_EQUATION, "\\text{FoS} = \\min (%s) = %s", list.data, least);
  }
  tp_text_drop(&list);
}

static void add_factor_formula(tp_solid_sheet *s, const tp_solid_stance *own) {
  tp_document *d = &s->document;
  printed_factors printed = {.count = 0};
  if (!own->has_fos_toppling && !own->has_fos_sliding) return;
  tp_document_add(
      d, TP_PASSAGE_PARAGRAPH,
      "Factors of safety: the resultant of weight and earthquake presses with N and pulls with T "
      "along the base, in shares of the weight. On driving loads, the part of the weight along the "
      "base and the earthquake, it topples about an edge at the distance a with the unit vector n "
      "outwards, and slides; by strength reduction it slides. The least counts, over all edges, "
      "with the earthquake and without.");
  if (own->has_fos_toppling) {
    tp_document_add(d, TP_PASSAGE_EQUATION,
                    "\\text{FoS} = \\frac{a \\cos α}{a (\\cos α - N) + H T · n} = %s",
                    print_factor(&printed, own->fos_toppling));
  }
  if (!own->has_fos_sliding) return;
  tp_document_add(d, TP_PASSAGE_EQUATION, "\\text{FoS} = \\frac{N \\tan φ}{|T|} = %s",
                  print_factor(&printed, own->fos_sliding));
  const tp_solid_state *state = own->safety.states;
  for (size_t k = 0; k < state->factor_count; k++) {
    const tp_solid_factor *f = state->factors + k;
    if (f->definition != TP_FOS_BY_DRIVING || f->mechanism != TP_SLIDES || !(f->most < HUGE_VAL)) {
      continue;
    }
    if (printed.count == sizeof printed.text / sizeof printed.text[0]) break;
    tp_document_add(d, TP_PASSAGE_EQUATION,
                    "\\text{FoS} = \\frac{\\tan φ \\cos α}{\\tan φ (\\cos α - N) + |T|} = %s",
                    print_factor(&printed, (tp_bounded){.value = f->least}));
  }
  add_least_factor(d, &printed, &own->safety);
}

static void add_rose(tp_solid_sheet *s, const tp_solid_band *b) {
  static const char *const heads[] = {"Azimuth (°)", "Topples at (°)",   "Moves at (°)",
                                      "Motion",      "Acceleration (g)", "Motion"};
  tp_document *d = &s->document;
  const size_t step = (b->rose_count + ROSE_ROWS - 1) / ROSE_ROWS;
  if (b->rose_count == 0) return;
  tp_document_table(d, TP_TABLE_OF_COLUMNS, 6, 0x17,
                    s->solid->has_below
                        ? "Towards each azimuth: tilts from level, and the least horizontal "
                          "acceleration at its tilt"
                        : "Towards each azimuth, in the governing band: tilts from level, and the "
                          "least horizontal acceleration at its tilt");
  tp_sheet_add_heads(d, heads, 6);
  for (size_t k = 0; k < b->rose_count; k += step) {
    const tp_solid_azimuth *own = b->rose + k;
    char n[TP_SHORTEST_SIZE];
    tp_document_cell(d, "%s", tp_shortest(n, own->azimuth_deg));
    tp_sheet_add_number(d, own->toppling_deg, 6);
    tp_sheet_add_number(d, own->critical_deg, 6);
    tp_document_word(d, tp_mechanism_name(own->mechanism));
    tp_sheet_add_number_if(d, own->has_acceleration, own->acceleration_g, 6);
    tp_document_word(d,
                     own->has_acceleration ? tp_mechanism_name(own->acceleration_mechanism) : "–");
  }
}

void tp_solid_sheet_add_bands(tp_solid_sheet *s) {
  const tp_solid *own = s->solid;
  if (own->band_count == 0) return;
  const tp_solid_band *b = own->bands + own->governing;
  tp_document_heading(&s->document, 2, "Account, on a plane base");
  add_band_table(s);
  if (b->stands) add_edge_formula(s, b);
  if (b->has_stance) add_factor_formula(s, &b->stance);
  add_rose(s, b);
}

/* ---- in the appendix ---------------------------------------------------------------------------
 */

void tp_solid_sheet_add_moments(tp_solid_sheet *s) {
  static const char *const words[] = {"V (m³)",    "x_G (m)",   "y_G (m)",   "z_G (m)",
                                      "I_xx (m⁵)", "I_yy (m⁵)", "I_zz (m⁵)", "I_yz (m⁵)",
                                      "I_zx (m⁵)", "I_xy (m⁵)"};
  const tp_solid *own = s->solid;
  const tp_bounded numbers[] = {own->volume_m3,     own->centroid_m[0], own->centroid_m[1],
                                own->centroid_m[2], own->inertia_m5[0], own->inertia_m5[1],
                                own->inertia_m5[2], own->inertia_m5[3], own->inertia_m5[4],
                                own->inertia_m5[5]};
  tp_document *d = &s->document;
  tp_document_heading(d, 2, "Solid");
  tp_document_table(d, TP_TABLE_OF_COLUMNS, 3, 0x6,
                    "Volume, centroid and second moments about it, in the axes of the mesh");
  tp_document_word(d, "Number");
  tp_document_word(d, "Value");
  tp_document_word(d, "Bound");
  for (size_t k = 0; k < sizeof words / sizeof words[0]; k++) {
    tp_document_cell(d, "%s", words[k]);
    tp_sheet_add_number(d, numbers[k], 9);
    tp_document_cell(d, "%.1e", numbers[k].error);
  }
}

void tp_solid_sheet_add_poses(tp_solid_sheet *s) {
  static const char *const heads[] = {"Share",       "Down x",         "y", "z", "Least tilt (°)",
                                      "Towards (°)", "Persistence (m)"};
  const tp_solid *own = s->solid;
  tp_document *d = &s->document;
  if (own->has_wedge || own->pose_count == 0) return;
  tp_document_table(d, TP_TABLE_OF_COLUMNS, 7, 0x7f,
                    "Poses in which it can rest on a plane by itself, by their share of all "
                    "directions, and by how much the centroid has to rise to leave each");
  tp_sheet_add_heads(d, heads, 7);
  for (size_t k = 0; k < own->pose_count && k < POSE_ROWS; k++) {
    const tp_solid_pose *p = own->poses + k;
    tp_sheet_add_number(d, p->share, 5);
    for (int i = 0; i < 3; i++) tp_document_cell(d, "%.4f", p->down[i]);
    tp_sheet_add_number(d, p->least.tilt_deg, 6);
    tp_sheet_add_number(d, p->least.azimuth_deg, 5);
    tp_sheet_add_number_if(d, p->has_persistence, p->persistence_m, 4);
  }
  tp_sheet_add_rest(d, own->pose_count, POSE_ROWS);
}
