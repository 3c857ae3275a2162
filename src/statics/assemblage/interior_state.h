/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A point within all bounds of the program of forces, and what its steps are made of:
 *
 * minimise -s:  A f + s w1 = -w0,  A^T y + z_f = 0,  w1 . y + z_s = -1,  x z = mu, with s + 1 as
 * the last variable: what falls without the load has a limit below zero. A factor that is bounded,
 * x + u = b, has a second multiplier: A^T y + z - w = 0, u w = mu. A step solves A D A^T dy + w1 ds
 * = r, w1 . dy - ds / d_s = r_s,  D = diag(1 / (z / x + w / u)), more than once with one
 * factorisation. */

#ifndef TP_ASSEMBLAGE_INTERIOR_STATE_H
#define TP_ASSEMBLAGE_INTERIOR_STATE_H

#include "assemblage/normal_equations.h"

#include <math.h>

/* A step beside the one at hand. */
typedef struct tp_interior_step {
  double *dx, *dz, *dw, *dy;
} tp_interior_step;

/* Variables: forces, then s - TP_LEAST_LOAD. */
typedef struct tp_interior {
  const tp_force_program *p;
  tp_normal_equations normal;
  long n;
  double *x, *z, *dx, *dz, *d, *centre, *rd; /* n + 1 */
  double *most, *w, *dw,
      *centre_w; /* n + 1: bounds, an infinity where there is none; then w is 0 */
  long bounded;  /* how many have one */
  double *y, *dy, *rp, *rhs, *live, *solved, *rest, *guess, *way,
      *product;                   /* rows; solved: M0^-1 w1 */
  double rhs_load, mu, live_live; /* w1 . M0^-1 w1 */
  tp_interior_step other;
} tp_interior;

/* Forces of some weight of a block. On failure it is still to be cleared. */
TP_MUST_USE tp_status tp_interior_init(tp_interior *s, const tp_force_program *p,
                                       tp_message *message);
void tp_interior_clear(tp_interior *s);

double tp_interior_dot(const double *a, const double *b, long count);
/* A force on a column, onto the rows of its blocks. */
void tp_interior_add(double *rows, const tp_force_column *c, double force);
/* Has a factor a bound? */
static inline bool tp_interior_is_bounded(const tp_interior *s, long k) {
  return isfinite(s->most[k]);
}
/* The sum of u w after steps of x and of w. */
double tp_interior_bounded_products(const tp_interior *s, double of_x, double of_w);

/* rp, rd and mu. */
void tp_interior_find_residuals(tp_interior *s);
/* dy and ds of both right-hand sides, to a share of the first; or dy of that,
 * and ds = 0, where the load stays. */
void tp_interior_solve(tp_interior *s, bool load_stays, double enough);
/* Forces and twists, nearer to equilibrium and to their conditions, with the load as it is. */
void tp_interior_restore(tp_interior *s);

/* The share of a step, at most all of it, that keeps all above zero by so much of what would not;
 * of forces, what is left to their bounds too. */
double tp_interior_reach(const double *at, const double *step, long count, double damping);
double tp_interior_reach_of_forces(const tp_interior *s, double damping);

#endif
