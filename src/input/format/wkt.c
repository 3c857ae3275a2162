/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/*   geometries = {geometry [";" | ","]}
 *   geometry   = ["SRID=" number ";"] WORD ["Z" | "M" | "ZM"] ("EMPTY" | body)
 *   body       = "(" position {"," position} ")" | "(" body {"," body} ")"
 * How deep the positions lie says what they are, as the word does. */

#include "format/wkt.h"

#include "common/outside.h"
#include "format/standing.h"
#include "number/ratio.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>

enum { NUMBERS = 4, WORD = 32 };

typedef struct reader {
  tp_drawing *drawing;
  const char *text;
  size_t length, at;
  int line;
  size_t line_start;
  tp_message *message;
  fmpq numbers[NUMBERS];
  fmpq_t height;
} reader;

/* How positions of a geometry are nested, and what they are. */
typedef struct shape {
  const char *word, *kind;
  int depth; /* of brackets around a position */
  bool polygon;
} shape;

static tp_mark mark_here(const reader *r) {
  return (tp_mark){r->line, (int)(r->at - r->line_start) + 1};
}

static tp_status fail(const reader *r, const char *what) {
  const tp_mark mark = mark_here(r);
  return tp_refuse(r->message, TP_FAULT_FORMAT,
                   (tp_place){r->drawing->path, mark.line, mark.column}, "%s", what);
}

static void skip_blanks(reader *r) {
  for (; r->at < r->length && isspace((unsigned char)r->text[r->at]); r->at++) {
    if (r->text[r->at] != '\n') continue;
    r->line++;
    r->line_start = r->at + 1;
  }
}

static bool take(reader *r, char c) {
  skip_blanks(r);
  if (r->at == r->length || r->text[r->at] != c) return false;
  r->at++;
  return true;
}

/* A word of letters; empty where there is none. */
static void take_word(reader *r, char *word) {
  size_t length = 0;
  skip_blanks(r);
  while (r->at < r->length && isalpha((unsigned char)r->text[r->at])) {
    if (length + 1 < WORD) word[length++] = r->text[r->at];
    r->at++;
  }
  word[length] = '\0';
}

static bool starts_number(const reader *r) {
  return r->at < r->length &&
         (isdigit((unsigned char)r->text[r->at]) || strchr("+-.", r->text[r->at]) != NULL);
}

static tp_status take_number(reader *r, fmpq_t value) {
  size_t end = r->at;
  while (end < r->length && (isalnum((unsigned char)r->text[end]) ||
                             (r->text[end] != '\0' && strchr("+-.", r->text[end]) != NULL))) {
    end++;
  }
  const char *problem = "is not a number";
  if (!tp_ratio_read_field(value, r->text + r->at, end - r->at, &problem)) {
    char what[120];
    snprintf(what, sizeof what, "this entry %s; a position is x y", problem);
    return fail(r, what);
  }
  r->at = end;
  return TP_OK;
}

/* x y [z [m]] */
static tp_status take_position(reader *r, tp_drawing_object *object, bool first, bool has_height) {
  const tp_mark mark = mark_here(r);
  int count = 0;
  for (skip_blanks(r); starts_number(r) && count < NUMBERS; skip_blanks(r)) {
    const tp_status status = take_number(r, r->numbers + count++);
    if (status != TP_OK) return status;
  }
  if (count < 2) return fail(r, "a position is x y; decimals take a point, not a comma");
  const bool high = count == NUMBERS || (count == 3 && has_height);
  if (!high) fmpq_zero(r->numbers + 2);
  if (first) fmpq_set(r->height, r->numbers + 2);
  if (r->drawing->standing == NULL && !fmpq_equal(r->height, r->numbers + 2)) {
    object->problem = "has a z that changes along it; a section is drawn in x and y, so give it "
                      "these two alone";
  }
  return tp_drawing_add_in_space(r->drawing, object, r->numbers, r->numbers + 1, r->numbers + 2,
                                 mark)
             ? TP_OK
             : tp_fail_memory(r->message, "a drawing");
}

/* (position, …), a ring or a line; of points nothing is kept. */
static tp_status take_chain(reader *r, const shape *s, long *outer, bool has_height) {
  tp_drawing_object *object = tp_drawing_add(r->drawing, s->kind, NULL, NULL, mark_here(r));
  if (object == NULL) return tp_fail_memory(r->message, "a drawing");
  if (!take(r, '(')) return fail(r, "a bracket '(' is missing here");
  tp_status status = TP_OK;
  do {
    skip_blanks(r);
    const bool bracket = take(r, '('); /* points of MULTIPOINT may have brackets of their own */
    status = take_position(r, object, object->line.count == 0, has_height);
    if (status == TP_OK && bracket && !take(r, ')'))
      status = fail(r, "a bracket ')' is missing here");
  } while (status == TP_OK && take(r, ','));
  if (status == TP_OK && !take(r, ')')) {
    status = fail(r, "a comma or a bracket ')' is missing here; a position is x y, and decimals "
                     "take a point, not a comma");
  }
  if (status != TP_OK) return status;
  if (s->depth == 0) {
    tp_drawing_drop(r->drawing);
    return TP_OK;
  }
  tp_drawing_tidy(object);
  if (s->polygon) {
    object->closure = TP_DRAWING_CLOSED;
    object->ring_of = *outer;
    if (*outer < 0) *outer = r->drawing->count - 1;
  }
  return TP_OK;
}

/* As many brackets as the geometry has. */
static tp_status take_body(reader *r, const shape *s, int depth, long *outer, bool has_height) {
  if (depth <= 1) return take_chain(r, s, outer, has_height);
  if (!take(r, '(')) return fail(r, "a bracket '(' is missing here");
  tp_status status = TP_OK;
  do {
    long own = -1; /* each polygon of several has an outer ring of its own */
    const bool polygons = depth == 3;
    status = take_body(r, s, depth - 1, polygons ? &own : outer, has_height);
  } while (status == TP_OK && take(r, ','));
  if (status == TP_OK && !take(r, ')')) status = fail(r, "a bracket ')' is missing here");
  return status;
}

static const shape *find_shape(const char *word) {
  static const shape shapes[] = {{"POINT", "POINT", 0, false},
                                 {"MULTIPOINT", "MULTIPOINT", 0, false},
                                 {"LINESTRING", "LINESTRING", 1, false},
                                 {"LINEARRING", "LINEARRING", 1, false},
                                 {"MULTILINESTRING", "LINESTRING", 2, false},
                                 {"POLYGON", "POLYGON", 2, true},
                                 {"MULTIPOLYGON", "POLYGON", 3, true}};
  for (size_t k = 0; k < sizeof shapes / sizeof shapes[0]; k++) {
    if (strcasecmp(word, shapes[k].word) == 0) return shapes + k;
  }
  return NULL;
}

static tp_status fail_word(const reader *r, const char *word) {
  static const char *const curves[] = {"CIRCULARSTRING", "COMPOUNDCURVE", "CURVEPOLYGON",
                                       "MULTICURVE",     "MULTISURFACE",  "CURVE"};
  for (size_t k = 0; k < sizeof curves / sizeof curves[0]; k++) {
    if (strcasecmp(word, curves[k]) == 0) {
      return fail(r, "curves of WKT are not read; make lines of them first, or hand the outline "
                     "over as DXF, whose arcs are kept");
    }
  }
  return fail(r, "not a WKT geometry that Topple reads: LINESTRING, POLYGON, MULTILINESTRING, "
                 "MULTIPOLYGON");
}

static bool is_word(const char *word, const char *other) {
  return strcasecmp(word, other) == 0;
}

static tp_status take_geometry(reader *r) {
  char word[WORD], next[WORD];
  const size_t start = r->at;
  take_word(r, word);
  if (is_word(word, "SRID")) { /* SRID=2056; */
    while (r->at < r->length && r->text[r->at] != ';' && r->text[r->at] != '\n') r->at++;
    return TP_OK;
  }
  const size_t length = strlen(word);
  bool high = length > 2 && (word[length - 1] == 'Z' || word[length - 1] == 'z');
  if (find_shape(word) == NULL && high) word[length - 1] = '\0'; /* POLYGONZ */
  const shape *s = find_shape(word);
  if (s == NULL) {
    r->at = start;
    skip_blanks(r);
    return fail_word(r, word);
  }
  take_word(r, next);
  if (is_word(next, "Z") || is_word(next, "ZM") || is_word(next, "M")) {
    high = !is_word(next, "M");
    take_word(r, next);
  } else if (next[0] == '\0') {
    high = true; /* a third number that nothing names is z */
  }
  if (is_word(next, "EMPTY")) return TP_OK;
  if (next[0] != '\0') return fail(r, "Z, M, EMPTY or a bracket '(' belongs here");
  long outer = -1;
  return take_body(r, s, s->depth, &outer, high);
}

tp_status tp_wkt_read(tp_drawing *drawing, const tp_text_file *file,
                      const tp_drawing_options *options, tp_message *message) {
  (void)options; /* no curves */
  reader r = {.drawing = drawing,
              .text = file->text,
              .length = file->length,
              .line = 1,
              .message = message};
  for (int k = 0; k < NUMBERS; k++) fmpq_init(r.numbers + k);
  fmpq_init(r.height);
  tp_status status = TP_OK;
  for (skip_blanks(&r); r.at < r.length && status == TP_OK; skip_blanks(&r)) {
    status = take_geometry(&r);
    while (take(&r, ';') || take(&r, ',')) continue;
  }
  for (int k = 0; k < NUMBERS; k++) fmpq_clear(r.numbers + k);
  fmpq_clear(r.height);
  return status;
}
