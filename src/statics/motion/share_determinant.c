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

/* A vector, the sizes of its components, and with their errors. */
typedef struct sized {
  double value[3], size[3], most[3];
} sized;

static void set_sized(sized *own, const tp_near vector[3]) {
  for (int e = 0; e < 3; e++) {
    own->value[e] = vector[e].value;
    own->size[e] = fabs(vector[e].value);
    own->most[e] = own->size[e] + vector[e].error;
  }
}

/* The determinant with every term taken for positive. */
static double permanent(const double a[3], const double b[3], const double c[3]) {
  double sum = 0;
  for (int k = 0; k < 3; k++) {
    const int next = (k + 1) % 3, last = (k + 2) % 3;
    sum += a[k] * (b[next] * c[last] + b[last] * c[next]);
  }
  return sum;
}

/* det(a, b, c) as a polynomial of the share; what its bound does not tell from zero is none.
 *
 * Bound: with every component at the far end of its error no product of them grows by more than
 * their permanent does. Five roundings of a determinant and three of a sum of some add 8 u of the
 * permanent, u = 2^-53; those of the difference of two permanents, six each, 12 u. */
static tp_share_polynomial plain_determinant(const tp_share_line *of[3]) {
  static const double unit = 0x1p-53, roundings = 24;
  double sums[TP_SHARE_DEGREE + 1] = {0}, errors[TP_SHARE_DEGREE + 1] = {0};
  sized parts[3][2];
  bool has_rise[3];
  for (int k = 0; k < 3; k++) {
    has_rise[k] = rises(of[k]);
    set_sized(parts[k], of[k]->at);
    if (has_rise[k]) set_sized(parts[k] + 1, of[k]->rise);
  }
  const int risers = has_rise[0] + has_rise[1] + has_rise[2];
  for (unsigned ups = 0; ups < 8; ups++) {
    const unsigned up[3] = {ups & 1U, ups >> 1 & 1U, ups >> 2 & 1U};
    if ((up[0] && !has_rise[0]) || (up[1] && !has_rise[1]) || (up[2] && !has_rise[2])) continue;
    const sized *a = parts[0] + up[0], *b = parts[1] + up[1], *c = parts[2] + up[2];
    const unsigned power = up[0] + up[1] + up[2];
    const double most = permanent(a->most, b->most, c->most);
    sums[power] += tp_double_determinant(a->value, b->value, c->value);
    errors[power] +=
        (most - permanent(a->size, b->size, c->size)) + roundings * unit * most + DBL_MIN;
  }
  tp_share_polynomial p = {.degree = -1};
  for (int k = 0; k <= risers; k++) {
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
