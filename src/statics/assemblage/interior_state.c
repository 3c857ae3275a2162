/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The normal equations are solved by their factor and conjugate gradients after it. */

#include "assemblage/interior_state.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

double tp_interior_dot(const double *a, const double *b, long count) {
  double sum = 0;
  for (long k = 0; k < count; k++) sum += a[k] * b[k];
  return sum;
}

void tp_interior_add(double *rows, const tp_force_column *c, double force) {
  for (int k = 0; k < 2; k++) {
    if (c->row[k] < 0) continue;
    for (int e = 0; e < 3; e++) rows[c->row[k] + e] += force * c->entry[k][e].value;
  }
}

/* The sum of u w after steps of x and of w. */
double tp_interior_bounded_products(const tp_interior *s, double of_x, double of_w) {
  double sum = 0;
  for (long k = 0; k < s->n && s->bounded > 0; k++) {
    if (!tp_interior_is_bounded(s, k)) continue;
    sum += (s->most[k] - s->x[k] - of_x * s->dx[k]) * (s->w[k] + of_w * s->dw[k]);
  }
  return sum;
}

void tp_interior_find_residuals(tp_interior *s) {
  const tp_force_program *p = s->p;
  for (long r = 0; r < p->rows; r++)
    s->rp[r] = -p->dead[r].value - (s->x[s->n] + TP_LEAST_LOAD) * s->live[r];
  for (long k = 0; k < s->n; k++) {
    tp_interior_add(s->rp, p->columns + k, -s->x[k]);
    s->rd[k] = -tp_force_column_work(p->columns + k, s->y) - s->z[k] + s->w[k];
  }
  s->rd[s->n] = -1 - tp_interior_dot(s->live, s->y, p->rows) - s->z[s->n];
  s->mu = (tp_interior_dot(s->x, s->z, s->n + 1) + tp_interior_bounded_products(s, 0, 0)) /
          (double)(s->n + 1 + s->bounded);
}

/* M0^-1 of r less what s adds (Sherman and Morrison). */
static void solve_once(tp_interior *s, double *own) {
  tp_normal_equations_solve(&s->normal, own);
  const double share =
      s->d[s->n] * tp_interior_dot(s->live, own, s->p->rows) / (1 + s->d[s->n] * s->live_live);
  for (long r = 0; r < s->p->rows; r++) own[r] -= share * s->solved[r];
}

/* The normal equations times v. */
static void multiply(double *product, const tp_interior *s, const double *v) {
  const long rows = s->p->rows;
  const double share = s->d[s->n] * tp_interior_dot(s->live, v, rows);
  for (long r = 0; r < rows; r++) product[r] = share * s->live[r];
  for (long k = 0; k < s->n; k++) {
    tp_interior_add(product, s->p->columns + k,
                    s->d[k] * tp_force_column_work(s->p->columns + k, v));
  }
}

/* dy of the right-hand side: by conjugate gradients, preconditioned by the factor, as near the
 * collapse what the formula subtracts cancels. */
void tp_interior_solve(tp_interior *s) {
  enum { MOST_ROUNDS = 30 };
  static const double enough = 1e-14;
  const long rows = s->p->rows;
  double *rest = s->rest, *guess = s->guess, *way = s->way, *product = s->product;
  memcpy(rest, s->rhs, (size_t)rows * sizeof *rest);
  memset(s->dy, 0, (size_t)rows * sizeof *s->dy);
  const double size = tp_interior_dot(rest, rest, rows);
  double before = 0;
  for (int round = 0;
       round < MOST_ROUNDS && tp_interior_dot(rest, rest, rows) > enough * enough * size; round++) {
    memcpy(guess, rest, (size_t)rows * sizeof *guess);
    solve_once(s, guess);
    const double power = tp_interior_dot(rest, guess, rows), share = round > 0 ? power / before : 0;
    for (long r = 0; r < rows; r++) way[r] = guess[r] + share * way[r];
    multiply(product, s, way);
    const double length = power / tp_interior_dot(way, product, rows);
    if (!(power > 0 && isfinite(length))) break;
    for (long r = 0; r < rows; r++) {
      s->dy[r] += length * way[r];
      rest[r] -= length * product[r];
    }
    before = power;
  }
}

/* The share of a step, at most all of it, that keeps all above zero by so much of what would not.
 */
double tp_interior_reach(const double *at, const double *step, long count, double damping) {
  double most = INFINITY;
  for (long k = 0; k < count; k++) {
    if (step[k] < 0) most = fmin(most, -at[k] / step[k]);
  }
  return fmin(1, damping * most);
}

/* The share of a step of x that keeps what is left to its bounds above zero too. */
double tp_interior_reach_of_forces(const tp_interior *s, double damping) {
  double most = tp_interior_reach(s->x, s->dx, s->n + 1, damping);
  for (long k = 0; k < s->n && s->bounded > 0; k++) {
    if (tp_interior_is_bounded(s, k) && s->dx[k] > 0) {
      most = fmin(most, damping * (s->most[k] - s->x[k]) / s->dx[k]);
    }
  }
  return most;
}

/* What is left of the blocks' equilibrium, taken up by the forces in proportion to D with the load
 * as it is: near the collapse a step's own errors are far above those of one so small. And what is
 * left of the twists' conditions, moved from contacts that bear much, where the least would refute
 * a proof, to those that open far. */
void tp_interior_restore(tp_interior *s) {
  enum { ROUNDS = 2 };
  static const double damping = 0.5;
  const double of_load = s->d[s->n];
  s->d[s->n] = 0;
  for (int round = 0; round < ROUNDS; round++) {
    tp_interior_find_residuals(s);
    memcpy(s->rhs, s->rp, (size_t)s->p->rows * sizeof *s->rhs);
    tp_interior_solve(s);
    for (long k = 0; k < s->n; k++)
      s->dx[k] = s->d[k] * tp_force_column_work(s->p->columns + k, s->dy);
    s->dx[s->n] = 0;
    const double share = tp_interior_reach_of_forces(s, damping);
    for (long k = 0; k < s->n; k++) s->x[k] += share * s->dx[k];
  }
  tp_interior_find_residuals(s);
  memset(s->rhs, 0, (size_t)s->p->rows * sizeof *s->rhs);
  for (long k = 0; k < s->n; k++) tp_interior_add(s->rhs, s->p->columns + k, s->d[k] * s->rd[k]);
  tp_interior_solve(s);
  for (long r = 0; r < s->p->rows; r++) s->y[r] += s->dy[r];
  s->d[s->n] = of_load;
}

void tp_interior_clear(tp_interior *s) {
  double *all[] = {s->x,     s->z,   s->dx,      s->dz,   s->d,    s->centre, s->rd,
                   s->y,     s->dy,  s->rp,      s->rhs,  s->live, s->solved, s->rest,
                   s->guess, s->way, s->product, s->most, s->w,    s->dw,     s->centre_w};
  for (size_t k = 0; k < sizeof all / sizeof all[0]; k++) free(all[k]);
  tp_normal_equations_clear(&s->normal);
}

tp_status tp_interior_init(tp_interior *s, const tp_force_program *p, tp_message *message) {
  s->p = p;
  s->n = p->count;
  double **variables[] = {&s->x,  &s->z,    &s->dx, &s->dz, &s->d,       &s->centre,
                          &s->rd, &s->most, &s->w,  &s->dw, &s->centre_w};
  double **rows[] = {&s->y,      &s->dy,   &s->rp,    &s->rhs, &s->live,
                     &s->solved, &s->rest, &s->guess, &s->way, &s->product};
  const tp_status status = tp_normal_equations_init(&s->normal, p, message);
  if (status != TP_OK) return status;
  bool done = true;
  for (size_t k = 0; k < sizeof variables / sizeof variables[0]; k++) {
    *variables[k] = calloc((size_t)s->n + 1, sizeof(double));
    done = done && *variables[k] != NULL;
  }
  for (size_t k = 0; k < sizeof rows / sizeof rows[0]; k++) {
    *rows[k] = calloc((size_t)p->rows + 1, sizeof(double));
    done = done && *rows[k] != NULL;
  }
  if (!done) return tp_fail_memory(message, "the forces between blocks");
  for (long k = 0; k <= s->n; k++) {
    s->x[k] = 2; /* forces of some weight of a block */
    s->z[k] = 1;
    s->most[k] = k < s->n ? p->columns[k].most.value : INFINITY;
    if (!tp_interior_is_bounded(s, k)) continue;
    s->x[k] = s->most[k] / 2;
    s->w[k] = 1;
    s->bounded++;
  }
  for (long r = 0; r < p->rows; r++) s->live[r] = p->live[r].value;
  return TP_OK;
}
