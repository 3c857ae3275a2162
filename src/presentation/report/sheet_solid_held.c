/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The account of a solid on contacts, with forces and motions, and of a wedge, with the factor of
 * Hoek and Bray as a formula. */

#include "report/sheet_solid.h"

#include "number/shortest.h"
#include "report/solid_page.h"
#include "terms/names.h"

/* So many rows of a table; --json has all. */
enum { MOST_ROWS = 60, WAY_ROWS = 24 };

/* ---- contacts ----------------------------------------------------------------------------------
 */

static void add_contact_table(tp_solid_sheet *s) {
  static const char *const heads[] = {
      "Point", "At x", "y", "z", "Normal x", "y", "z", "φ (°)", "Normal force", "Shear force"};
  const tp_solid_contacts *own = &s->solid->contacts;
  const bool held = tp_solid_is_held(own);
  const size_t columns = held ? 10 : 8;
  tp_document *d = &s->document;
  tp_document_table(d, TP_TABLE_OF_COLUMNS, columns, 0x3ff,
                    held ? "Contacts, with one of the systems of forces that hold it, across and "
                           "along each, in shares of its weight"
                         : "Contacts");
  tp_sheet_add_heads(d, heads, columns);
  for (size_t k = 0; k < own->contact_count && k < MOST_ROWS; k++) {
    const tp_solid_contact *c = own->contacts + k;
    tp_document_cell(d, "%zu", k + 1);
    for (int i = 0; i < 3; i++) tp_document_cell(d, "%.6g", c->at[i]);
    for (int i = 0; i < 3; i++) tp_document_cell(d, "%.5f", c->normal[i]);
    tp_document_cell(d, "%.5g", c->friction_angle_deg);
    if (!held) continue;
    const tp_contact_shares shares = tp_solid_contact_shares(c);
    tp_document_cell(d, "%.4f", shares.across);
    tp_document_cell(d, "%.4f", shares.along);
  }
  tp_sheet_add_rest(d, own->contact_count, MOST_ROWS);
}

static void add_motion(tp_solid_sheet *s, const tp_solid_motion *motion, const char *format) {
  tp_text t = {0}, told = {0};
  tp_text_solid_motion(&told, motion);
  tp_text_add(&t, format, told.data != NULL ? told.data : "");
  t.failed = t.failed || told.failed;
  tp_text_drop(&told);
  tp_document_tell(&s->document, TP_PASSAGE_PARAGRAPH, 0, &t);
}

static void add_ways(tp_solid_sheet *s) {
  static const char *const heads[] = {"Azimuth (°)", "Held up to (°)", "Motion", "Acceleration (g)",
                                      "Motion"};
  const tp_solid_contacts *own = &s->solid->contacts;
  const size_t step = (own->way_count + WAY_ROWS - 1) / WAY_ROWS;
  tp_document *d = &s->document;
  if (own->way_count == 0) return;
  tp_document_table(d, TP_TABLE_OF_COLUMNS, 5, 0xb,
                    "Towards each azimuth: the tilt from level, and the horizontal acceleration at "
                    "its tilt, up to which forces hold it");
  tp_sheet_add_heads(d, heads, sizeof heads / sizeof heads[0]);
  for (size_t k = 0; k < own->way_count; k += step) {
    const tp_solid_way *way = own->ways + k;
    char n[TP_SHORTEST_SIZE];
    tp_document_cell(d, "%s", tp_shortest(n, way->azimuth_deg));
    tp_sheet_add_number_if(d, way->has_critical, way->critical_deg, 6);
    tp_document_word(d, tp_mechanism_name(way->mechanism));
    tp_sheet_add_number_if(d, way->has_acceleration, way->acceleration_g, 6);
    tp_document_word(d,
                     way->has_acceleration ? tp_mechanism_name(way->acceleration_mechanism) : "–");
  }
}

static void add_ground_bands(tp_solid_sheet *s) {
  static const char *const heads[] = {
      "Contacts", "Widest gap (m)", "Normals differ by (°)", "Held up to (°)",
      "FoS",      "Verdict",        "With their mean (°)",   "FoS",
      "Verdict"};
  const tp_solid_ground *own = &s->solid->ground;
  tp_document *d = &s->document;
  if (!s->solid->has_ground) return;
  tp_document_table(d, TP_TABLE_OF_COLUMNS, 10, 0x1bf,
                    "On its ground: what is no farther from it than the band touches");
  tp_document_cell(d, "Band (%s)", s->solid->length_unit);
  tp_sheet_add_heads(d, heads, sizeof heads / sizeof heads[0]);
  for (size_t k = 0; k < own->band_count; k++) {
    const tp_solid_ground_band *b = own->bands + k;
    char n[TP_SHORTEST_SIZE];
    tp_document_cell(d, "%s", tp_shortest(n, b->band));
    tp_document_cell(d, "%zu", b->contacts);
    tp_document_cell(d, "%.3g", b->widest_m);
    tp_document_cell(d, "%.4g", b->normals_deg);
    tp_sheet_add_number_if(d, b->has_critical, b->critical_deg, 6);
    tp_sheet_add_number_if(d, b->has_fos, b->fos, 6);
    tp_document_word(d, tp_mechanism_name(b->verdict));
    tp_sheet_add_number_if(d, b->has_smooth_critical, b->smooth_critical_deg, 6);
    tp_sheet_add_number_if(d, b->has_smooth_fos, b->smooth_fos, 6);
    tp_document_word(d, b->has_smooth ? tp_mechanism_name(b->smooth_verdict) : "–");
  }
}

void tp_solid_sheet_add_contacts(tp_solid_sheet *s) {
  const tp_solid_contacts *own = &s->solid->contacts;
  tp_document *d = &s->document;
  if (!s->solid->has_contacts) return;
  tp_document_heading(d, 2, "Account, on its contacts");
  if (own->has_motion) {
    add_motion(s, &own->motion, "It certainly moves, for no forces hold it: it %s.");
  }
  if (own->has_critical) add_motion(s, &own->critical, "At the limit tilt it %s.");
  if (own->has_fos) {
    tp_document_add(d, TP_PASSAGE_PARAGRAPH,
                    "The factor of safety is the lesser of two: what tan φ of all contacts may be "
                    "divided by, and what the part of the weight along the base and the earthquake "
                    "may be multiplied by, until no forces hold it.");
  }
  add_ground_bands(s);
  add_contact_table(s);
  add_ways(s);
}

/* ---- a wedge -----------------------------------------------------------------------------------
 */

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
                    tp_text_significant(n[1], w->fos, 6));
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
}
