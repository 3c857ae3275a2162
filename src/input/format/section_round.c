/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Rounding of a section's coordinates: short decimals and binary fractions stay exact, other
 * quotients go to a multiple of the largest power of ten below 1e-9 of the section's size; repeated
 * points are dropped. */

#include "format/section_take.h"

#include "number/ratio.h"

#include <math.h>
#include <stdlib.h>

enum { EXACT_BITS = 128, DIGITS = 9 };

/* Is it a whole number over a product of twos and fives, and short? */
static bool is_short(const fmpq_t value) {
  if (fmpz_bits(fmpq_denref(value)) > EXACT_BITS ||
      fmpz_bits(fmpq_numref(value)) > 2 * EXACT_BITS) {
    return false;
  }
  fmpz_t rest, factor;
  fmpz_init_set(rest, fmpq_denref(value));
  fmpz_init_set_ui(factor, 2);
  fmpz_remove(rest, rest, factor);
  fmpz_set_ui(factor, 5);
  fmpz_remove(rest, rest, factor);
  const bool is = fmpz_is_one(rest);
  fmpz_clear(rest);
  fmpz_clear(factor);
  return is;
}

/* To the nearest multiple of 1/steps, a half upwards. */
static void round_to(fmpq_t value, const fmpq_t steps) {
  fmpz_t twice;
  fmpz_init(twice);
  fmpq_mul(value, value, steps);
  fmpz_mul_2exp(fmpq_numref(value), fmpq_numref(value), 1);
  fmpz_add(fmpq_numref(value), fmpq_numref(value), fmpq_denref(value));
  fmpz_mul_2exp(twice, fmpq_denref(value), 1);
  fmpz_fdiv_q(fmpq_numref(value), fmpq_numref(value), twice);
  fmpz_one(fmpq_denref(value));
  fmpq_div(value, value, steps);
  fmpz_clear(twice);
}

/* 10^exponent */
static void set_power(fmpq_t power, long exponent) {
  fmpq_one(power);
  fmpz *const side = exponent < 0 ? fmpq_denref(power) : fmpq_numref(power);
  fmpz_set_ui(side, 10);
  fmpz_pow_ui(side, side, (unsigned long)labs(exponent));
}

/* The largest power of ten that is at most 1e-9 of the greater side, or next to it where that is
 * within the error of a double. */
static void find_resolution(fmpq_t resolution, const tp_mesh_section *section) {
  fmpq_t width, height, most;
  fmpq_init(width);
  fmpq_init(height);
  fmpq_init(most);
  for (long k = 0; k < section->count; k++) {
    tp_polyline_size(width, height, &section->chains[k].points);
    if (fmpq_cmp(width, most) > 0) fmpq_swap(most, width);
    if (fmpq_cmp(height, most) > 0) fmpq_swap(most, height);
  }
  const double power = floor(log10(fmpq_get_d(most))); /* sizes beyond a double are refused later */
  set_power(resolution, (long)fmax(-TP_RATIO_EXPONENT, fmin(power, TP_RATIO_EXPONENT)) - DIGITS);
  fmpq_clear(width);
  fmpq_clear(height);
  fmpq_clear(most);
}

static void drop_repeated(tp_section_chain *chain) {
  tp_polyline *line = &chain->points;
  long kept = 0;
  for (long k = 0; k < line->count; k++) {
    const bool repeats = kept > 0 && fmpq_equal(line->x + k, line->x + kept - 1) &&
                         fmpq_equal(line->y + k, line->y + kept - 1);
    if (repeats) continue;
    fmpq_swap(line->x + kept, line->x + k);
    fmpq_swap(line->y + kept, line->y + k);
    line->marks[kept++] = line->marks[k];
  }
  for (long k = kept; k < line->count; k++) {
    fmpq_clear(line->x + k);
    fmpq_clear(line->y + k);
  }
  line->count = kept;
  if (chain->closed) tp_polyline_drop_closing_point(line);
}

void tp_section_round(tp_mesh_section *section, const fmpq_t factor, fmpq_t resolution) {
  bool rounded = false;
  fmpq_t steps;
  for (long k = 0; k < section->count; k++) {
    tp_polyline *line = &section->chains[k].points;
    for (long p = 0; p < line->count; p++) {
      fmpq_mul(line->x + p, line->x + p, factor);
      fmpq_mul(line->y + p, line->y + p, factor);
    }
  }
  find_resolution(resolution, section);
  fmpq_init(steps);
  fmpq_inv(steps, resolution);
  for (long k = 0; k < section->count; k++) {
    tp_polyline *line = &section->chains[k].points;
    for (long p = 0; p < 2 * line->count; p++) {
      fmpq *value = (p % 2 == 0 ? line->x : line->y) + p / 2;
      if (is_short(value)) continue;
      round_to(value, steps);
      rounded = true;
    }
    drop_repeated(section->chains + k);
  }
  fmpq_clear(steps);
  if (!rounded) fmpq_zero(resolution);
}
