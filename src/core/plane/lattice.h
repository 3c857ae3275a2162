/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Exact points on one integer lattice.
 *
 * Every coordinate of a scene is a rational. Over their common denominator D they are integers, and
 * relative to a local origin (the middle of the first chain, subtracted exactly) they are small
 * ones:
 *     x_m = (x + origin_x) * step_m,   step_m = metres per scene length / D.
 * Predicates and moment sums on the integers are exact with ring operations only. For double
 * arithmetic u = x * 2^-exponent_u and v = y * 2^-exponent_v, rounded to nearest, the largest of
 * each near 2^53 or below; both exponents 0 say that all u and v are exact. */

#ifndef TP_PLANE_LATTICE_H
#define TP_PLANE_LATTICE_H

#include "plane/polyline.h"

#include <flint/fmpq.h>
#include <flint/fmpz.h>

typedef struct tp_lattice {
  long chain_count;
  long *start; /* chain k holds the points start[k] … start[k + 1] - 1 */
  long count;  /* points in all */
  fmpz *x, *y;
  double *u, *v;
  long exponent_u, exponent_v;
  long bits; /* of the largest integer */
  fmpz_t origin_x, origin_y;
  fmpq_t step_m;
} tp_lattice;

/* Put `count` chains on one lattice. Fails for points so unlike in denominators that the integers
 * would not fit in memory, or take minutes. On failure `lattice` is cleared. */
TP_MUST_USE tp_status tp_lattice_init(tp_lattice *lattice, const tp_polyline *const *chains,
                                      long count, const fmpq_t metres_per_unit,
                                      tp_message *message);
void tp_lattice_clear(tp_lattice *lattice);

/* Are u and v the coordinates themselves? */
bool tp_lattice_is_exact(const tp_lattice *lattice);

/* What one product of each coordinate costs, about, in units of one of one bit. */
double tp_lattice_work(const tp_lattice *lattice);

/* The coordinate in metres, exactly. */
void tp_lattice_metres_x(fmpq_t metres, const tp_lattice *lattice, const fmpz_t x);
void tp_lattice_metres_y(fmpq_t metres, const tp_lattice *lattice, const fmpz_t y);

/* Sign of (b - a) x (d - c) and of (b - a) . (d - c) for points of the lattice. */
int tp_lattice_cross(const tp_lattice *lattice, long a, long b, long c, long d);
int tp_lattice_dot(const tp_lattice *lattice, long a, long b, long c, long d);

/* Do they lie in one point? */
bool tp_lattice_same_point(const tp_lattice *lattice, long a, long b);

#endif
