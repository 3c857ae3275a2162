/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A self-affine profile by spectral synthesis (Saupe, in Peitgen and Saupe, The Science of Fractal
 * Images, 1988): waves of a period of at least one and a quarter times the length, with amplitudes
 * as k^-(H + 1/2) and random phases. A phase is the direction of a random point within the unit
 * circle, so that no sine is needed. Of the period the first points are taken, their line of least
 * squares is taken off, and they are scaled to the RMS height or the Z2 asked for: it has that by
 * its own points, not on average. Heights are rounded to a millionth of their RMS or finer, to a
 * power of ten. */

#include "generate/generate.h"
#include "generate/random.h"
#include "generate/ticks.h"
#include "generate/waves.h"
#include "number/word.h"

#include <math.h>
#include <stdlib.h>

void tp_self_affine_options_init(tp_self_affine_options *options) {
  *options = (tp_self_affine_options){.hurst = 0};
  fmpq_init(options->step);
  fmpq_init(options->shortest);
  fmpq_init(options->longest);
  fmpq_init(options->x);
  fmpq_init(options->y);
  fmpq_init(options->size);
}

void tp_self_affine_options_clear(tp_self_affine_options *options) {
  fmpq_clear(options->step);
  fmpq_clear(options->shortest);
  fmpq_clear(options->longest);
  fmpq_clear(options->x);
  fmpq_clear(options->y);
  fmpq_clear(options->size);
}

/* Waves of the period from the longest to the shortest. */
typedef struct band {
  long period, first, last;
} band;

/* floor(period step / wavelength), or its ceiling. */
static long waves(const tp_self_affine_options *o, long period, const fmpq_t wavelength, bool up) {
  fmpq_t share;
  fmpz_t whole;
  fmpq_init(share);
  fmpz_init(whole);
  fmpq_mul_si(share, o->step, period);
  fmpq_div(share, share, wavelength);
  if (up) {
    fmpz_cdiv_q(whole, fmpq_numref(share), fmpq_denref(share));
  } else {
    fmpz_fdiv_q(whole, fmpq_numref(share), fmpq_denref(share));
  }
  const long count = fmpz_get_si(whole);
  fmpq_clear(share);
  fmpz_clear(whole);
  return count;
}

static band find_band(const tp_self_affine_options *o) {
  band own = {.period = 16};
  while (own.period < o->steps + o->steps / 4) own.period *= 2;
  own.first = waves(o, own.period, o->longest, true);
  own.last = waves(o, own.period, o->shortest, false);
  if (own.last > own.period / 2 - 1) own.last = own.period / 2 - 1;
  return own;
}

/* Draws until a point lies within the circle: four of five in all do. */
static tp_complex draw_direction(uint64_t stream, long k) {
  for (uint64_t again = 0;; again++) {
    const uint64_t bits = tp_random_bits(stream, ((uint64_t)k << 32) + again);
    const double x = tp_random_even((uint32_t)bits), y = tp_random_even((uint32_t)(bits >> 32));
    const double square = x * x + y * y;
    if (square < 1) {
      const double one = 1 / sqrt(square);
      return (tp_complex){x * one, y * one};
    }
  }
}

/* k^-(H + 1/2), k being new in [first, ...): the power of a product is the product of the powers,
 * and what was found before serves. */
static double power_of(const double *sizes, const double *of_prime, long k, long first,
                       double exponent) {
  static const long primes[] = {2, 3, 5};
  for (size_t p = 0; p < sizeof primes / sizeof primes[0]; p++) {
    if (k % primes[p] == 0 && k / primes[p] >= first) return of_prime[p] * sizes[k / primes[p]];
  }
  return tp_waves_power(k, exponent);
}

static void draw_waves(tp_complex *z, double *sizes, const tp_self_affine_options *o, band own) {
  const uint64_t stream = tp_random_stream(o->seed, TP_STREAM_WAVES);
  const double exponent = o->hurst + 0.5;
  const double of_prime[] = {tp_waves_power(2, exponent), tp_waves_power(3, exponent),
                             tp_waves_power(5, exponent)};
  for (long k = 0; k < own.period / 2; k++) z[k] = (tp_complex){0, 0};
  for (long k = own.first; k <= own.last; k++) {
    sizes[k] = power_of(sizes, of_prime, k, own.first, exponent);
    const tp_complex direction = draw_direction(stream, k);
    z[k] = (tp_complex){sizes[k] * direction.re, sizes[k] * direction.im};
  }
}

/* Take off the line of least squares; the root of the mean square of what is left. */
static double level(double *y, long count) {
  const double middle = (double)(count - 1) / 2;
  double mean = 0, slope = 0, squares = 0;
  for (long j = 0; j < count; j++) {
    mean += y[j];
    slope += ((double)j - middle) * y[j];
  }
  mean /= (double)count;
  slope /= (double)count * ((double)count * (double)count - 1) / 12;
  for (long j = 0; j < count; j++) {
    y[j] -= mean + slope * ((double)j - middle);
    squares += y[j] * y[j];
  }
  return sqrt(squares / (double)count);
}

/* The root of the mean square of the differences of neighbours. */
static double differences(const double *y, long steps) {
  double squares = 0;
  for (long j = 0; j < steps; j++) squares += (y[j + 1] - y[j]) * (y[j + 1] - y[j]);
  return sqrt(squares / (double)steps);
}

/* The RMS height in scene lengths: given, or Z2 step rms / differences, by one quotient of doubles.
 */
static void find_rms(fmpq_t rms, const tp_self_affine_options *o, double own_rms, double own_z2) {
  if (o->target == TP_TARGET_RMS_HEIGHT) {
    fmpq_set(rms, o->size);
    return;
  }
  int exponent = 0;
  const double part = frexp(own_rms / own_z2, &exponent);
  fmpq_one(rms);
  tp_word_set(fmpq_numref(rms), (int64_t)ldexp(part, 53));
  if (exponent >= 53) {
    fmpq_mul_2exp(rms, rms, (flint_bitcnt_t)(exponent - 53));
  } else {
    fmpq_div_2exp(rms, rms, (flint_bitcnt_t)(53 - exponent));
  }
  fmpq_mul(rms, rms, o->size);
  fmpq_mul(rms, rms, o->step);
}

static bool place(tp_polyline *line, const tp_self_affine_options *o, const double *y, double rms,
                  const fmpq_t size) {
  tp_polyline own = {.file = line->file, .mark = line->mark};
  if (!tp_polyline_reserve(&own, o->steps + 1)) {
    tp_polyline_clear(&own);
    return false;
  }
  tp_ticks along, up;
  fmpq_t unit;
  fmpq_init(unit);
  tp_ticks_millionth(unit, size);
  tp_ticks_init(&along, o->x, o->step);
  tp_ticks_init(&up, o->y, unit);
  fmpq_div(unit, size, unit);
  const double scale = fmpq_get_d(unit) / rms;
  for (long j = 0; j <= o->steps; j++) {
    fmpq_init(own.x + j);
    fmpq_init(own.y + j);
    tp_ticks_at(own.x + j, &along, j);
    tp_ticks_at(own.y + j, &up, (int64_t)floor(y[j] * scale + 0.5));
    own.marks[j] = line->mark;
  }
  own.count = o->steps + 1;
  tp_ticks_clear(&along);
  tp_ticks_clear(&up);
  fmpq_clear(unit);
  *line = own;
  return true;
}

bool tp_generate_self_affine(tp_polyline *line, bool *no_wave, const tp_self_affine_options *o) {
  const band own = find_band(o);
  *no_wave = own.first > own.last;
  if (*no_wave) return true;
  const size_t half = (size_t)own.period / 2;
  double *y = malloc(2 * half * sizeof *y), *sizes = malloc(2 * half * sizeof *sizes);
  tp_complex *turns = malloc((half / 2 + 1) * sizeof *turns);
  bool enough = y != NULL && sizes != NULL && turns != NULL;
  if (enough) {
    tp_complex *z = (tp_complex *)(void *)y, *room = (tp_complex *)(void *)sizes;
    fmpq_t size;
    draw_waves(z, sizes, o, own);
    tp_waves_turns(turns, own.period);
    tp_waves_sum(z, room, turns, own.period);
    fmpq_init(size);
    const double rms = level(y, o->steps + 1);
    find_rms(size, o, rms, differences(y, o->steps));
    enough = place(line, o, y, rms, size);
    fmpq_clear(size);
  }
  free(y);
  free(sizes);
  free(turns);
  return enough;
}
