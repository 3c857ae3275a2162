/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Rules of a style sheet, and the pieces of CSS that they are made of. */

#ifndef TP_SVG_RULE_H
#define TP_SVG_RULE_H

#include "format/svg_style.h"

/* "display: none !important" */
typedef struct tp_svg_declaration {
  tp_svg_property property;
  tp_svg_value value;
  bool important;
} tp_svg_declaration;

/* One declaration for one selector. */
struct tp_svg_rule {
  char *text; /* its own: the selector, and behind its NUL the value */
  tp_svg_declaration declaration;
  long weight; /* how closely the selector names an element */
};

typedef struct tp_svg_element {
  const char *name, *classes, *id; /* NULL: it has none */
} tp_svg_element;

bool tp_svg_rule_is_of(const tp_svg_rule *rule, const tp_svg_element *element);

/* Without blanks around it. */
tp_svg_value tp_svg_trim(tp_svg_value value);

/* Where one of the characters stands outside of quotes and brackets; the length where none does. */
size_t tp_svg_until(tp_svg_value text, const char *ends);

/* The next declaration of a property that bears on an outline, and step past it. */
bool tp_svg_next_declaration(tp_svg_declaration *own, tp_svg_value *text);

#endif
