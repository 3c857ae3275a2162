/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Inherited state of display, visibility, opacity, fill and stroke, updated from element to
 * element. */

#include "format/svg_seen.h"

#include <string.h>

/* What is kept to be used elsewhere, or says something of the drawing. */
static bool is_kept(const char *element) {
  static const char *const kept[] = {"defs",     "symbol",         "clipPath",
                                     "mask",     "marker",         "pattern",
                                     "metadata", "linearGradient", "radialGradient"};
  for (size_t k = 0; k < sizeof kept / sizeof kept[0]; k++) {
    if (strcmp(element, kept[k]) == 0) return true;
  }
  return false;
}

static bool is_set(tp_svg_value value) {
  return value.text != NULL && !tp_svg_value_is(value, "inherit");
}

static bool see_visibility(tp_svg_seen *seen, tp_svg_value value) {
  if (!is_set(value)) return true;
  seen->invisible = tp_svg_value_is(value, "hidden") || tp_svg_value_is(value, "collapse");
  return seen->invisible || tp_svg_value_is(value, "visible") || tp_svg_value_is(value, "initial");
}

static bool is_none(tp_svg_value value) {
  return tp_svg_value_is(value, "none") || tp_svg_value_is(value, "transparent");
}

bool tp_svg_seen_within(tp_svg_seen *seen, const char *element,
                        const tp_svg_value values[TP_SVG_PROPERTIES], tp_svg_property *bad) {
  seen->kept = seen->kept || is_kept(element);
  if (seen->hidden == NULL) {
    if (tp_svg_value_is(values[TP_SVG_DISPLAY], "none")) seen->hidden = "display: none";
    if (tp_svg_value_is_zero(values[TP_SVG_OPACITY])) seen->hidden = "opacity: 0";
  }
  const struct {
    bool *flag;
    tp_svg_property property;
    bool value;
  } paints[] = {
      {&seen->fill_none, TP_SVG_FILL, is_none(values[TP_SVG_FILL])},
      {&seen->fill_clear, TP_SVG_FILL_OPACITY, tp_svg_value_is_zero(values[TP_SVG_FILL_OPACITY])},
      {&seen->stroke_none, TP_SVG_STROKE, is_none(values[TP_SVG_STROKE])},
      {&seen->stroke_clear, TP_SVG_STROKE_OPACITY,
       tp_svg_value_is_zero(values[TP_SVG_STROKE_OPACITY])},
      {&seen->stroke_thin, TP_SVG_STROKE_WIDTH, tp_svg_value_is_zero(values[TP_SVG_STROKE_WIDTH])}};
  for (size_t k = 0; k < sizeof paints / sizeof paints[0]; k++) {
    if (is_set(values[paints[k].property])) *paints[k].flag = paints[k].value;
  }
  *bad = TP_SVG_VISIBILITY;
  return see_visibility(seen, values[TP_SVG_VISIBILITY]);
}

const char *tp_svg_unseen(const tp_svg_seen *seen) {
  if (seen->hidden != NULL) return seen->hidden;
  if (seen->invisible) return "visibility: hidden";
  const bool filled = !seen->fill_none && !seen->fill_clear;
  const bool stroked = !seen->stroke_none && !seen->stroke_clear && !seen->stroke_thin;
  return filled || stroked ? NULL : "neither fill nor stroke";
}
