/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Sliding by Patton's angles, with their numbers. */

#include "report/sheet.h"

#include "report/words.h"

/* i = arctan(rise / run), of a facet that runs from left to right and is no single point; as it is
 * drawn, beside the angle of the plane. */
static void add_inclination(tp_sheet *s, const tp_case *c) {
  const tp_sliding *own = &c->sliding;
  const bool left = c->towards == TP_TOWARDS_LEFT;
  const tp_bounded run = tp_text_less(own->facet_x1_m, own->facet_x0_m);
  if (!(run.value > run.error)) return;
  const tp_sheet_turn turn = tp_sheet_turn_of(s, c);
  const tp_sheet_number y0 = tp_sheet_coordinate(s, own->facet_y0_m),
                        y1 = tp_sheet_coordinate(s, own->facet_y1_m);
  tp_document_add(
      &s->document, TP_PASSAGE_EQUATION,
      "i = %s\\arctan \\frac{%s}{x_1 − x_0} = "
      "%s\\arctan \\frac{%s − %s}{%s − %s} = %s",
      turn.letter, left ? "y_0 − y_1" : "y_1 − y_0", turn.number, left ? y0.text : y1.text,
      left ? y1.text : y0.text, tp_sheet_coordinate(s, own->facet_x1_m).text,
      tp_sheet_coordinate(s, own->facet_x0_m).text, tp_sheet_angle(own->facet_angle_deg).text);
}

static void add_factors(tp_sheet *s, const tp_sliding *own) {
  const tp_bounded tilt = s->solution->tilt_angle_deg;
  const tp_sheet_number phi = tp_sheet_angle(own->friction_angle_deg),
                        i = tp_sheet_angle(own->facet_angle_deg), alpha = tp_sheet_angle(tilt);
  if (own->fos.state == TP_FOS_NUMBER && own->fos.value.value > 0) {
    tp_document_add(&s->document, TP_PASSAGE_PARAGRAPH,
                    "Factor of safety on the mean plane, with φ + i as its strength:");
    tp_document_add(&s->document, TP_PASSAGE_EQUATION,
                    "\\text{FoS} = \\frac{\\tan(φ + i)}{\\tan α} = "
                    "\\frac{\\tan(%s + %s)}{\\tan %s} = %s",
                    phi.text, i.text, alpha.text, tp_sheet_factor(own->fos.value).text);
  }
  if (own->fos_strength.state == TP_FOS_NUMBER && own->fos_strength.value.value > 0) {
    tp_document_add(&s->document, TP_PASSAGE_PARAGRAPH,
                    "Factor of safety of the shear strength along the facet:");
    tp_document_add(&s->document, TP_PASSAGE_EQUATION,
                    "\\text{FoS} = \\frac{\\tan φ}{\\tan(α − i)} = "
                    "\\frac{\\tan %s}{\\tan(%s − %s)} = %s",
                    phi.text, alpha.text, i.text, tp_sheet_factor(own->fos_strength.value).text);
  }
}

static void add_force(tp_sheet *s, const char *what, tp_bounded newtons) {
  char n[TP_NUMBER_SIZE];
  tp_document_word(&s->document, what);
  tp_document_cell(&s->document, "%s %s", tp_text_significant(n, tp_sheet_force(s, newtons), 6),
                   tp_sheet_force_unit(s));
}

static void add_forces(tp_sheet *s, const tp_sliding *own) {
  tp_document *d = &s->document;
  char n[TP_NUMBER_SIZE];
  tp_document_table(d, TP_TABLE_OF_FACTS, 2, 0, "Forces on the facet that slides, of all loads");
  tp_document_word(d, "Inclination of the facet");
  tp_document_cell(d, "i = %s°", tp_page_degrees(n, own->facet_angle_deg));
  add_force(s, "N, normal to it, water aside", own->normal_n);
  add_force(s, "U, by which water lowers that", own->uplift_n);
  add_force(s, "T, along it, down-dip", own->driving_n);
  tp_document_word(d, "tan φ");
  tp_document_cell(d, "%s", tp_text_significant(n, own->friction_tangent, 6));
  add_force(s, "c A, cohesion times area", own->cohesion_n);
  add_force(s, "P, pull of passive anchors that holds back", own->held_n);
}

/* Under loads: what resists over what drives. */
static void add_loaded_factor(tp_sheet *s, const tp_sliding *own) {
  char n[TP_NUMBER_SIZE];
  if (!own->has_forces) return;
  add_forces(s, own);
  if (own->fos.state != TP_FOS_NUMBER) return;
  tp_document_add(&s->document, TP_PASSAGE_PARAGRAPH,
                  "Factor of safety against sliding: shear strength over shear force.");
  tp_document_add(
      &s->document, TP_PASSAGE_EQUATION,
      "\\text{FoS} = \\frac{(N − U) \\tan φ + c A + P}{T} = "
      "\\frac{(%s − %s) · %s + %s + %s}{%s} = %s",
      tp_sheet_force_number(s, own->normal_n).text, tp_sheet_force_number(s, own->uplift_n).text,
      tp_text_significant(n, own->friction_tangent, 6),
      tp_sheet_force_number(s, own->cohesion_n).text, tp_sheet_force_number(s, own->held_n).text,
      tp_sheet_force_number(s, own->driving_n).text, tp_sheet_factor(own->fos.value).text);
}

static void say(tp_sheet *s, const char *sentence) {
  tp_document_add(&s->document, TP_PASSAGE_PARAGRAPH, "%s",
                  tp_document_say(&s->document, sentence));
}

static void add_loaded_angle(tp_sheet *s, const tp_sliding *own) {
  char n[TP_NUMBER_SIZE];
  if (own->never) {
    say(s, "Sliding under the loads: at no tilt.");
  } else if (own->always) {
    say(s, "Sliding under the loads: at every tilt.");
  } else {
    tp_document_add(&s->document, TP_PASSAGE_PARAGRAPH,
                    "Sliding under the loads: %s°, by the forces along and across the facet that "
                    "it slides on.",
                    tp_text_fixed(n, own->critical_angle_deg, 3));
  }
}

/* Which facet, and by which law. */
static void add_facet(tp_sheet *s, const tp_sliding *own) {
  const tp_page page = {.solution = s->solution};
  char n[4][TP_NUMBER_SIZE];
  tp_document_add(&s->document, TP_PASSAGE_PARAGRAPH,
                  "Sliding along the facet from (%s, %s) to (%s, %s).",
                  tp_page_coordinate(&page, n[0], own->facet_x0_m),
                  tp_page_coordinate(&page, n[1], own->facet_y0_m),
                  tp_page_coordinate(&page, n[2], own->facet_x1_m),
                  tp_page_coordinate(&page, n[3], own->facet_y1_m));
  if (s->solution->friction_is_patton) say(s, "φ by Patton's law (Eq. 6).");
  if (s->solution->friction_facet_count > 0) {
    say(s, "φ is the least of that facet and of all parallel to it.");
  }
}

void tp_sheet_add_sliding_formulas(tp_sheet *s, const tp_case *c) {
  const tp_sliding *own = &c->sliding;
  if (!s->solution->has_friction) say(s, "Sliding is not judged: no friction angle is given.");
  if (!own->known) return;
  if (s->solution->loaded) {
    add_loaded_angle(s, own);
    if (!own->never) add_loaded_factor(s, own);
    return;
  }
  if (own->never) {
    say(s, "Sliding: at no tilt, a facet stands too steep in the way.");
    return;
  }
  add_facet(s, own);
  if (own->always) return;
  add_inclination(s, c);
  tp_document_add(&s->document, TP_PASSAGE_EQUATION, "α_{\\text{slide}} = φ + i = %s + %s = %s",
                  tp_sheet_angle(own->friction_angle_deg).text,
                  tp_sheet_angle(own->facet_angle_deg).text,
                  tp_sheet_angle(own->critical_angle_deg).text);
  if (s->solution->has_tilt_angle) add_factors(s, own);
}
