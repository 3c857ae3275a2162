/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Determinants of three linear functions of the strength share as its cubic polynomials: products
 * of their parts, collected by how many of them rise. */

#include "motion/share_determinant.h"

#include "number/ball.h"

#include <math.h>

static bool rises(const tp_share_line *line) {
  return line->rise[0].value != 0 || line->rise[1].value != 0 || line->rise[2].value != 0;
}

static void ball_determinant(arb_t own, const tp_vector *of[3], long bits) {
  arb_t part;
  arb_init(part);
  arb_zero(own);
  for (int k = 0; k < 3; k++) {
    const int next = (k + 1) % 3, last = (k + 2) % 3;
    arb_mul(part, of[1]->of + next, of[2]->of + last, bits);
    arb_submul(part, of[1]->of + last, of[2]->of + next, bits);
    arb_addmul(own, part, of[0]->of + k, bits);
  }
  arb_clear(part);
}

/* The coefficient of a power of the share by balls. */
static tp_near ball_coefficient(const tp_share_line *of[3], int power, long bits) {
  arb_t sum, part;
  arb_init(sum);
  arb_init(part);
  for (unsigned choice = 0; choice < 8; choice++) {
    const tp_vector *vectors[3];
    int own = 0;
    for (int k = 0; k < 3; k++) {
      const bool up = (choice >> k & 1U) != 0;
      vectors[k] = up ? &of[k]->balls->rise : &of[k]->balls->at;
      own += up;
    }
    if (own != power) continue;
    ball_determinant(part, vectors, bits);
    arb_add(sum, sum, part, bits);
  }
  const tp_near near = arb_is_zero(sum) ? (tp_near){0, 0} : tp_ball_near(sum);
  arb_clear(sum);
  arb_clear(part);
  return near;
}

/* A number's part at 0 and its rise, in one operation of the processor. */
typedef double pair __attribute__((vector_size(16)));

/* Values of a vector, sizes, and sizes with their errors, as numbers and as pairs. */
typedef struct sized {
  double value[3], size[3], most[3];
} sized;

typedef struct sized_pairs {
  pair value[3], size[3], most[3];
} sized_pairs;

static void set_sized(sized *own, const tp_near vector[3]) {
  for (int e = 0; e < 3; e++) {
    own->value[e] = vector[e].value;
    own->size[e] = fabs(vector[e].value);
    own->most[e] = own->size[e] + vector[e].error;
  }
}

static void set_pairs(sized_pairs *own, const tp_share_line *line) {
  for (int e = 0; e < 3; e++) {
    const tp_near at = line->at[e], rise = line->rise[e];
    own->value[e] = (pair){at.value, rise.value};
    own->size[e] = (pair){fabs(at.value), fabs(rise.value)};
    own->most[e] = own->size[e] + (pair){at.error, rise.error};
  }
}

static inline pair determinant_of(const double a[3], const double b[3], const pair c[3]) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
         a[2] * (b[0] * c[1] - b[1] * c[0]);
}

/* The same with every term taken for positive. */
static inline pair permanent_of(const double a[3], const double b[3], const pair c[3]) {
  return a[0] * (b[1] * c[2] + b[2] * c[1]) + a[1] * (b[2] * c[0] + b[0] * c[2]) +
         a[2] * (b[0] * c[1] + b[1] * c[0]);
}

/* det(a, b, c) as a polynomial of the share; what its bound does not tell from zero is none.
 *
 * Bound: with every component at the far end of its error no product of them grows by more than
 * their permanent does. Five roundings of a determinant and three of a sum of some add 8 u of the
 * permanent, u = 2^-53; those of the difference of two permanents, six each, 12 u. */
static tp_share_polynomial plain_determinant(const tp_share_line *of[3]) {
  static const double unit = 0x1p-53, roundings = 24;
  double sums[TP_SHARE_DEGREE + 1] = {0}, errors[TP_SHARE_DEGREE + 1] = {0};
  sized a, b[2];
  sized_pairs c;
  const int a_parts = rises(of[0]) ? 2 : 1, b_parts = rises(of[1]) ? 2 : 1;
  set_sized(b, of[1]->at);
  if (b_parts == 2) set_sized(b + 1, of[1]->rise);
  set_pairs(&c, of[2]);
  for (int a_up = 0; a_up < a_parts; a_up++) {
    set_sized(&a, a_up == 0 ? of[0]->at : of[0]->rise);
    for (int b_up = 0; b_up < b_parts; b_up++) {
      const pair value = determinant_of(a.value, b[b_up].value, c.value);
      const pair size = permanent_of(a.size, b[b_up].size, c.size);
      const pair most = permanent_of(a.most, b[b_up].most, c.most);
      const pair error = (most - size) + roundings * unit * most + DBL_MIN;
      for (int up = 0; up < 2; up++) {
        sums[a_up + b_up + up] += value[up];
        errors[a_up + b_up + up] += error[up];
      }
    }
  }
  tp_share_polynomial p = {.degree = -1};
  for (int k = 0; k <= TP_SHARE_DEGREE; k++) {
    if (!(fabs(sums[k]) > errors[k])) continue;
    p.of[k] = sums[k];
    p.degree = k;
  }
  return p;
}

/* What doubles do not tell from zero is asked of balls. */
tp_share_polynomial tp_share_determinant(const tp_share_line *a, const tp_share_line *b,
                                         const tp_share_line *c, long bits) {
  const tp_share_line *of[3] = {a, b, c};
  if (a->balls == NULL) return plain_determinant(of);
  tp_near sums[TP_SHARE_DEGREE + 1] = {{0, 0}};
  for (unsigned choice = 0; choice < 8; choice++) {
    const tp_near *vectors[3];
    bool vanishes = false;
    int power = 0;
    for (int k = 0; k < 3; k++) {
      const bool up = (choice >> k & 1U) != 0;
      vectors[k] = up ? of[k]->rise : of[k]->at;
      vanishes = vanishes || (up && !rises(of[k]));
      power += up;
    }
    if (vanishes) continue;
    sums[power] = tp_near_add(sums[power], tp_near_determinant(vectors[0], vectors[1], vectors[2]));
  }
  for (int power = 0; power <= TP_SHARE_DEGREE; power++) {
    const bool open = tp_near_sign(sums[power]) == 0 && sums[power].error > 0;
    if (open) sums[power] = ball_coefficient(of, power, bits);
  }
  return tp_share_polynomial_of(sums);
}
