/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The one writer of JSON (RFC 8259). It keeps the objects and arrays that are open, and puts
 * brackets, commas, colons and line ends itself, so that what is printed is well-formed. What JSON
 * has no place for (a member of an object without a key, a key anywhere else, a second value of the
 * whole, a close of nothing, a printed number that is none) ends the writing, and tp_json_finish
 * says so. Every key and every text goes through the encoder; numbers have a point whatever the
 * locale. A value costs its own length; nesting is bounded by TP_JSON_DEEPEST. */

#ifndef TP_OUTPUT_JSON_H
#define TP_OUTPUT_JSON_H

#include "output/text.h"

/* How the members of an object or of an array stand. A line that begins within brackets is
 * indented against the line on which they open. */
typedef enum tp_json_layout {
  TP_JSON_LINE,    /* on one line; two deeper where tp_json_break begins another */
  TP_JSON_ALIGNED, /* the same, one deeper: below the first member */
  TP_JSON_FLUSH,   /* the same, as deep as the line of the bracket */
  TP_JSON_LIST,    /* each on a line of its own, two deeper; the bracket closes behind the last */
  TP_JSON_BLOCK    /* each on a line of its own, two deeper; the bracket closes on one of its own */
} tp_json_layout;

enum { TP_JSON_DEEPEST = 12 };

typedef struct tp_json_bracket {
  bool is_object, has_members;
  tp_json_layout layout;
  int outer, inner; /* indents: of the line of the bracket, of lines within */
} tp_json_bracket;

typedef enum tp_json_position {
  TP_JSON_BY_LAYOUT,
  TP_JSON_ON_NEXT_LINE,
  TP_JSON_ON_SAME_LINE
} tp_json_position;

/* Begin with {0}. */
typedef struct tp_json {
  tp_text text;
  tp_json_bracket brackets[TP_JSON_DEEPEST];
  int depth;
  int indent;            /* of the present line */
  tp_json_position next; /* of the next member */
  bool wrong;
} tp_json;

/* Open an object or an array, and close the one that was opened last. The key is NULL in an array,
 * and of the whole; so it is below. */
void tp_json_object(tp_json *json, const char *key, tp_json_layout layout);
void tp_json_array(tp_json *json, const char *key, tp_json_layout layout);
void tp_json_close(tp_json *json);

/* Where the next member stands: on a line of its own, or beside the one before. */
void tp_json_break(tp_json *json);
void tp_json_beside(tp_json *json);

void tp_json_string(tp_json *json, const char *key, const char *text); /* null for NULL */
void tp_json_truth(tp_json *json, const char *key, bool value);
void tp_json_null(tp_json *json, const char *key);
void tp_json_count(tp_json *json, const char *key, size_t value);
void tp_json_integer(tp_json *json, const char *key, long value);

/* A number as it is printed elsewhere: exact decimals stay. */
void tp_json_printed(tp_json *json, const char *key, const char *number);

/* A double with all its digits, with so many significant digits, with so many decimals; null for
 * one that is not finite. */
void tp_json_double(tp_json *json, const char *key, double value);
void tp_json_significant(tp_json *json, const char *key, double value, int digits);
void tp_json_fixed(tp_json *json, const char *key, double value, int decimals);

/* A computed number, {"value": v, "error": e}, with its digits where more were asked for than a
 * double holds; null where it lies outside the range of a double. */
void tp_json_bounded(tp_json *json, const char *key, tp_bounded number);

/* Hand the text over, ended by a line end. TP_OUT_OF_MEMORY, or TP_SYSTEM_FAILED where the calls
 * made no JSON or left something open. */
TP_MUST_USE tp_status tp_json_finish(tp_json *json, char **result);

/* Open the object of a whole report, which begins with the version of Topple. */
void tp_json_report(tp_json *json);

#endif
