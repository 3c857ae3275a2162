/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Mehrotra's predictor and corrector (Nocedal and Wright 2006, section 14.2). */

#include "assemblage/interior_point.h"

#include "assemblage/interior_start.h"
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
static void find_step(tp_interior *s, double enough) {
  const tp_force_program *p = s->p;
  memcpy(s->rhs, s->rp, (size_t)p->rows * sizeof *s->rhs);
  for (long k = 0; k < s->n; k++) {
    tp_interior_add(s->rhs, p->columns + k, s->d[k] * (s->rd[k] - pull_of(s, k)));
  }
  s->rhs_load = s->rd[s->n] - s->centre[s->n] / s->x[s->n];
  tp_interior_solve(s, false, enough);
  s->dz[s->n] = (s->centre[s->n] - s->z[s->n] * s->dx[s->n]) / s->x[s->n];
  for (long k = 0; k < s->n; k++) {
    const double power = tp_force_column_work(p->columns + k, s->dy);
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

/* A share of all products, towards which they are corrected. */
static double predict(tp_interior *s) {
  static const double enough = 1e-4;
  const long count = s->n + 1;
  set_centre(s, 0, 0);
  find_step(s, enough);
  const double of_x = tp_interior_reach_of_forces(s, 1), of_z = reach_of_z(s, 1);
  double after = tp_interior_bounded_products(s, of_x, of_z);
  for (long k = 0; k < count; k++) {
    after += (s->x[k] + of_x * s->dx[k]) * (s->z[k] + of_z * s->dz[k]);
  }
  return after / ((double)(count + s->bounded) * s->mu);
}

static void swap_step(tp_interior *s) {
  const tp_interior_step own = {s->dx, s->dz, s->dw, s->dy};
  s->dx = s->other.dx;
  s->dz = s->other.dz;
  s->dw = s->other.dw;
  s->dy = s->other.dy;
  s->other = own;
}

/* By how much a product is to change, to be within ten times the target; of a large one no more
 * than that much less. */
static double correction(double product, double target) {
  static const double unlike = 10;
  if (product < target / unlike) return target / unlike - product;
  return product > unlike * target ? fmax(unlike * target - product, -unlike * target) : 0;
}

/* Products that a longer step would throw far off are aimed at once more, with the same factor
 * (Gondzio 1996); kept where the step gets longer by it. */
static bool centre_again(tp_interior *s, double target) {
  static const double longer = 0.1, gain = 0.01, enough = 1e-6;
  const double x_now = tp_interior_reach_of_forces(s, 1), z_now = reach_of_z(s, 1);
  const double of_x = fmin(1, x_now + longer), of_z = fmin(1, z_now + longer);
  if (x_now + z_now >= 2 - longer) return false;
  for (long k = 0; k <= s->n; k++) {
    const double z = s->z[k] + of_z * s->dz[k];
    s->centre[k] += correction((s->x[k] + of_x * s->dx[k]) * z, target);
    if (!tp_interior_is_bounded(s, k)) continue;
    const double w = s->w[k] + of_z * s->dw[k];
    s->centre_w[k] += correction((s->most[k] - s->x[k] - of_x * s->dx[k]) * w, target);
  }
  swap_step(s);
  find_step(s, enough);
  const double x_then = tp_interior_reach_of_forces(s, 1), z_then = reach_of_z(s, 1);
  const bool is_longer = x_then + z_then >= x_now + z_now + gain;
  if (!is_longer) swap_step(s);
  return is_longer;
}

static void find_long_step(tp_interior *s) {
  enum { MOST_CENTRINGS = 2 };
  static const double enough = 1e-8;
  const double share = predict(s), target = share * share * share * s->mu;
  set_centre(s, target, 1);
  find_step(s, enough);
  for (int k = 0; k < MOST_CENTRINGS && centre_again(s, target); k++) continue;
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
  find_long_step(s);
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

/* Kept for others, by the gap over the load, or over a thousandth if that is more. */
static tp_status keep(const tp_interior_from *from, const tp_interior *s,
                      const tp_interior_iterate *at, tp_message *message) {
  static const double least = 1e-3;
  if (from->start == NULL) return TP_OK;
  const double gap = at->gap / fmax(fabs(at->load), least);
  return tp_interior_keep(from->start, s, gap, from->at)
             ? TP_OK
             : tp_fail_memory(message, "the forces between blocks");
}

tp_status tp_interior_point(bool *began_near, const tp_force_program *p,
                            const tp_interior_from *from, tp_interior_watch *watch, void *context,
                            tp_message *message) {
  static const double lost = 1e12; /* roundings lead away from what all came near to */
  tp_interior s = {.p = NULL};
  tp_status status = tp_interior_init(&s, p, message);
  double first = (double)s.n;
  bool goes_on = status == TP_OK;
  *began_near = goes_on && from->start != NULL && tp_interior_begin(&s, from->start, from->at);
  for (int k = 0; k < MOST_STEPS && goes_on; k++) {
    if (k > 0) tp_interior_restore(&s);
    tp_interior_find_residuals(&s);
    const tp_interior_iterate iterate = {s.x, s.x[s.n] + TP_LEAST_LOAD, s.y,
                                         s.mu * (double)(s.n + 1)};
    const double off = tp_interior_dot(s.rd, s.rd, s.n + 1);
    if (k == 0) first = fmax(first, off);
    goes_on = !watch(context, &iterate) && off <= lost * first;
    if (goes_on) status = keep(from, &s, &iterate, message);
    goes_on = goes_on && status == TP_OK && advance(&s);
  }
  tp_interior_clear(&s);
  return status;
}
