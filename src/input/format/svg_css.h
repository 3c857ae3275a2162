/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Declarations of CSS, as far as they bear on an outline: the properties that hide, move or shape
 * an element, and their values as they stand. */

#ifndef TP_FORMAT_SVG_CSS_H
#define TP_FORMAT_SVG_CSS_H

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

/* "display: none !important" */
typedef struct tp_svg_declaration {
  tp_svg_property property;
  tp_svg_value value;
  bool important;
} tp_svg_declaration;

/* Without blanks around it. */
tp_svg_value tp_svg_trim(tp_svg_value value);

/* Where one of the characters stands outside of quotes and brackets; the length where none does. */
size_t tp_svg_until(tp_svg_value text, const char *ends);

/* The next declaration of a property that bears on an outline, and step past it. */
bool tp_svg_next_declaration(tp_svg_declaration *own, tp_svg_value *text);

#endif
