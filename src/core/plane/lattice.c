/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Common denominator of all coordinates, exact subtraction of a local origin, rounding to doubles
 * with a sticky bit, and exact signs of cross and dot products of integers. */

#include "plane/lattice.h"

#include "number/word.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Integers of a lattice may take at most this many bits in all (2 GiB) ... */
static const double most_bits = 1.7e10;

/* ... and what is computed with them this much: a product of b bits costs about b^1.5, and each
 * point takes some. Two thousand vertices whose denominators of 15 digits have no common factor
 * come up to it, in some seconds; a million of 300 digits each do not. */
static const double most_work = 5e11;

void tp_lattice_clear(tp_lattice *lattice) {
  for (long k = 0; k < lattice->count; k++) {
    if (lattice->x != NULL) fmpz_clear(lattice->x + k);
    if (lattice->y != NULL) fmpz_clear(lattice->y + k);
  }
  free(lattice->start);
  free(lattice->x);
  free(lattice->y);
  free(lattice->u);
  free(lattice->v);
  fmpz_clear(lattice->origin_x);
  fmpz_clear(lattice->origin_y);
  fmpq_clear(lattice->step_m);
  memset(lattice, 0, sizeof *lattice);
}

static tp_status common_denominator(fmpz_t denominator, const tp_polyline *const *chains,
                                    long chain_count, long point_count, tp_message *message) {
  fmpz_one(denominator);
  for (long c = 0; c < chain_count; c++) {
    for (long k = 0; k < 2 * chains[c]->count; k++) {
      const fmpq *value = k % 2 == 0 ? chains[c]->x + k / 2 : chains[c]->y + k / 2;
      if (fmpz_divisible(denominator, fmpq_denref(value))) continue;
      fmpz_lcm(denominator, denominator, fmpq_denref(value));
      const double bits = (double)fmpz_bits(denominator), integers = 2 * (double)point_count;
      if (bits * integers > most_bits || bits * sqrt(bits) * integers > most_work) {
        return tp_refuse(message, TP_FAULT_RANGE, tp_polyline_place(chains[c], k / 2),
                         "up to here the denominators of the coordinates have a common multiple of "
                         "%.0f digits, too many to compute with exactly; write the coordinates as "
                         "decimals, or round the fractions",
                         bits * log10(2));
      }
    }
  }
  return TP_OK;
}

static void to_integer(fmpz_t integer, const fmpq *value, const fmpz_t denominator, fmpz_t factor) {
  fmpz_divexact(factor, denominator, fmpq_denref(value));
  fmpz_mul(integer, fmpq_numref(value), factor);
}

/* Subtract the middle of the range of the first `leading` values from all of them. */
static void centre(fmpz *values, long leading, long count, fmpz_t origin) {
  if (leading == 0) return;
  const fmpz *least = values, *most = values;
  for (long k = 1; k < leading; k++) {
    if (fmpz_cmp(values + k, least) < 0) least = values + k;
    if (fmpz_cmp(values + k, most) > 0) most = values + k;
  }
  fmpz_add(origin, least, most);
  fmpz_fdiv_q_2exp(origin, origin, 1);
  for (long k = 0; k < count; k++) fmpz_sub(values + k, values + k, origin);
}

static long largest_bits(const fmpz *values, long count) {
  long bits = 0;
  for (long k = 0; k < count; k++) {
    const long own = (long)fmpz_bits(values + k);
    if (own > bits) bits = own;
  }
  return bits;
}

/* values * 2^-exponent rounded to nearest. FLINT's own conversion truncates; here the 60 leading
 * bits and one sticky bit for the rest are rounded by the machine, which decides every tie. */
static void to_doubles(double *rounded, const fmpz *values, long count, long exponent) {
  if (exponent == 0) {
    for (long k = 0; k < count; k++) rounded[k] = (double)tp_word_get(values + k);
    return;
  }
  fmpz_t head;
  fmpz_init(head);
  for (long k = 0; k < count; k++) {
    const long shift = (long)fmpz_bits(values + k) - 60;
    if (shift <= 0) {
      rounded[k] = ldexp((double)tp_word_get(values + k), (int)-exponent);
      continue;
    }
    fmpz_tdiv_q_2exp(head, values + k, (unsigned long)shift);
    const int64_t word = tp_word_get(head);
    const bool sticky = fmpz_val2(values + k) < (unsigned long)shift;
    const int64_t size =
        llabs(word) | (sticky ? 1 : 0); /* the size, so that it moves away from zero */
    rounded[k] = ldexp((double)(word < 0 ? -size : size), (int)(shift - exponent));
  }
  fmpz_clear(head);
}

/* Doubles of one axis; the exponent. `*bits` grows to the size of the largest integer. */
static long round_axis(double *rounded, const fmpz *values, long count, long *bits) {
  const long own = largest_bits(values, count);
  const long exponent = own > 53 ? own - 53 : 0;
  to_doubles(rounded, values, count, exponent);
  if (own > *bits) *bits = own;
  return exponent;
}

bool tp_lattice_is_exact(const tp_lattice *lattice) {
  return lattice->exponent_u == 0 && lattice->exponent_v == 0;
}

static bool allocate(tp_lattice *lattice, long chain_count, long count) {
  if (count > INT32_MAX) return false; /* beyond any memory */
  const size_t points = count > 0 ? (size_t)count : 1;
  lattice->chain_count = chain_count;
  lattice->start = calloc((size_t)chain_count + 1, sizeof *lattice->start);
  lattice->x = calloc(points, sizeof *lattice->x);
  lattice->y = calloc(points, sizeof *lattice->y);
  lattice->u = calloc(points, sizeof *lattice->u);
  lattice->v = calloc(points, sizeof *lattice->v);
  lattice->count = count;
  return lattice->start != NULL && lattice->x != NULL && lattice->y != NULL && lattice->u != NULL &&
         lattice->v != NULL;
}

static void fill(tp_lattice *lattice, const tp_polyline *const *chains, const fmpz_t denominator) {
  fmpz_t factor;
  fmpz_init(factor);
  long at = 0;
  for (long c = 0; c < lattice->chain_count; c++) {
    lattice->start[c] = at;
    for (long k = 0; k < chains[c]->count; k++, at++) {
      to_integer(lattice->x + at, chains[c]->x + k, denominator, factor);
      to_integer(lattice->y + at, chains[c]->y + k, denominator, factor);
    }
  }
  lattice->start[lattice->chain_count] = at;
  fmpz_clear(factor);
  const long leading = lattice->chain_count > 0 ? chains[0]->count : 0;
  centre(lattice->x, leading, lattice->count, lattice->origin_x);
  centre(lattice->y, leading, lattice->count, lattice->origin_y);
  lattice->exponent_u = round_axis(lattice->u, lattice->x, lattice->count, &lattice->bits);
  lattice->exponent_v = round_axis(lattice->v, lattice->y, lattice->count, &lattice->bits);
}

tp_status tp_lattice_init(tp_lattice *lattice, const tp_polyline *const *chains, long count,
                          const fmpq_t metres_per_unit, tp_message *message) {
  memset(lattice, 0, sizeof *lattice);
  fmpz_init(lattice->origin_x);
  fmpz_init(lattice->origin_y);
  fmpq_init(lattice->step_m);
  fmpz_t denominator;
  fmpz_init(denominator);
  long points = 0;
  for (long c = 0; c < count; c++) points += chains[c]->count;
  tp_status status = common_denominator(denominator, chains, count, points, message);
  if (status == TP_OK && !allocate(lattice, count, points)) {
    status = tp_fail_memory(message, "the lattice of points");
  }
  if (status == TP_OK) {
    fill(lattice, chains, denominator);
    fmpq_div_fmpz(lattice->step_m, metres_per_unit, denominator);
  } else {
    tp_lattice_clear(lattice);
  }
  fmpz_clear(denominator);
  return status;
}

double tp_lattice_work(const tp_lattice *lattice) {
  const double bits = (double)lattice->bits;
  return 2 * (double)lattice->count * bits * sqrt(bits);
}

static void metres(fmpq_t result, const fmpz_t value, const fmpz_t origin, const fmpq_t step) {
  fmpz_add(fmpq_numref(result), value, origin);
  fmpz_one(fmpq_denref(result));
  fmpq_mul(result, result, step);
}

void tp_lattice_metres_x(fmpq_t result, const tp_lattice *lattice, const fmpz_t x) {
  metres(result, x, lattice->origin_x, lattice->step_m);
}

void tp_lattice_metres_y(fmpq_t result, const tp_lattice *lattice, const fmpz_t y) {
  metres(result, y, lattice->origin_y, lattice->step_m);
}

static int bilinear_sign(const fmpz *a, const fmpz *b, const fmpz *c, const fmpz *d, bool add) {
  fmpz_t result;
  fmpz_init(result);
  fmpz_mul(result, a, b);
  if (add) {
    fmpz_addmul(result, c, d);
  } else {
    fmpz_submul(result, c, d);
  }
  const int sign = fmpz_sgn(result);
  fmpz_clear(result);
  return sign;
}

/* to - from in 63 bits, where both are small. */
static bool difference(int64_t *word, const fmpz *to, const fmpz *from) {
  int64_t start;
  if (!tp_word_small(word, to) || !tp_word_small(&start, from)) return false;
  *word -= start;
  return true;
}

/* By words, where all coordinates are small: their products have 126 bits. */
static bool sign_by_words(int *sign, const tp_lattice *l, long a, long b, long c, long d,
                          bool dot) {
  int64_t dx, dy, other_dx, other_dy;
  if (!difference(&dx, l->x + b, l->x + a) || !difference(&dy, l->y + b, l->y + a) ||
      !difference(&other_dx, l->x + d, l->x + c) || !difference(&other_dy, l->y + d, l->y + c)) {
    return false;
  }
  const __int128 product = dot ? (__int128)dx * other_dx + (__int128)dy * other_dy
                               : (__int128)dx * other_dy - (__int128)dy * other_dx;
  *sign = (product > 0) - (product < 0);
  return true;
}

static int sign_of_product(const tp_lattice *l, long a, long b, long c, long d, bool dot) {
  int sign;
  if (sign_by_words(&sign, l, a, b, c, d, dot)) return sign;
  fmpz r[4]; /* dx and dy of b - a and of d - c */
  for (int k = 0; k < 4; k++) fmpz_init(r + k);
  fmpz_sub(r, l->x + b, l->x + a);
  fmpz_sub(r + 1, l->y + b, l->y + a);
  fmpz_sub(r + 2, l->x + d, l->x + c);
  fmpz_sub(r + 3, l->y + d, l->y + c);
  sign = dot ? bilinear_sign(r, r + 2, r + 1, r + 3, true)
             : bilinear_sign(r, r + 3, r + 1, r + 2, false);
  for (int k = 0; k < 4; k++) fmpz_clear(r + k);
  return sign;
}

int tp_lattice_cross(const tp_lattice *lattice, long a, long b, long c, long d) {
  return sign_of_product(lattice, a, b, c, d, false);
}

int tp_lattice_dot(const tp_lattice *lattice, long a, long b, long c, long d) {
  return sign_of_product(lattice, a, b, c, d, true);
}

bool tp_lattice_same_point(const tp_lattice *lattice, long a, long b) {
  return a == b || (tp_word_equal(lattice->x + a, lattice->x + b) &&
                    tp_word_equal(lattice->y + a, lattice->y + b));
}
