/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Reader of one sign at a time: letters, numbers, operators, names, groups in braces, indices and
 * exponents. */

#include "document/math.h"

#include <string.h>

static bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

static bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

static size_t character_length(const char *at) {
  size_t length = 1;
  while (((unsigned char)at[length] & 0xC0) == 0x80) length++;
  return length;
}

static bool begins(const char *at, const char *end, const char *word) {
  const size_t length = strlen(word);
  return (size_t)(end - at) >= length && memcmp(at, word, length) == 0;
}

/* Before decimals, not between numbers, where a blank follows. */
static bool is_comma(const char *at, const char *end) {
  return *at == ',' && end - at > 1 && is_digit(at[1]);
}

/* "1.5e-07°" */
static size_t number_length(const char *at, const char *end) {
  const char *from = at;
  while (at < end && (is_digit(*at) || *at == '.' || is_comma(at, end))) at++;
  if (end - at > 2 && *at == 'e' && (at[1] == '-' || at[1] == '+') && is_digit(at[2])) {
    at += 2;
    while (at < end && is_digit(*at)) at++;
  }
  if (begins(at, end, "°")) at += strlen("°");
  return (size_t)(at - from);
}

/* What stands between the braces at `at`, and the step past them. */
static tp_math_sign read_group(tp_math_kind kind, const char **at, const char *end) {
  const char *from = *at + 1, *to = from;
  for (int depth = 1; to < end; to++) {
    depth += *to == '{' ? 1 : *to == '}' ? -1 : 0;
    if (depth == 0) break;
  }
  *at = to < end ? to + 1 : to;
  return (tp_math_sign){kind, from, (size_t)(to - from)};
}

static tp_math_sign read_name(const char **at, const char *end) {
  const char *from = *at + 1, *to = from;
  while (to < end && is_letter(*to)) to++;
  if (to == from) { /* two strokes */
    *at = to < end ? to + 1 : to;
    return (tp_math_sign){TP_MATH_LINE, from, 0};
  }
  const size_t length = (size_t)(to - from);
  *at = to;
  if (begins(from, to, "frac")) return (tp_math_sign){TP_MATH_FRACTION, from, length};
  if (begins(from, to, "bar")) return (tp_math_sign){TP_MATH_BAR, from, length};
  if (begins(from, to, "sum")) return (tp_math_sign){TP_MATH_OPERATOR, "∑", strlen("∑")};
  if (begins(from, to, "text")) return read_group(TP_MATH_WORDS, at, end);
  return (tp_math_sign){TP_MATH_FUNCTION, from, length};
}

static tp_math_kind kind_of(const char *at, size_t length) {
  static const char *const operators[] = {"−", "·", "±", "≤", "≥", "≈", "×"};
  for (size_t k = 0; k < sizeof operators / sizeof operators[0]; k++) {
    if (strlen(operators[k]) == length && memcmp(operators[k], at, length) == 0) {
      return TP_MATH_OPERATOR;
    }
  }
  return length > 1 || is_letter(*at) ? TP_MATH_LETTER : TP_MATH_OPERATOR;
}

tp_math_sign tp_math_next(const char **at, const char *end) {
  while (*at < end && **at == ' ') ++*at;
  const char *from = *at;
  if (from >= end) return (tp_math_sign){TP_MATH_END, end, 0};
  if (*from == '\\') return read_name(at, end);
  if (*from == '{') return read_group(TP_MATH_GROUP, at, end);
  size_t length = is_digit(*from) ? number_length(from, end) : character_length(from);
  *at += length;
  if (*from == '_' || *from == '^') {
    return (tp_math_sign){*from == '_' ? TP_MATH_BELOW : TP_MATH_ABOVE, from, 1};
  }
  return (tp_math_sign){is_digit(*from) ? TP_MATH_NUMBER : kind_of(from, length), from, length};
}

bool tp_math_follows(const char *at, const char *end, tp_math_kind kind) {
  return tp_math_next(&at, end).kind == kind;
}
