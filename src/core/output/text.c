/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Growing buffer, and printing of bounded numbers with as many digits as their error leaves
 * certain. */

#include "output/text.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Room for so many bytes more and the zero behind them; false when memory is exhausted. */
static bool make_room(tp_text *text, size_t added) {
  const size_t needed = text->length + added + 1;
  if (text->failed || needed <= text->capacity) return !text->failed;
  const size_t capacity = needed < 4096 ? 4096 : 2 * needed;
  char *data = realloc(text->data, capacity);
  text->failed = data == NULL;
  if (data == NULL) return false;
  text->data = data;
  text->capacity = capacity;
  data[text->length] = '\0'; /* also where nothing is added */
  return true;
}

void tp_text_append(tp_text *text, const char *bytes, size_t length) {
  if (!make_room(text, length)) return;
  memcpy(text->data + text->length, bytes, length);
  text->length += length;
  text->data[text->length] = '\0';
}

/* Printed where the text ends, and once more where there was no room for all of it. */
void tp_text_add_list(tp_text *text, const char *format, va_list arguments) {
  va_list again;
  if (!make_room(text, 0)) return;
  va_copy(again, arguments);
  const size_t room = text->capacity - text->length;
  const int added = vsnprintf(text->data + text->length, room, format, arguments);
  if (added < 0) { /* some numbers take memory to print */
    text->failed = true;
  } else if ((size_t)added < room) {
    text->length += (size_t)added;
  } else if (make_room(text, (size_t)added)) {
    vsnprintf(text->data + text->length, (size_t)added + 1, format, again);
    text->length += (size_t)added;
  }
  va_end(again);
}

void tp_text_add(tp_text *text, const char *format, ...) {
  va_list arguments;
  va_start(arguments, format);
  tp_text_add_list(text, format, arguments);
  va_end(arguments);
}

tp_status tp_text_finish(tp_text *text, char **result) {
  if (text->failed || text->data == NULL) {
    free(text->data);
    *text = (tp_text){0};
    return TP_OUT_OF_MEMORY;
  }
  *result = text->data;
  *text = (tp_text){0};
  return TP_OK;
}

void tp_text_drop(tp_text *text) {
  free(text->data);
  *text = (tp_text){0};
}

static void drop_minus_of_zero(char *number) {
  if (number[0] == '-' && strtod(number, NULL) == 0) memmove(number, number + 1, strlen(number));
}

/* Where no digit is certain: a value and a bound, both short, that hold what the number does. */
static const char *with_bound(char out[TP_NUMBER_SIZE], tp_bounded number) {
  char value[16];
  snprintf(value, sizeof value, "%.3g", fabs(number.value) > number.error ? number.value : 0.0);
  const double off = fabs(number.value - strtod(value, NULL)) + number.error;
  /* one digit, rounded up: 0.95 of the last place is more than half of it and the roundings above
   */
  double place = pow(10, floor(log10(off)));
  if (!(place > 0 && isfinite(place))) place = off;
  snprintf(out, TP_NUMBER_SIZE, "%s ± %.1g", value, off + 0.95 * place);
  return out;
}

static const char *certain(char out[TP_NUMBER_SIZE], tp_bounded number, int digits, int least,
                           const char *format) {
  char low[TP_NUMBER_SIZE], high[TP_NUMBER_SIZE];
  if (!isfinite(number.error)) {
    snprintf(out, TP_NUMBER_SIZE, "out of range");
    return out;
  }
  const double below =
      number.error > 0 ? nextafter(number.value - number.error, -INFINITY) : number.value;
  const double above =
      number.error > 0 ? nextafter(number.value + number.error, INFINITY) : number.value;
  for (; digits >= least; digits--) {
    snprintf(low, sizeof low, format, digits, below);
    snprintf(high, sizeof high, format, digits, above);
    drop_minus_of_zero(low);
    drop_minus_of_zero(high);
    if (strcmp(low, high) == 0) break;
  }
  if (digits < least) return with_bound(out, number);
  snprintf(out, TP_NUMBER_SIZE, "%s", low);
  return out;
}

const char *tp_text_fixed(char out[TP_NUMBER_SIZE], tp_bounded number, int decimals) {
  if (fabs(number.value) >= 1e15) return tp_text_significant(out, number, 15);
  return certain(out, number, decimals, 0, "%.*f");
}

const char *tp_text_significant(char out[TP_NUMBER_SIZE], tp_bounded number, int digits) {
  return certain(out, number, digits, 1, "%.*g");
}

/* The last digit of a number of this size with `digits` significant digits. */
static double last_place(double number, int digits) {
  const double size = fabs(number);
  return size > 0 ? pow(10, floor(log10(size)) + 1 - digits) : 0;
}

/* `bound` rounded down to a multiple of `place`, or up. A format rounds to nearest, hence by at
 * most half of the place: where the result is on the wrong side, one place further is on the right
 * one, but not below the decade, where the format would print finer digits. */
static void print_beyond(char out[TP_NUMBER_SIZE], const char *format, int digits, double bound,
                         double place, bool down) {
  snprintf(out, TP_NUMBER_SIZE, format, digits, bound);
  const double printed = strtod(out, NULL);
  if (down ? printed > bound : printed < bound) {
    const double decade = pow(10, floor(log10(fabs(bound))));
    double beyond = down ? bound - 0.6 * place : bound + 0.6 * place;
    if (decade >= place && fabs(beyond) < decade) beyond = copysign(decade, bound);
    snprintf(out, TP_NUMBER_SIZE, format, digits, beyond);
  }
  drop_minus_of_zero(out);
}

static const char *directed(char out[TP_NUMBER_SIZE], tp_bounded number, int digits, bool fixed,
                            bool down) {
  static const double noise = 1e-9;
  const char *format = fixed ? "%.*f" : "%.*g";
  if (!isfinite(number.error)) {
    snprintf(out, TP_NUMBER_SIZE, "out of range");
    return out;
  }
  const double below =
      number.error > 0 ? nextafter(number.value - number.error, -INFINITY) : number.value;
  const double above =
      number.error > 0 ? nextafter(number.value + number.error, INFINITY) : number.value;
  const int least = fixed ? 0 : 1;
  const double proven = down ? below : above;
  double place = fixed ? pow(10, -digits) : last_place(proven, digits);
  while (digits > least && place < number.error) {
    digits--;
    place *= 10;
  }
  if (place < number.error) return with_bound(out, number);
  const bool exact = number.error <= noise * place;
  print_beyond(out, format, digits, !exact ? proven : down ? above : below, place, down);
  return out;
}

static const char *directed_fixed(char out[TP_NUMBER_SIZE], tp_bounded number, int decimals,
                                  bool down) {
  const bool fits = fabs(number.value) < 1e15;
  return directed(out, number, fits ? decimals : 15, fits, down);
}

const char *tp_text_fixed_down(char out[TP_NUMBER_SIZE], tp_bounded number, int decimals) {
  return directed_fixed(out, number, decimals, true);
}

const char *tp_text_fixed_up(char out[TP_NUMBER_SIZE], tp_bounded number, int decimals) {
  return directed_fixed(out, number, decimals, false);
}

const char *tp_text_significant_down(char out[TP_NUMBER_SIZE], tp_bounded number, int digits) {
  return directed(out, number, digits, false, true);
}

const char *tp_text_significant_up(char out[TP_NUMBER_SIZE], tp_bounded number, int digits) {
  return directed(out, number, digits, false, false);
}

tp_bounded tp_text_over(tp_bounded number, double divisor) {
  /* The divisor and the quotient are rounded once each. */
  const double value = number.value / divisor;
  return (tp_bounded){.value = value,
                      .error = 1.01 * number.error / divisor + 2 * DBL_EPSILON * fabs(value)};
}

tp_bounded tp_text_less(tp_bounded number, tp_bounded other) {
  const double value = number.value - other.value;
  return (tp_bounded){.value = value,
                      .error = 1.01 * (number.error + other.error) + DBL_EPSILON * fabs(value)};
}
