/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Cascade of one element: each declaration gets a weight from its origin, specificity and
 * !important, and the greatest weight wins. */

#include "format/svg_style.h"

#include "format/svg_shape.h"

#include <string.h>

/* What is set as an attribute of its own name. What moves or shapes is read with the element. */
static bool is_attribute(tp_svg_property property) {
  return property < TP_SVG_MOVES;
}

enum { STYLE_WEIGHT = 1 << 24, IMPORTANT = 1 << 25 };

typedef struct setting {
  tp_svg_value *values;
  long weights[TP_SVG_PROPERTIES];
} setting;

/* The later of two that weigh alike counts. */
static void put(setting *s, const tp_svg_declaration *own, long weight) {
  const long all = weight + (own->important ? IMPORTANT : 0);
  if (s->values[own->property].text != NULL && s->weights[own->property] > all) return;
  s->values[own->property] = own->value;
  s->weights[own->property] = all;
}

void tp_svg_style(tp_svg_value values[TP_SVG_PROPERTIES], const tp_svg_sheets *sheets,
                  const char *element, const char *const *attributes) {
  setting s = {.values = values};
  for (int k = 0; k < TP_SVG_PROPERTIES; k++) {
    const char *text =
        is_attribute(k) ? tp_svg_attribute(attributes, tp_svg_property_name(k)) : NULL;
    values[k] = (tp_svg_value){NULL, 0};
    if (text != NULL) values[k] = tp_svg_trim((tp_svg_value){text, strlen(text)});
    s.weights[k] = -1;
  }
  const tp_svg_element own = {element, tp_svg_attribute(attributes, "class"),
                              tp_svg_attribute(attributes, "id")};
  for (long k = 0; k < sheets->count; k++) {
    const tp_svg_rule *rule = sheets->rules + k;
    if (tp_svg_rule_is_of(rule, &own)) put(&s, &rule->declaration, rule->weight);
  }
  const char *style = tp_svg_attribute(attributes, "style");
  tp_svg_value rest = {style, style != NULL ? strlen(style) : 0};
  for (tp_svg_declaration d; tp_svg_next_declaration(&d, &rest);) put(&s, &d, STYLE_WEIGHT);
}
