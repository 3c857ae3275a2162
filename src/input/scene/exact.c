/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A double as mantissa times a power of two in lowest terms, a text by number/ratio.h; arrays of
 * points with a bound on their number. */

#include "scene/exact.h"

#include "common/outside.h"
#include "number/ratio.h"
#include "number/word.h"
#include "scene/check.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

tp_exact tp_exact_of(double value) {
  return (tp_exact){.value = value};
}

tp_exact tp_exact_text(const char *text) {
  /* no text is no number, and no zero either */
  return (tp_exact){.value = text != NULL ? 0 : NAN, .text = text};
}

tp_coordinates tp_coordinates_of(const double *xy, size_t count) {
  return (tp_coordinates){.count = count, .xy = xy};
}

tp_coordinates tp_coordinates_text(const char *const *xy, size_t count) {
  return (tp_coordinates){.count = count, .texts = xy};
}

/* m 2^e; the bits of m that are zero at its end go into e, so that the fraction is in lowest terms.
 */
static void set_double(fmpq_t value, double given) {
  int exponent = 0;
  int64_t mantissa = (int64_t)ldexp(frexp(given, &exponent), 53);
  if (mantissa == 0) {
    fmpq_zero(value);
    return;
  }
  const int zeros = __builtin_ctzll((unsigned long long)mantissa);
  exponent += zeros - 53;
  mantissa /= INT64_C(1) << zeros;
  tp_word_set(fmpq_numref(value), mantissa);
  fmpz_one(fmpq_denref(value));
  if (exponent > 0) {
    fmpz_mul_2exp(fmpq_numref(value), fmpq_numref(value), (unsigned long)exponent);
  } else {
    fmpz_mul_2exp(fmpq_denref(value), fmpq_denref(value), (unsigned long)-exponent);
  }
}

static tp_status read_text(fmpq_t value, const char *text, const char *name, tp_place place,
                           tp_message *message) {
  const char *problem = NULL;
  if (tp_ratio_read_fraction(value, text, strlen(text), &problem)) {
    return tp_check_range(value, name, place, message);
  }
  return tp_refuse(message, TP_FAULT_FORMAT, place,
                   "%s: '%s' %s; write a decimal, as 0.1, or a fraction, as 1/3", name,
                   tp_quote_all(text).text, problem);
}

static tp_status read_double(fmpq_t value, double given, const char *name, tp_place place,
                             tp_message *message) {
  if (!isfinite(given)) {
    return tp_refuse(message, TP_FAULT_RANGE, place, "%s must be a finite number, not %s", name,
                     isnan(given) ? "nan"
                     : given > 0  ? "inf"
                                  : "-inf");
  }
  set_double(value, given);
  return tp_check_range(value, name, place, message);
}

tp_status tp_exact_read(fmpq_t value, tp_exact given, const char *name, const char *call,
                        tp_message *message) {
  const tp_place place = {call, 0, 0};
  return given.text != NULL ? read_text(value, given.text, name, place, message)
                            : read_double(value, given.value, name, place, message);
}

enum { MOST_POINTS = 100000000 };

static tp_status check_points(tp_coordinates given, const char *name, tp_place place,
                              tp_message *message) {
  if (given.xy == NULL && given.texts == NULL) {
    return tp_refuse(message, TP_FAULT_ARGUMENT, place, "the coordinates of '%s' must not be NULL",
                     name);
  }
  if (given.count > MOST_POINTS) {
    return tp_refuse(message, TP_FAULT_RANGE, place,
                     "'%s' has %zu points; at most 100 million are taken", name, given.count);
  }
  return TP_OK;
}

/* Coordinate `k` of them all. Its name is made only where it is told. */
static tp_status read_coordinate(fmpq_t value, tp_coordinates given, size_t k, const char *name,
                                 tp_place place, tp_message *message) {
  char text[128];
  const bool plain =
      given.texts == NULL && isfinite(given.xy[k]) &&
      (given.xy[k] == 0 || (fabs(given.xy[k]) >= 1e-308 && fabs(given.xy[k]) <= 1e308));
  if (plain) {
    set_double(value, given.xy[k]);
    return TP_OK;
  }
  snprintf(text, sizeof text, "%s of point %zu of %s", k % 2 == 0 ? "x" : "y", k / 2 + 1, name);
  if (given.texts == NULL) return read_double(value, given.xy[k], text, place, message);
  if (given.texts[k] == NULL) {
    return tp_refuse(message, TP_FAULT_ARGUMENT, place, "%s must not be NULL", text);
  }
  return read_text(value, given.texts[k], text, place, message);
}

tp_status tp_coordinates_read(tp_polyline *line, tp_coordinates given, bool closed,
                              const char *name, const char *call, long number,
                              tp_message *message) {
  tp_polyline points = {.file = call, .mark = {(int)number, 0}};
  tp_status status = check_points(given, name, (tp_place){call, 0, 0}, message);
  if (status != TP_OK) return status;
  if (given.count > 0 && !tp_polyline_reserve(&points, (long)given.count)) {
    status = tp_fail_memory(message, name);
  }
  fmpq_t x, y;
  fmpq_init(x);
  fmpq_init(y);
  for (size_t k = 0; k < given.count && status == TP_OK; k++) {
    const int point = (int)k + 1;
    const tp_mark mark = number > 0 ? (tp_mark){(int)number, point} : (tp_mark){point, 0};
    const tp_place place = {call, 0, 0};
    status = read_coordinate(x, given, 2 * k, name, place, message);
    if (status == TP_OK) status = read_coordinate(y, given, 2 * k + 1, name, place, message);
    if (status == TP_OK && !tp_polyline_append(&points, x, y, mark)) {
      status = tp_fail_memory(message, name);
    }
  }
  fmpq_clear(x);
  fmpq_clear(y);
  if (status == TP_OK && !tp_polyline_make_shared(&points)) status = tp_fail_memory(message, name);
  if (status != TP_OK) {
    tp_polyline_clear(&points);
    return status;
  }
  if (closed) tp_polyline_drop_closing_point(&points);
  *line = points;
  return TP_OK;
}
