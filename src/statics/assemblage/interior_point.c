/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Mehrotra's predictor and corrector (Nocedal and Wright 2006, section 14.2). */

#include "assemblage/interior_point.h"

#include "assemblage/interior_state.h"

#include <math.h>
#include <string.h>

enum { MOST_STEPS = 150 };

/* What the multipliers of the bounds pull a factor by: centre / x, less centre_w / u. */
static double pull_of(const tp_interior *s, long k) {
  const double pull = s->centre[k] / s->x[k];
  return tp_interior_is_bounded(s, k) ? pull - s->centre_w[k] / (s->most[k] - s->x[k]) : pull;
}

/* A dx = rp, A^T dy + dz - dw = rd, z dx + x dz = centre, w du + u dw = centre_w with du = -dx. */
static void find_step(tp_interior *s) {
  const tp_force_program *p = s->p;
  memcpy(s->rhs, s->rp, (size_t)p->rows * sizeof *s->rhs);
  for (long k = 0; k < s->n; k++) {
    tp_interior_add(s->rhs, p->columns + k, s->d[k] * (s->rd[k] - pull_of(s, k)));
  }
  const double own = s->d[s->n] * s->rd[s->n] - s->centre[s->n] / s->z[s->n];
  for (long r = 0; r < p->rows; r++) s->rhs[r] += own * s->live[r];
  tp_interior_solve(s);
  for (long k = 0; k <= s->n; k++) {
    const double power = k < s->n ? tp_force_column_work(p->columns + k, s->dy)
                                  : tp_interior_dot(s->live, s->dy, p->rows);
    if (tp_interior_is_bounded(s, k)) {
      s->dx[k] = s->d[k] * (power - s->rd[k] + pull_of(s, k));
      s->dz[k] = (s->centre[k] - s->z[k] * s->dx[k]) / s->x[k];
      s->dw[k] = (s->centre_w[k] + s->w[k] * s->dx[k]) / (s->most[k] - s->x[k]);
    } else {
      s->dz[k] = s->rd[k] - power;
      s->dx[k] = (s->centre[k] - s->x[k] * s->dz[k]) / s->z[k];
    }
  }
}

static double reach_of_z(const tp_interior *s, double damping) {
  return fmin(tp_interior_reach(s->z, s->dz, s->n + 1, damping),
              tp_interior_reach(s->w, s->dw, s->n, damping));
}

/* Towards the products `target`, less what is there and the products of the step that is known. */
static void set_centre(tp_interior *s, double target, double known) {
  for (long k = 0; k <= s->n; k++) {
    s->centre[k] = target - s->x[k] * s->z[k] - known * s->dx[k] * s->dz[k];
    if (!tp_interior_is_bounded(s, k)) continue;
    s->centre_w[k] = target - (s->most[k] - s->x[k]) * s->w[k] + known * s->dx[k] * s->dw[k];
  }
}

static void predict_and_correct(tp_interior *s) {
  const long count = s->n + 1;
  set_centre(s, 0, 0);
  find_step(s);
  const double of_x = tp_interior_reach_of_forces(s, 1), of_z = reach_of_z(s, 1);
  double after = tp_interior_bounded_products(s, of_x, of_z);
  for (long k = 0; k < count; k++) {
    after += (s->x[k] + of_x * s->dx[k]) * (s->z[k] + of_z * s->dz[k]);
  }
  const double share = after / ((double)(count + s->bounded) * s->mu);
  set_centre(s, share * share * share * s->mu, 1);
  find_step(s);
}

static bool advance(tp_interior *s) {
  static const double damping = 0.99;
  const long count = s->n + 1;
  for (long k = 0; k < count; k++) {
    s->d[k] = tp_interior_is_bounded(s, k)
                  ? 1 / (s->z[k] / s->x[k] + s->w[k] / (s->most[k] - s->x[k]))
                  : s->x[k] / s->z[k];
  }
  if (!tp_normal_equations_factorise(&s->normal, s->d)) return false;
  memcpy(s->solved, s->live, (size_t)s->p->rows * sizeof *s->solved);
  tp_normal_equations_solve(&s->normal, s->solved);
  s->live_live = tp_interior_dot(s->live, s->solved, s->p->rows);
  predict_and_correct(s);
  const double of_x = tp_interior_reach_of_forces(s, damping), of_z = reach_of_z(s, damping);
  for (long k = 0; k < count; k++) {
    s->x[k] += of_x * s->dx[k];
    s->z[k] += of_z * s->dz[k];
    s->w[k] += of_z * s->dw[k];
    if (!(s->x[k] > 0 && s->z[k] > 0 && isfinite(s->x[k]) && isfinite(s->z[k]))) return false;
  }
  for (long r = 0; r < s->p->rows; r++) s->y[r] += of_z * s->dy[r];
  return true;
}

tp_status tp_interior_point(const tp_force_program *p, tp_interior_watch *watch, void *context,
                            tp_message *message) {
  static const double lost = 1e12; /* roundings lead away from what all came near to */
  double first = INFINITY;
  tp_interior s = {.p = NULL};
  const tp_status status = tp_interior_init(&s, p, message);
  bool goes_on = status == TP_OK;
  for (int k = 0; k < MOST_STEPS && goes_on; k++) {
    if (k > 0) tp_interior_restore(&s);
    tp_interior_find_residuals(&s);
    const tp_interior_iterate iterate = {s.x, s.x[s.n] + TP_LEAST_LOAD, s.y,
                                         s.mu * (double)(s.n + 1)};
    const double off = tp_interior_dot(s.rd, s.rd, s.n + 1);
    if (k == 0) first = off;
    goes_on = !watch(context, &iterate) && off <= lost * first && advance(&s);
  }
  tp_interior_clear(&s);
  return status;
}
