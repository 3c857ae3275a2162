/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Cursor over the bytes of a file with line and column; words, lines, decimals as exact rationals,
 * and binary integers and floats of either byte order. */

#include "format/mesh_source.h"

#include "number/ratio.h"
#include "number/word.h"

#include <limits.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

tp_status tp_mesh_source_init(tp_mesh_source *source, const char *path, const char *bytes,
                              size_t length, tp_message *message) {
  *source = (tp_mesh_source){.path = path,
                             .at = bytes,
                             .end = bytes + length,
                             .line_start = bytes,
                             .line = 1,
                             .message = message};
  const bool wide = length >= 2 && ((bytes[0] == '\xff' && bytes[1] == '\xfe') ||
                                    (bytes[0] == '\xfe' && bytes[1] == '\xff'));
  if (wide) {
    return tp_mesh_fail_file(source, "this text is in UTF-16; save it as UTF-8 or plain ASCII");
  }
  if (length >= 3 && memcmp(bytes, "\xef\xbb\xbf", 3) == 0) source->at += 3;
  return TP_OK;
}

/* ---- words -------------------------------------------------------------------------------------
 */

static bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

static tp_mesh_word word_from(const tp_mesh_source *source, const char *from, const char *to) {
  return (tp_mesh_word){from, (size_t)(to - from), source->line,
                        (int)(from - source->line_start) + 1};
}

tp_mesh_word tp_mesh_line_word(tp_mesh_source *source) {
  while (source->at < source->end && is_blank(*source->at)) source->at++;
  const char *from = source->at;
  while (source->at < source->end && !is_blank(*source->at) && *source->at != '\n') source->at++;
  return word_from(source, from, source->at);
}

bool tp_mesh_next_line(tp_mesh_source *source) {
  const char *newline = memchr(source->at, '\n', (size_t)(source->end - source->at));
  source->at = newline != NULL ? newline + 1 : source->end;
  if (newline == NULL || source->line == INT_MAX) return false;
  source->line_start = source->at;
  source->line++;
  return true;
}

tp_mesh_word tp_mesh_file_word(tp_mesh_source *source) {
  tp_mesh_word word = tp_mesh_line_word(source);
  while (word.length == 0 && tp_mesh_next_line(source)) word = tp_mesh_line_word(source);
  return word;
}

tp_mesh_word tp_mesh_rest_of_line(tp_mesh_source *source) {
  while (source->at < source->end && is_blank(*source->at)) source->at++;
  const char *from = source->at;
  const char *newline = memchr(from, '\n', (size_t)(source->end - from));
  source->at = newline != NULL ? newline : source->end;
  const char *to = source->at;
  while (to > from && is_blank(to[-1])) to--;
  return word_from(source, from, to);
}

bool tp_mesh_word_is(tp_mesh_word word, const char *text) {
  if (strlen(text) != word.length) return false;
  for (size_t k = 0; k < word.length; k++) {
    const char c = word.text[k];
    if ((c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c) != text[k]) return false;
  }
  return true;
}

/* ---- complaints --------------------------------------------------------------------------------
 */

tp_status tp_mesh_fail_word(const tp_mesh_source *source, tp_mesh_word word, const char *what) {
  return tp_refuse(source->message, TP_FAULT_FORMAT,
                   (tp_place){source->path, word.line, word.column}, "%s", what);
}

tp_status tp_mesh_fail_line(const tp_mesh_source *source, const char *what) {
  return tp_mesh_fail_word(source, word_from(source, source->at, source->at), what);
}

tp_status tp_mesh_fail_file(const tp_mesh_source *source, const char *format, ...) {
  char what[200];
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(what, sizeof what, format, arguments);
  va_end(arguments);
  return tp_refuse(source->message, TP_FAULT_FORMAT, (tp_place){source->path, 0, 0}, "%s", what);
}

/* ---- numbers -----------------------------------------------------------------------------------
 */

tp_status tp_mesh_read_coordinate(fmpq_t value, const tp_mesh_source *source, tp_mesh_word word) {
  const char *problem = NULL;
  char start[16] = "", what[160];
  if (word.length == 0) {
    return tp_mesh_fail_word(source, word, "a coordinate is missing; a vertex has x, y and z");
  }
  if (tp_ratio_read_field(value, word.text, word.length, &problem)) return TP_OK;
  strncat(start, word.text, word.length < 15 ? word.length : 15);
  if (tp_ratio_is_not_finite(start)) {
    return tp_mesh_fail_word(source, word,
                             "a coordinate that is not a finite number; repair the mesh");
  }
  if (memchr(word.text, ',', word.length) != NULL) {
    return tp_mesh_fail_word(source, word,
                             "a comma within a number; write decimals with a point, 1.5 for 1,5");
  }
  snprintf(what, sizeof what, "this entry %s; a vertex has x, y and z", problem);
  return tp_mesh_fail_word(source, word, what);
}

bool tp_mesh_read_whole(long *value, tp_mesh_word word) {
  size_t k = word.length > 0 && (word.text[0] == '-' || word.text[0] == '+');
  int64_t sum = 0;
  if (k == word.length || word.length > 18) return false;
  for (; k < word.length; k++) {
    if (word.text[k] < '0' || word.text[k] > '9') return false;
    sum = 10 * sum + (word.text[k] - '0');
  }
  if (sum > LONG_MAX) return false;
  *value = (long)(word.text[0] == '-' ? -sum : sum);
  return true;
}

bool tp_mesh_set_double(fmpq_t value, double number) {
  int exponent = 0;
  if (!isfinite(number)) return false;
  int64_t mantissa = (int64_t)ldexp(frexp(number, &exponent), 53);
  exponent -= 53;
  while (mantissa != 0 && mantissa % 2 == 0) mantissa /= 2, exponent++;
  tp_word_set(fmpq_numref(value), mantissa);
  fmpz_one(fmpq_denref(value));
  if (mantissa == 0) return true;
  fmpz *const side = exponent < 0 ? fmpq_denref(value) : fmpq_numref(value);
  fmpz_mul_2exp(side, side, (unsigned long)(exponent < 0 ? -exponent : exponent));
  return true;
}

uint64_t tp_mesh_bits(const char *bytes, int count, bool little) {
  uint64_t bits = 0;
  for (int k = 0; k < count; k++) {
    bits = bits << 8 | (unsigned char)bytes[little ? count - 1 - k : k];
  }
  return bits;
}

float tp_mesh_float(uint64_t bits) {
  const uint32_t own = (uint32_t)bits;
  float number = 0;
  memcpy(&number, &own, sizeof number);
  return number;
}

double tp_mesh_double(uint64_t bits) {
  double number = 0;
  memcpy(&number, &bits, sizeof number);
  return number;
}
