/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Sliding by Patton's angles, with their numbers. */

#include "report/sheet.h"

#include "report/sliding.h"

/* i = arctan(rise / run), of a facet that runs from left to right and is no single point. */
static void add_inclination(tp_sheet *s, const tp_case *c) {
  const tp_sliding *own = &c->sliding;
  const bool left = c->towards == TP_TOWARDS_LEFT;
  const tp_bounded run = tp_text_less(own->facet_x1_m, own->facet_x0_m);
  if (!(run.value > run.error)) return;
  const tp_sheet_number y0 = tp_sheet_coordinate(s, own->facet_y0_m),
                        y1 = tp_sheet_coordinate(s, own->facet_y1_m);
  tp_document_add(&s->document, TP_PASSAGE_EQUATION,
                  "i = \\arctan \\frac{%s}{x_1 − x_0} = \\arctan \\frac{%s − %s}{%s − %s} = %s",
                  left ? "y_0 − y_1" : "y_1 − y_0", left ? y0.text : y1.text,
                  left ? y1.text : y0.text, tp_sheet_coordinate(s, own->facet_x1_m).text,
                  tp_sheet_coordinate(s, own->facet_x0_m).text,
                  tp_sheet_angle(own->facet_angle_deg).text);
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

void tp_sheet_add_sliding_formulas(tp_sheet *s, const tp_case *c) {
  const tp_sliding *own = &c->sliding;
  tp_page page = {.solution = s->solution};
  tp_page_add_sliding(&page, c);
  if (page.text.length > 0) {
    tp_sheet_prose(&s->document, TP_PASSAGE_PARAGRAPH, &page.text);
  } else {
    tp_text_drop(&page.text);
  }
  if (!own->known || s->solution->loaded || own->never || own->always) return;
  add_inclination(s, c);
  tp_document_add(&s->document, TP_PASSAGE_EQUATION, "α_{\\text{slide}} = φ + i = %s + %s = %s",
                  tp_sheet_angle(own->friction_angle_deg).text,
                  tp_sheet_angle(own->facet_angle_deg).text,
                  tp_sheet_angle(own->critical_angle_deg).text);
  if (s->solution->has_tilt_angle) add_factors(s, own);
}
