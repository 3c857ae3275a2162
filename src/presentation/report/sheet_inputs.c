/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What was given, on the first page of a sheet: section, weight, contact, friction, slope or tilt,
 * and the loads with their sizes. */

#include "report/sheet.h"

#include "report/settings.h"
#include "report/words.h"
#include "terms/names.h"

static void add_section(tp_sheet *s) {
  const tp_solution *own = s->solution;
  const tp_block_result *b = &own->block;
  const tp_page page = {.solution = own};
  const char *unit = own->length_unit;
  char n[3][TP_NUMBER_SIZE];
  tp_document *d = &s->document;
  const double metres = own->metres_per_unit;
  tp_text_significant(n[0], tp_text_over(tp_text_over(b->area_m2, metres), metres), 6);
  tp_document_word(d, "Section");
  tp_document_cell(d, "A = %s %s²; centroid of the weight G (%s, %s) %s", n[0], unit,
                   tp_page_coordinate(&page, n[1], b->centroid_x_m),
                   tp_page_coordinate(&page, n[2], b->centroid_y_m), unit);
  tp_document_word(d, "Weight");
  if (!b->has_weight) {
    tp_document_cell(d, "not given: forces are stated as multiples of the weight W, or not at all");
    return;
  }
  tp_document_cell(d, "W = %s %s over a thickness of %s %s",
                   tp_text_significant(n[0], tp_sheet_force(s, b->weight_n), 6),
                   tp_sheet_force_unit(s), tp_page_length(&page, n[1], b->thickness_m, 6), unit);
}

static void add_contact(tp_sheet *s) {
  const tp_contact_result *c = &s->solution->contact;
  const tp_page page = {.solution = s->solution};
  char n[TP_NUMBER_SIZE];
  tp_document *d = &s->document;
  tp_document_word(d, "Contact");
  tp_document_cell(d, "facets: %zu, single points: %zu; length along the facets %s %s", c->facets,
                   c->points, tp_page_length(&page, n, c->length_m, 6), s->solution->length_unit);
}

static void add_friction(tp_sheet *s) {
  const tp_solution *own = s->solution;
  char n[TP_NUMBER_SIZE];
  tp_document *d = &s->document;
  tp_document_word(d, "Friction");
  if (!own->has_friction) {
    tp_document_word(d, "not given: sliding is not judged");
    return;
  }
  tp_page_degrees(n, own->friction_angle_deg);
  if (own->friction_is_residual) {
    tp_document_cell(d, "φ = %s°, residual; more at low stress (Barton's law)", n);
  } else if (own->friction_is_patton) {
    tp_document_cell(d, "φ = %s° with the roughness i (Patton's law)", n);
  } else if (own->friction_facet_count > 0) {
    tp_document_cell(d, "φ = %s°; some facets have a friction of their own", n);
  } else {
    tp_document_cell(d, "φ = %s°", n);
  }
}

static void add_tilt(tp_sheet *s) {
  const tp_solution *own = s->solution;
  char n[TP_NUMBER_SIZE];
  tp_document *d = &s->document;
  if (own->frame.world && own->frame.dips) {
    tp_document_word(d, "As it lies");
    tp_document_cell(d,
                     own->frame.dips_towards == TP_TOWARDS_LEFT
                         ? "the plane dips by %s° towards the left"
                         : "the plane dips by %s° towards the right",
                     tp_page_degrees(n, own->frame.dip_deg));
    return;
  }
  tp_document_word(d, "Tilt");
  if (own->has_tilt_angle) {
    tp_document_cell(d, "α = %s°", tp_page_degrees(n, own->tilt_angle_deg));
  } else {
    tp_document_word(d, "not given: no factors of safety");
  }
}

void tp_sheet_add_inputs(tp_sheet *s) {
  tp_document *d = &s->document;
  tp_document_table(d, TP_TABLE_OF_FACTS, 2, 0, "Inputs");
  if (s->solution->load_case != NULL) {
    tp_document_word(d, "Load case");
    tp_document_outside_cell(d, s->solution->load_case);
  }
  add_section(s);
  add_contact(s);
  add_friction(s);
  add_tilt(s);
  tp_sheet_add_given_loads(s);
  tp_sheet_add_settings(d, &s->solution->settings);
}
