/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Heights scaled to a wanted roughness. Z2^2 = (1/L) sum dy^2 / dx, and the mean square height
 * about the mean is (1/L) sum dx (a^2 + a b + b^2) / 3 with a and b the ends of a facet over the
 * mean: both roots are proportional to the heights, so that one factor does it. Sums in doubles, in
 * the order of the points. */

#include "generate/generate.h"
#include "generate/ticks.h"
#include "number/word.h"

#include <math.h>
#include <stdlib.h>

/* So small are only differences of numbers at the end of their range. */
static const double least_rise = 1e-290;

static double difference(const fmpq *to, const fmpq *from, fmpq_t room) {
  double quick;
  if (tp_word_difference(&quick, to, from)) return quick;
  fmpq_sub(room, to, from);
  return fmpq_get_d(room);
}

/* (1/L) sum dx (y0 + y1) / 2, over the first point. */
static double find_mean(const tp_polyline *line, fmpq_t room) {
  double area = 0, x = 0, y = 0;
  for (long k = 1; k < line->count; k++) {
    const double at = difference(line->x + k, line->x, room);
    const double after = difference(line->y + k, line->y, room);
    area += (at - x) * (y + after) / 2;
    x = at;
    y = after;
  }
  return area / x;
}

bool tp_roughness_of(tp_roughness *roughness, const tp_polyline *line,
                     tp_self_affine_target target) {
  fmpq_t room;
  fmpq_init(room);
  const double mean = target == TP_TARGET_Z2 ? 0 : find_mean(line, room);
  double squares = 0, rises = 0, x = 0, y = -mean, least = y;
  bool runs = true;
  roughness->lowest = 0;
  for (long k = 1; k < line->count; k++) {
    const double at = difference(line->x + k, line->x, room), dx = at - x;
    const double after = difference(line->y + k, line->y, room) - mean, dy = after - y;
    runs = runs && dx > 0;
    squares += target == TP_TARGET_Z2 ? dy * dy / dx : dx * (y * y + y * after + after * after) / 3;
    rises += fabs(dy);
    if (after < least) {
      least = after;
      roughness->lowest = k;
    }
    x = at;
    y = after;
  }
  fmpq_clear(room);
  roughness->size = rises < least_rise ? 0 : sqrt(squares / x);
  roughness->mean_rise = rises / (double)(line->count - 1);
  return runs && isfinite(roughness->size);
}

static void set_double(fmpq_t value, double d) {
  int exponent = 0;
  const double part = frexp(d, &exponent);
  fmpq_one(value);
  tp_word_set(fmpq_numref(value), (int64_t)ldexp(part, 53));
  if (exponent >= 53) {
    fmpq_mul_2exp(value, value, (flint_bitcnt_t)(exponent - 53));
  } else {
    fmpq_div_2exp(value, value, (flint_bitcnt_t)(53 - exponent));
  }
}

/* A height is at most as many times the mean rise as there are points: in ticks it is a word. */
void tp_scale_heights(tp_polyline *line, const fmpq_t size, const tp_roughness *own) {
  fmpq_t unit, factor, low;
  tp_ticks ticks;
  fmpq_init(unit);
  fmpq_init(factor);
  fmpq_init(low);
  set_double(unit, own->size);
  fmpq_div(factor, size, unit);
  set_double(low, own->mean_rise);
  fmpq_mul(low, low, factor);
  tp_ticks_millionth(unit, low);
  fmpq_set(low, line->y + own->lowest);
  tp_ticks_init(&ticks, low, unit);
  fmpq_div(factor, factor, unit);
  const double scale = fmpq_get_d(factor);
  for (long k = 0; k < line->count; k++) {
    const double over = difference(line->y + k, low, unit);
    tp_ticks_at(line->y + k, &ticks, (int64_t)floor(over * scale + 0.5));
  }
  tp_ticks_clear(&ticks);
  fmpq_clear(unit);
  fmpq_clear(factor);
  fmpq_clear(low);
}
