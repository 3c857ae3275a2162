/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Style sheets of an SVG (<style>): a rule for each declaration that bears on an outline. Selectors
 * of elements, classes and ids are read; a rule by any other that would hide or move something is
 * refused, and so is what asks for another file or depends on the medium. */

#ifndef TP_FORMAT_SVG_SHEET_H
#define TP_FORMAT_SVG_SHEET_H

#include "format/svg_css.h"

/* One declaration for one selector. */
typedef struct tp_svg_rule {
  char *text; /* its own: the selector, and behind its NUL the value */
  tp_svg_declaration declaration;
  long weight; /* how closely the selector names an element */
} tp_svg_rule;

typedef struct tp_svg_element {
  const char *name, *classes, *id; /* NULL: it has none */
} tp_svg_element;

bool tp_svg_rule_is_of(const tp_svg_rule *rule, const tp_svg_element *element);

/* The rules of all style sheets of a file. */
typedef struct tp_svg_sheets {
  tp_svg_rule *rules;
  long count, room;
} tp_svg_sheets;

typedef enum tp_svg_sheet_outcome {
  TP_SVG_SHEET_DONE,
  TP_SVG_SHEET_REFUSED,
  TP_SVG_SHEET_NO_MEMORY
} tp_svg_sheet_outcome;

/* Rules of the text of a <style>; where it is refused, why (a static text) and where in it. */
tp_svg_sheet_outcome tp_svg_sheets_add(tp_svg_sheets *sheets, const char *text,
                                       const char **problem, size_t *at);
void tp_svg_sheets_clear(tp_svg_sheets *sheets);

#endif
