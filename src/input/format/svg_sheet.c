/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Parser of CSS style sheets: selectors of elements, classes and ids with their specificity, and
 * rules that bear on an outline; other at-rules are refused. */

#include "format/svg_sheet.h"

#include "common/grow.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

/* ---- selectors ---------------------------------------------------------------------------------
 */

static bool is_name(char c) {
  return isalnum((unsigned char)c) || c == '-' || c == '_' || (unsigned char)c >= 0x80;
}

/* One of an element, classes and an id alone, as "path.seam"? And how closely it names one: ids
 * before classes before elements. */
static bool weigh(tp_svg_value selector, long *weight) {
  enum { CLASS = 1 << 6, ID = 1 << 12, MOST = 60 };
  size_t k = 0;
  int parts = 0;
  *weight = 0;
  if (selector.length > 0 && selector.text[0] == '*') k = 1;
  while (k < selector.length && parts++ < MOST) {
    const char c = selector.text[k];
    if (c == '.' || c == '#') k++;
    const size_t from = k;
    while (k < selector.length && is_name(selector.text[k])) k++;
    if (k == from || (c != '.' && c != '#' && from > 0)) return false;
    *weight += c == '.' ? CLASS : c == '#' ? ID : 1;
  }
  return selector.length > 0 && k == selector.length;
}

static bool is_word(const char *word, size_t length, const char *text) {
  return text != NULL && strlen(text) == length && strncmp(word, text, length) == 0;
}

static bool has_class(const char *word, size_t length, const char *classes) {
  static const char blanks[] = " \t\r\n\f";
  for (const char *at = classes; at != NULL && *at != '\0';) {
    at += strspn(at, blanks);
    const size_t own = strcspn(at, blanks);
    if (own == length && strncmp(word, at, length) == 0) return true;
    at += own;
  }
  return false;
}

bool tp_svg_rule_is_of(const tp_svg_rule *rule, const tp_svg_element *element) {
  const char *at = rule->text;
  if (*at == '*') at++;
  while (*at != '\0') {
    const char kind = *at;
    if (kind == '.' || kind == '#') at++;
    const size_t length = strcspn(at, ".#");
    const bool is_of = kind == '.'   ? has_class(at, length, element->classes)
                       : kind == '#' ? is_word(at, length, element->id)
                                     : is_word(at, length, element->name);
    if (!is_of) return false;
    at += length;
  }
  return true;
}

/* ---- rules -------------------------------------------------------------------------------------
 */

/* Would it hide, move or shape an element that it is of? */
static bool bears(const tp_svg_declaration *d) {
  switch (d->property) {
  case TP_SVG_DISPLAY:
    return tp_svg_value_is(d->value, "none");
  case TP_SVG_VISIBILITY:
    return !tp_svg_value_is(d->value, "visible");
  case TP_SVG_OPACITY:
    return tp_svg_value_is_zero(d->value);
  case TP_SVG_FILL:
  case TP_SVG_FILL_OPACITY:
  case TP_SVG_STROKE:
  case TP_SVG_STROKE_OPACITY:
  case TP_SVG_STROKE_WIDTH:
    return false;
  default:
    return !tp_svg_value_is(d->value, "none");
  }
}

static bool add_rule(tp_svg_sheets *sheets, tp_svg_value selector, const tp_svg_declaration *d,
                     long weight) {
  tp_svg_rule *rules = tp_grow(sheets->rules, sheets->count, &sheets->room, sizeof *rules);
  if (rules == NULL) return false;
  sheets->rules = rules;
  char *text = calloc(1, selector.length + d->value.length + 2);
  if (text == NULL) return false;
  memcpy(text, selector.text, selector.length);
  char *value = text + selector.length + 1;
  memcpy(value, d->value.text, d->value.length);
  tp_svg_rule *own = rules + sheets->count++;
  *own = (tp_svg_rule){text, *d, weight};
  own->declaration.value.text = value;
  return true;
}

typedef struct sheet {
  tp_svg_sheets *sheets;
  tp_svg_value rest;
  const char *problem;
  const char *where; /* of the problem */
  bool no_memory;
} sheet;

static bool refuse(sheet *s, const char *where, const char *problem) {
  s->where = where;
  s->problem = problem;
  return false;
}

static void step(sheet *s, size_t by) {
  s->rest.text += by;
  s->rest.length -= by;
}

static bool add_rules(sheet *s, tp_svg_value selector, tp_svg_value block) {
  long weight = 0;
  const bool told = weigh(selector, &weight);
  for (tp_svg_declaration d; tp_svg_next_declaration(&d, &block);) {
    if (!told && bears(&d)) {
      return refuse(s, selector.text,
                    "this rule of a style sheet hides, moves or shapes what it selects, and its "
                    "selector is not one of elements, classes and ids alone; write the property "
                    "at the elements themselves, or save as plain SVG");
    }
    if (told && !add_rule(s->sheets, selector, &d, weight)) {
      s->no_memory = true;
      return false;
    }
  }
  return true;
}

/* "path, .seam { … }" */
static bool read_rule(sheet *s) {
  const size_t open = tp_svg_until(s->rest, "{");
  tp_svg_value selectors = {s->rest.text, open};
  if (open == s->rest.length) {
    return refuse(s, selectors.text, "a style sheet that ends within a rule");
  }
  step(s, open + 1);
  const size_t close = tp_svg_until(s->rest, "{}");
  const tp_svg_value block = {s->rest.text, close};
  if (close == s->rest.length || s->rest.text[close] == '{') {
    return refuse(s, selectors.text,
                  "a rule of a style sheet that does not end, or with rules in it, which are not "
                  "read; save as plain SVG");
  }
  step(s, close + 1);
  while (selectors.length > 0) {
    const size_t end = tp_svg_until(selectors, ",");
    if (!add_rules(s, tp_svg_trim((tp_svg_value){selectors.text, end}), block)) return false;
    const size_t used = end + (end < selectors.length ? 1 : 0);
    selectors.text += used;
    selectors.length -= used;
  }
  return true;
}

static bool begins(tp_svg_value text, const char *word) {
  const size_t length = strlen(word);
  return text.length >= length && strncasecmp(text.text, word, length) == 0;
}

/* Fonts and alphabets bear on no outline; all else that begins with '@' is another file's, or holds
 * under conditions. */
static bool read_at_rule(sheet *s) {
  if (!begins(s->rest, "@charset") && !begins(s->rest, "@namespace") &&
      !begins(s->rest, "@font-face")) {
    return refuse(s, s->rest.text,
                  "a rule of a style sheet that begins with '@', as of another file or under a "
                  "condition, is not read; save as plain SVG");
  }
  const size_t end = tp_svg_until(s->rest, ";{");
  const bool block = end < s->rest.length && s->rest.text[end] == '{';
  step(s, end + (end < s->rest.length ? 1 : 0));
  if (block) {
    const size_t close = tp_svg_until(s->rest, "}");
    step(s, close + (close < s->rest.length ? 1 : 0));
  }
  return true;
}

/* Comments, and the marks of one around all of a sheet, become blanks. */
static void blank_comments(char *text) {
  for (char *at = text; (at = strstr(at, "/*")) != NULL;) {
    char *end = strstr(at + 2, "*/");
    end = end != NULL ? end + 2 : at + strlen(at);
    for (; at < end; at++) {
      if (*at != '\n') *at = ' ';
    }
  }
  for (char *at = text; (at = strstr(at, "<!--")) != NULL;) memset(at, ' ', strlen("<!--"));
  for (char *at = text; (at = strstr(at, "-->")) != NULL;) memset(at, ' ', strlen("-->"));
}

static bool read_all(sheet *s) {
  for (;;) {
    while (s->rest.length > 0 && isspace((unsigned char)*s->rest.text)) step(s, 1);
    if (s->rest.length == 0) return true;
    if (!(*s->rest.text == '@' ? read_at_rule(s) : read_rule(s))) return false;
  }
}

tp_svg_sheet_outcome tp_svg_sheets_add(tp_svg_sheets *sheets, const char *text,
                                       const char **problem, size_t *at) {
  char *own = strdup(text);
  if (own == NULL) return TP_SVG_SHEET_NO_MEMORY;
  blank_comments(own);
  sheet s = {.sheets = sheets, .rest = {own, strlen(own)}};
  const bool done = read_all(&s);
  *problem = s.problem;
  *at = s.where != NULL ? (size_t)(s.where - own) : 0;
  free(own);
  if (done) return TP_SVG_SHEET_DONE;
  return s.no_memory ? TP_SVG_SHEET_NO_MEMORY : TP_SVG_SHEET_REFUSED;
}

void tp_svg_sheets_clear(tp_svg_sheets *sheets) {
  for (long k = 0; k < sheets->count; k++) free(sheets->rules[k].text);
  free(sheets->rules);
  *sheets = (tp_svg_sheets){NULL, 0, 0};
}
