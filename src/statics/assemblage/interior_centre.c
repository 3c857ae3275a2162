/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* minimise -sum log x - sum log u, by Newton's method: with H = diag(1 / x^2 + 1 / u^2), D = H^-1
 * and the gradient g = 1 / u - 1 / x,  dx = -D (g + A^T y),  A D A^T y = -A D g - rp. */

#include "assemblage/interior_point.h"
#include "assemblage/interior_state.h"

#include <math.h>
#include <string.h>

static double gradient_of(const tp_interior *s, long k) {
  return tp_interior_is_bounded(s, k) ? 1 / (s->most[k] - s->x[k]) - 1 / s->x[k] : -1 / s->x[k];
}

static bool recentre(tp_interior *s) {
  static const double damping = 0.9, enough = 1e-12;
  const tp_force_program *p = s->p;
  for (long k = 0; k < s->n; k++) {
    const double rest = s->most[k] - s->x[k];
    s->d[k] = tp_interior_is_bounded(s, k) ? 1 / (1 / (s->x[k] * s->x[k]) + 1 / (rest * rest))
                                           : s->x[k] * s->x[k];
  }
  if (!tp_normal_equations_factorise(&s->normal, s->d)) return false;
  for (long r = 0; r < p->rows; r++) s->rhs[r] = -s->rp[r];
  for (long k = 0; k < s->n; k++) {
    tp_interior_add(s->rhs, p->columns + k, -s->d[k] * gradient_of(s, k));
  }
  tp_interior_solve(s, true, enough);
  for (long k = 0; k < s->n; k++) {
    s->dx[k] = -s->d[k] * (gradient_of(s, k) + tp_force_column_work(p->columns + k, s->dy));
  }
  s->dx[s->n] = 0;
  const double share = tp_interior_reach_of_forces(s, damping);
  for (long k = 0; k < s->n; k++) {
    s->x[k] += share * s->dx[k];
    if (!(s->x[k] > 0 && isfinite(s->x[k]))) return false;
  }
  return true;
}

tp_status tp_interior_centre(const tp_force_program *p, const double *forces, double load,
                             tp_interior_watch *watch, void *context, tp_message *message) {
  enum { MOST = 60 };
  tp_interior s = {.p = NULL};
  const tp_status status = tp_interior_init(&s, p, message);
  bool goes_on = status == TP_OK;
  if (goes_on) {
    memcpy(s.x, forces, (size_t)s.n * sizeof *s.x);
    s.x[s.n] = load - TP_LEAST_LOAD;
  }
  for (int k = 0; k < MOST && goes_on; k++) {
    if (k > 0) tp_interior_restore(&s);
    tp_interior_find_residuals(&s);
    const tp_interior_iterate iterate = {s.x, load, s.y, 0};
    goes_on = !watch(context, &iterate) && recentre(&s);
  }
  tp_interior_clear(&s);
  return status;
}
