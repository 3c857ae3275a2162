/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Stack of brackets with the layout of each; separators and line ends are written before every
 * value, and misuse is recorded. */

#include "output/json.h"

#include "output/encode.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static void add(tp_json *j, const char *text) {
  tp_text_append(&j->text, text, strlen(text));
}

static void begin_line(tp_json *j, int indent) {
  tp_text_add(&j->text, "\n%*s", indent, "");
  j->indent = indent;
}

static bool begins_line(const tp_json *j, const tp_json_bracket *within) {
  if (j->next != TP_JSON_BY_LAYOUT) return j->next == TP_JSON_ON_NEXT_LINE;
  return within->layout == TP_JSON_LIST || within->layout == TP_JSON_BLOCK;
}

/* All that stands before a value. False where it may not stand. */
static bool begin_value(tp_json *j, const char *key) {
  tp_json_bracket *within = j->depth > 0 ? j->brackets + j->depth - 1 : NULL;
  const bool keyed = within != NULL && within->is_object;
  const bool second = within == NULL && j->text.length > 0;
  if (keyed != (key != NULL) || second) j->wrong = true;
  if (j->wrong) return false;
  if (within != NULL) {
    const bool line = begins_line(j, within);
    if (within->has_members) add(j, line ? "," : ", ");
    if (line) begin_line(j, within->inner);
    within->has_members = true;
  }
  j->next = TP_JSON_BY_LAYOUT;
  if (keyed) {
    tp_encode_json(&j->text, key);
    add(j, ": ");
  }
  return true;
}

static void open_bracket(tp_json *j, const char *key, bool is_object, tp_json_layout layout) {
  static const int deeper[] = {[TP_JSON_LINE] = 2,
                               [TP_JSON_ALIGNED] = 1,
                               [TP_JSON_FLUSH] = 0,
                               [TP_JSON_LIST] = 2,
                               [TP_JSON_BLOCK] = 2};
  if (j->depth == TP_JSON_DEEPEST) j->wrong = true;
  if (!begin_value(j, key)) return;
  add(j, is_object ? "{" : "[");
  j->brackets[j->depth++] = (tp_json_bracket){.is_object = is_object,
                                              .layout = layout,
                                              .outer = j->indent,
                                              .inner = j->indent + deeper[layout]};
}

void tp_json_object(tp_json *j, const char *key, tp_json_layout layout) {
  open_bracket(j, key, true, layout);
}

void tp_json_array(tp_json *j, const char *key, tp_json_layout layout) {
  open_bracket(j, key, false, layout);
}

void tp_json_close(tp_json *j) {
  if (j->depth == 0) j->wrong = true;
  if (j->wrong) return;
  const tp_json_bracket *within = j->brackets + --j->depth;
  if (within->layout == TP_JSON_BLOCK) begin_line(j, within->outer);
  add(j, within->is_object ? "}" : "]");
  j->indent = within->outer;
  j->next = TP_JSON_BY_LAYOUT;
}

void tp_json_break(tp_json *j) {
  j->next = TP_JSON_ON_NEXT_LINE;
}

void tp_json_beside(tp_json *j) {
  j->next = TP_JSON_ON_SAME_LINE;
}

/* A value that is written as it is. */
static void add_token(tp_json *j, const char *key, const char *token) {
  if (begin_value(j, key)) add(j, token);
}

void tp_json_string(tp_json *j, const char *key, const char *text) {
  if (text == NULL) {
    tp_json_null(j, key);
  } else if (begin_value(j, key)) {
    tp_encode_json(&j->text, text);
  }
}

void tp_json_truth(tp_json *j, const char *key, bool value) {
  add_token(j, key, value ? "true" : "false");
}

void tp_json_null(tp_json *j, const char *key) {
  add_token(j, key, "null");
}

void tp_json_count(tp_json *j, const char *key, size_t value) {
  if (begin_value(j, key)) tp_text_add(&j->text, "%zu", value);
}

void tp_json_integer(tp_json *j, const char *key, long value) {
  if (begin_value(j, key)) tp_text_add(&j->text, "%ld", value);
}

static size_t digits_at(const char *text) {
  return strspn(text, "0123456789");
}

/* number = [ "-" ] int [ "." digits ] [ ( "e" / "E" ) [ "+" / "-" ] digits ], no zero before other
 * digits (RFC 8259, section 6). */
static bool is_number(const char *text) {
  text += *text == '-';
  const size_t whole = digits_at(text);
  if (whole == 0 || (whole > 1 && *text == '0')) return false;
  text += whole;
  if (*text == '.') {
    const size_t decimals = digits_at(++text);
    if (decimals == 0) return false;
    text += decimals;
  }
  if (*text == 'e' || *text == 'E') {
    text++;
    text += *text == '+' || *text == '-';
    const size_t power = digits_at(text);
    if (power == 0) return false;
    text += power;
  }
  return *text == '\0';
}

void tp_json_printed(tp_json *j, const char *key, const char *number) {
  if (!is_number(number)) j->wrong = true;
  add_token(j, key, number);
}

/* What stands between the digits of a number is the locale's, of any length. */
static void put_point(char *printed) {
  char *mark = printed + strspn(printed, "-0123456789");
  if (*mark == '\0' || *mark == 'e') return;
  const char *behind = strpbrk(mark, "0123456789");
  if (behind == NULL) return;
  *mark = '.';
  memmove(mark + 1, behind, strlen(behind) + 1);
}

enum { PRINTED_SIZE = 400 }; /* the greatest double has 309 digits before its decimals */

static void add_number(tp_json *j, const char *key, char *printed, int length) {
  if (length < 0 || length >= PRINTED_SIZE) {
    j->wrong = true;
    return;
  }
  put_point(printed);
  tp_json_printed(j, key, printed);
}

void tp_json_double(tp_json *j, const char *key, double value) {
  tp_json_significant(j, key, value, 17);
}

void tp_json_significant(tp_json *j, const char *key, double value, int digits) {
  char printed[PRINTED_SIZE];
  if (isfinite(value)) {
    add_number(j, key, printed, snprintf(printed, sizeof printed, "%.*g", digits, value));
  } else {
    tp_json_null(j, key);
  }
}

void tp_json_fixed(tp_json *j, const char *key, double value, int decimals) {
  char printed[PRINTED_SIZE];
  if (isfinite(value)) {
    add_number(j, key, printed, snprintf(printed, sizeof printed, "%.*f", decimals, value));
  } else {
    tp_json_null(j, key);
  }
}

void tp_json_bounded(tp_json *j, const char *key, tp_bounded number) {
  if (!isfinite(number.error)) {
    tp_json_null(j, key);
    return;
  }
  tp_json_object(j, key, TP_JSON_LINE);
  tp_json_double(j, "value", number.value);
  tp_json_double(j, "error", number.error);
  if (number.digits != NULL) tp_json_string(j, "digits", number.digits);
  tp_json_close(j);
}

void tp_json_report(tp_json *j) {
  tp_json_object(j, NULL, TP_JSON_BLOCK);
  tp_json_string(j, "topple", TP_VERSION);
}

tp_status tp_json_finish(tp_json *j, char **result) {
  const bool whole = !j->wrong && j->depth == 0 && j->text.length > 0;
  if (!whole && !j->text.failed) {
    tp_text_drop(&j->text);
    return TP_SYSTEM_FAILED;
  }
  add(j, "\n");
  return tp_text_finish(&j->text, result);
}
