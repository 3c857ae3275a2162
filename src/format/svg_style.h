/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What CSS says of an element of an SVG, as far as it bears on an outline: whether it is seen, and
 * what would move or shape it.
 *
 * A property is set by an attribute of its name, by a rule of a style sheet (<style>), or by the
 * attribute "style", the later in this order before the earlier, rules by how closely their
 * selector names an element, and what is !important before all others. Selectors of elements,
 * classes and ids are told; a rule by any other that would hide or move something is refused, and
 * so is what asks for another file or depends on the medium. */

#ifndef TP_SVG_STYLE_H
#define TP_SVG_STYLE_H

#include <stdbool.h>
#include <stddef.h>

typedef enum tp_svg_property {
  TP_SVG_DISPLAY,
  TP_SVG_VISIBILITY,
  TP_SVG_OPACITY,
  TP_SVG_FILL,
  TP_SVG_FILL_OPACITY,
  TP_SVG_STROKE,
  TP_SVG_STROKE_OPACITY,
  TP_SVG_STROKE_WIDTH,
  TP_SVG_CLIP_PATH,
  TP_SVG_MASK,
  TP_SVG_ORIGIN, /* transform-origin */
  TP_SVG_BOX,    /* transform-box */
  TP_SVG_MOVES,  /* from here on what moves or shapes by CSS alone */
  TP_SVG_TRANSFORM = TP_SVG_MOVES,
  TP_SVG_TRANSLATE,
  TP_SVG_ROTATE,
  TP_SVG_SCALE,
  TP_SVG_OFFSET,
  TP_SVG_OFFSET_PATH,
  TP_SVG_ZOOM,
  TP_SVG_SHAPES, /* from here on the geometry of a shape */
  TP_SVG_X = TP_SVG_SHAPES,
  TP_SVG_Y,
  TP_SVG_WIDTH,
  TP_SVG_HEIGHT,
  TP_SVG_CX,
  TP_SVG_CY,
  TP_SVG_R,
  TP_SVG_RX,
  TP_SVG_RY,
  TP_SVG_D,
  TP_SVG_PROPERTIES
} tp_svg_property;

const char *tp_svg_property_name(tp_svg_property property);

/* A value as it stands, without blanks around it; NULL: it is not set. */
typedef struct tp_svg_value {
  const char *text;
  size_t length;
} tp_svg_value;

bool tp_svg_value_is(tp_svg_value value, const char *word);
/* A number of zero or less, or a share of it: "0", "0.0", "0%". */
bool tp_svg_value_is_zero(tp_svg_value value);

typedef struct tp_svg_rule tp_svg_rule;

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

/* What an element of a name and attributes has set; the values point into these and the sheets. */
void tp_svg_style(tp_svg_value values[TP_SVG_PROPERTIES], const tp_svg_sheets *sheets,
                  const char *element, const char *const *attributes);

#endif
