/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The account of a wedge, with the factor of Hoek and Bray as a formula, and towards azimuths. */

#include "report/sheet_solid.h"

#include "number/shortest.h"
#include "report/solid_page.h"
#include "terms/names.h"

#include <math.h>

/* So many azimuths of a table; --json has all. */
enum { AZIMUTHS = 24 };

static void add_wedge_row(tp_document *d, const char *word, tp_bounded number) {
  tp_document_word(d, word);
  tp_sheet_add_number(d, number, 8);
}

static tp_bounded kilo(tp_bounded newtons) {
  return tp_text_over(newtons, 1e3);
}

static void add_wedge_table(tp_document *d, const tp_solid_wedge *w) {
  tp_document_table(d, TP_TABLE_OF_FACTS, 2, 0x2, "Areas and forces of the wedge");
  add_wedge_row(d, "A_A (m²)", w->areas_m2[0]);
  add_wedge_row(d, "A_B (m²)", w->areas_m2[1]);
  if (w->has_crack) add_wedge_row(d, "Area of the crack (m²)", w->crack_area_m2);
  if (w->has_water) add_wedge_row(d, "Mean water pressure (kPa)", w->water_kpa);
  add_wedge_row(d, "N_A (kN)", kilo(w->normal_n[0]));
  add_wedge_row(d, "N_B (kN)", kilo(w->normal_n[1]));
  add_wedge_row(d, "S (kN)", kilo(w->driving_n));
  if (w->has_acceleration_ahead) {
    add_wedge_row(d, "Slides at an acceleration (g)", w->acceleration_ahead_g);
  }
}

/* The least of all azimuths, each where it was found. */
static void add_least(tp_document *d, const tp_solid_wedge *w) {
  static const char *const heads[] = {"", "Least", "Azimuth (°)", "Slides"};
  if (!w->has_worst && !w->has_acceleration) return;
  tp_document_table(d, TP_TABLE_OF_COLUMNS, 4, 0x6,
                    "The least of all azimuths of a horizontal force, proven from both sides");
  tp_sheet_add_heads(d, heads, sizeof heads / sizeof heads[0]);
  if (w->has_worst) {
    tp_document_word(d, "Factor with its earthquake");
    tp_sheet_add_factor_if(d, true, w->worst_fos, 6);
    tp_document_cell(d, "%.6g", w->worst_azimuth_deg);
    tp_document_word(d, tp_text_solid_wedge_on(w->worst_slides_on));
  }
  if (w->has_acceleration) {
    tp_document_word(d, "Acceleration at which the factor is 1 (g)");
    tp_sheet_add_number(d, w->acceleration_g, 6);
    tp_document_cell(d, "%.6g", w->acceleration_azimuth_deg);
    tp_document_word(d, tp_text_solid_wedge_on(w->acceleration_slides_on));
  }
}

static void add_bolts(tp_document *d, const tp_solid_wedge *w) {
  static const char *const heads[] = {"Bolt", "Force (kN)", "Azimuth (°)",
                                      "Below the horizontal (°)", "Force / capacity"};
  if (w->bolt_count == 0) return;
  tp_document_table(d, TP_TABLE_OF_COLUMNS, 5, 0x1f, "Active bolts");
  tp_sheet_add_heads(d, heads, sizeof heads / sizeof heads[0]);
  for (size_t k = 0; k < w->bolt_count; k++) {
    const tp_wedge_bolt *own = w->bolts + k;
    tp_document_cell(d, "%zu", k + 1);
    tp_sheet_add_number(d, kilo(own->force_n), 6);
    tp_document_cell(d, "%.6g", own->azimuth_deg);
    tp_document_cell(d, "%.6g", own->dip_deg);
    tp_sheet_add_number_if(d, own->has_capacity, own->utilisation, 4);
  }
}

static void add_support(tp_document *d, const tp_solid_wedge *w) {
  char n[3][TP_NUMBER_SIZE];
  if (!w->has_support) return;
  const bool above = w->support_dip_deg.value < 0;
  const tp_bounded steepness = {fabs(w->support_dip_deg.value), w->support_dip_deg.error, NULL};
  tp_document_add(
      d, TP_PASSAGE_PARAGRAPH,
      above ? "The least further active force that gives the required factor, with both joints "
              "pressed: %s kN towards %s°, %s° above the horizontal."
            : "The least further active force that gives the required factor, with both joints "
              "pressed: %s kN towards %s°, %s° below the horizontal.",
      tp_text_significant(n[0], kilo(w->support_n), 6),
      tp_text_fixed(n[1], w->support_azimuth_deg, 2), tp_text_fixed(n[2], steepness, 2));
}

static void add_azimuths(tp_document *d, const tp_solid_wedge *w) {
  static const char *const heads[] = {"Azimuth (°)", "FoS", "Slides", "Acceleration (g)", "Slides"};
  const size_t step = (w->azimuth_count + AZIMUTHS - 1) / AZIMUTHS;
  if (!w->has_worst) return;
  tp_document_table(d, TP_TABLE_OF_COLUMNS, 5, 0xb,
                    "Towards each azimuth: the factor with its earthquake, and the acceleration at "
                    "which it is 1");
  tp_sheet_add_heads(d, heads, sizeof heads / sizeof heads[0]);
  for (size_t k = 0; k < w->azimuth_count; k += step) {
    const tp_wedge_azimuth *own = w->azimuths + k;
    char n[TP_SHORTEST_SIZE];
    tp_document_cell(d, "%s", tp_shortest(n, own->azimuth_deg));
    tp_sheet_add_factor_if(d, own->has_fos, own->fos, 6);
    tp_document_word(d, own->has_fos ? tp_text_solid_wedge_on(own->slides_on) : "–");
    tp_sheet_add_number_if(d, own->has_acceleration, own->acceleration_g, 6);
    tp_document_word(d, own->has_acceleration ? tp_text_solid_wedge_on(own->acceleration_slides_on)
                                              : "–");
  }
}

/* c A + N tan φ of a joint, with its numbers. */
static void add_strength(tp_text *letters, tp_text *numbers, const tp_solid_wedge *w, int joint) {
  const tp_wedge_side *side = w->sides + joint;
  const char name = (char)('A' + joint);
  const char *plus = letters->length > 0 ? " + " : "";
  char n[2][TP_NUMBER_SIZE], c[TP_SHORTEST_SIZE], phi[TP_SHORTEST_SIZE];
  tp_text_add(letters, "%sc_%c A_%c + N_%c \\tan φ_%c", plus, name, name, name, name);
  tp_text_add(numbers, "%s%s · %s + %s \\tan %s°", plus, tp_shortest(c, side->cohesion_kpa),
              tp_text_significant(n[0], w->areas_m2[joint], 8),
              tp_text_significant(n[1], kilo(w->normal_n[joint]), 8),
              tp_shortest(phi, side->friction_angle_deg));
}

/* Against its pull up the line as down it. */
static tp_bounded size_of(tp_bounded force) {
  if (force.value < 0) force.value = -force.value;
  return force;
}

static void add_wedge_formula(tp_document *d, const tp_solid_wedge *w) {
  tp_text letters = {0}, numbers = {0};
  char n[2][TP_NUMBER_SIZE];
  if (!w->has_fos || w->driving_n.value == 0) return;
  for (int joint = 0; joint < 2; joint++) {
    if (w->normal_n[joint].value > 0) add_strength(&letters, &numbers, w, joint);
  }
  tp_document_add(d, TP_PASSAGE_PARAGRAPH,
                  "Factor of safety: the strength of the joints that it slides on over the force S "
                  "that drives it there; N is without the water's pressure.");
  if (letters.data != NULL && numbers.data != NULL) {
    tp_document_add(d, TP_PASSAGE_EQUATION,
                    "\\text{FoS} = \\frac{%s}{S} \\\\ \\text{FoS} = \\frac{%s}{%s} = %s",
                    letters.data, numbers.data,
                    tp_text_significant(n[0], kilo(size_of(w->driving_n)), 8),
                    tp_text_significant_down(n[1], w->fos, 6));
  }
  d->failed = d->failed || letters.failed || numbers.failed;
  tp_text_drop(&letters);
  tp_text_drop(&numbers);
}

void tp_solid_sheet_add_wedge(tp_solid_sheet *s) {
  const tp_solid_wedge *own = &s->solid->wedge;
  tp_document *d = &s->document;
  if (!s->solid->has_wedge) return;
  tp_document_heading(d, 2, "Account, sliding between two joints");
  add_wedge_table(d, own);
  add_wedge_formula(d, own);
  add_bolts(d, own);
  add_support(d, own);
  add_least(d, own);
  add_azimuths(d, own);
}
