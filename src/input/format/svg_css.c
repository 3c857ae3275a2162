/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Scanner of CSS declarations with quotes, brackets and !important; names of the properties that
 * matter and tests of their values. */

#include "format/svg_css.h"

#include "format/svg_shape.h"

#include <string.h>
#include <strings.h>

static const char *const names[TP_SVG_PROPERTIES] = {"display",
                                                     "visibility",
                                                     "opacity",
                                                     "fill",
                                                     "fill-opacity",
                                                     "stroke",
                                                     "stroke-opacity",
                                                     "stroke-width",
                                                     "clip-path",
                                                     "mask",
                                                     "transform-origin",
                                                     "transform-box",
                                                     "transform",
                                                     "translate",
                                                     "rotate",
                                                     "scale",
                                                     "offset",
                                                     "offset-path",
                                                     "zoom",
                                                     "x",
                                                     "y",
                                                     "width",
                                                     "height",
                                                     "cx",
                                                     "cy",
                                                     "r",
                                                     "rx",
                                                     "ry",
                                                     "d"};

const char *tp_svg_property_name(tp_svg_property property) {
  return names[property];
}

/* ---- values ------------------------------------------------------------------------------------
 */

bool tp_svg_value_is(tp_svg_value value, const char *word) {
  return value.text != NULL && value.length == strlen(word) &&
         strncasecmp(value.text, word, value.length) == 0;
}

bool tp_svg_value_is_zero(tp_svg_value value) {
  if (value.text == NULL) return false;
  tp_svg_text text = {value.text, value.text + value.length, NULL};
  fmpq_t number;
  fmpq_init(number);
  const bool zero = tp_svg_number(&text, number) && fmpq_sgn(number) <= 0;
  fmpq_clear(number);
  return zero;
}

static bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f';
}

tp_svg_value tp_svg_trim(tp_svg_value value) {
  while (value.length > 0 && is_blank(*value.text)) {
    value.text++;
    value.length--;
  }
  while (value.length > 0 && is_blank(value.text[value.length - 1])) value.length--;
  return value;
}

/* ---- declarations ------------------------------------------------------------------------------
 */

size_t tp_svg_until(tp_svg_value text, const char *ends) {
  int depth = 0;
  char quote = '\0';
  for (size_t k = 0; k < text.length; k++) {
    const char c = text.text[k];
    if (quote != '\0') {
      if (c == '\\') k++;
      if (c == quote) quote = '\0';
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (depth == 0 && strchr(ends, c) != NULL) {
      return k;
    } else if (c == '(') {
      depth++;
    } else if (c == ')' && depth > 0) {
      depth--;
    }
  }
  return text.length;
}

/* "… !important" without that. */
static bool take_important(tp_svg_value *value) {
  static const char word[] = "important";
  const size_t length = sizeof word - 1;
  if (value->length <= length ||
      strncasecmp(value->text + value->length - length, word, length) != 0) {
    return false;
  }
  const tp_svg_value before = tp_svg_trim((tp_svg_value){value->text, value->length - length});
  if (before.length == 0 || before.text[before.length - 1] != '!') return false;
  *value = tp_svg_trim((tp_svg_value){before.text, before.length - 1});
  return true;
}

bool tp_svg_next_declaration(tp_svg_declaration *own, tp_svg_value *text) {
  while (text->length > 0) {
    const size_t end = tp_svg_until(*text, ";");
    const tp_svg_value whole = {text->text, end};
    const size_t used = end + (end < text->length ? 1 : 0);
    text->text += used;
    text->length -= used;
    const size_t colon = tp_svg_until(whole, ":");
    if (colon == whole.length) continue;
    const tp_svg_value name = tp_svg_trim((tp_svg_value){whole.text, colon});
    own->value = tp_svg_trim((tp_svg_value){whole.text + colon + 1, whole.length - colon - 1});
    own->important = take_important(&own->value);
    for (int k = 0; k < TP_SVG_PROPERTIES; k++) {
      if (!tp_svg_value_is(name, names[k])) continue;
      own->property = k;
      return true;
    }
  }
  return false;
}
