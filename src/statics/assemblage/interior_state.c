/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* M0 dy + w1 ds = r, w1 . dy - ds / d_s = r_s, M0 = A D A^T, by elimination of dy, and once more
 * for what that leaves: near the collapse M0 is next to singular along its mechanism, and what ds
 * is stays known where dy alone would cancel. */

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

/* A D A^T times v. */
static void multiply(double *product, const tp_interior *s, const double *v) {
  memset(product, 0, (size_t)s->p->rows * sizeof *product);
  for (long k = 0; k < s->n; k++) {
    const double share = s->d[k] * tp_force_column_work(s->p->columns + k, v);
    tp_interior_add(product, s->p->columns + k, share);
  }
}

static void add(double *sum, double share, const double *other, long count) {
  for (long r = 0; r < count; r++) sum[r] += share * other[r];
}

/* By the factor: dy in place of its right-hand side; ds. */
static double eliminate(tp_interior *s, double *rows, double rhs_load, bool load_stays) {
  tp_normal_equations_solve(&s->normal, rows);
  if (load_stays) return 0;
  const double of_rows = tp_interior_dot(s->live, rows, s->p->rows) - rhs_load;
  const double ds = of_rows / (s->live_live + 1 / s->d[s->n]);
  add(rows, -ds, s->solved, s->p->rows);
  return ds;
}

/* What the first elimination leaves, by conjugate gradients: `way` and the ds with it keep the last
 * equation, w1 . dy = ds / d_s. */
static double better(tp_interior *s, double ds, double least, bool load_stays) {
  enum { MOST_ROUNDS = 30 };
  const long rows = s->p->rows;
  double before = 0, way_ds = 0;
  for (int k = 0; k < MOST_ROUNDS && tp_interior_dot(s->rest, s->rest, rows) > least; k++) {
    memcpy(s->guess, s->rest, (size_t)rows * sizeof *s->guess);
    const double guess_ds = eliminate(s, s->guess, 0, load_stays);
    const double power = tp_interior_dot(s->rest, s->guess, rows);
    const double share = k > 0 ? power / before : 0;
    for (long r = 0; r < rows; r++) s->way[r] = s->guess[r] + share * s->way[r];
    way_ds = guess_ds + share * way_ds;
    multiply(s->product, s, s->way);
    const double own = load_stays ? 0 : way_ds * way_ds / s->d[s->n];
    const double length = power / (tp_interior_dot(s->way, s->product, rows) + own);
    if (!(power > 0 && isfinite(length))) break;
    add(s->product, way_ds, s->live, rows);
    add(s->dy, length, s->way, rows);
    add(s->rest, -length, s->product, rows);
    ds += length * way_ds;
    before = power;
  }
  return ds;
}

void tp_interior_solve(tp_interior *s, bool load_stays, double enough) {
  const long rows = s->p->rows;
  const double size = tp_interior_dot(s->rhs, s->rhs, rows);
  memcpy(s->dy, s->rhs, (size_t)rows * sizeof *s->dy);
  const double ds = eliminate(s, s->dy, s->rhs_load, load_stays);
  multiply(s->product, s, s->dy);
  for (long r = 0; r < rows; r++) s->rest[r] = s->rhs[r] - s->product[r] - ds * s->live[r];
  const double found = better(s, ds, enough * enough * size, load_stays);
  s->dx[s->n] = found;
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

/* What is left of the blocks' equilibrium, taken up by the forces, and by the load, in proportion
 * to D: near the collapse a step's own errors are far above those of one so small. And what is left
 * of the twists' conditions, moved from contacts that bear much, where the least would refute a
 * proof, to those that open far. */
void tp_interior_restore(tp_interior *s) {
  enum { ROUNDS = 2 };
  static const double damping = 0.5, enough = 1e-8;
  for (int round = 0; round < ROUNDS; round++) {
    tp_interior_find_residuals(s);
    memcpy(s->rhs, s->rp, (size_t)s->p->rows * sizeof *s->rhs);
    s->rhs_load = 0;
    tp_interior_solve(s, false, enough);
    for (long k = 0; k < s->n; k++)
      s->dx[k] = s->d[k] * tp_force_column_work(s->p->columns + k, s->dy);
    const double share = tp_interior_reach_of_forces(s, damping);
    for (long k = 0; k <= s->n; k++) s->x[k] += share * s->dx[k];
  }
  tp_interior_find_residuals(s);
  memset(s->rhs, 0, (size_t)s->p->rows * sizeof *s->rhs);
  for (long k = 0; k < s->n; k++) tp_interior_add(s->rhs, s->p->columns + k, s->d[k] * s->rd[k]);
  s->rhs_load = s->rd[s->n];
  tp_interior_solve(s, false, enough);
  for (long r = 0; r < s->p->rows; r++) s->y[r] += s->dy[r];
}

void tp_interior_clear(tp_interior *s) {
  double *all[] = {s->x,        s->z,        s->dx,       s->dz,       s->d,
                   s->centre,   s->rd,       s->y,        s->dy,       s->rp,
                   s->rhs,      s->live,     s->solved,   s->rest,     s->most,
                   s->w,        s->dw,       s->centre_w, s->other.dx, s->other.dz,
                   s->other.dw, s->other.dy, s->guess,    s->way,      s->product};
  for (size_t k = 0; k < sizeof all / sizeof all[0]; k++) free(all[k]);
  tp_normal_equations_clear(&s->normal);
}

tp_status tp_interior_init(tp_interior *s, const tp_force_program *p, tp_message *message) {
  s->p = p;
  s->n = p->count;
  double **variables[] = {&s->x,        &s->z,        &s->dx,       &s->dz,      &s->d,
                          &s->centre,   &s->rd,       &s->most,     &s->w,       &s->dw,
                          &s->centre_w, &s->other.dx, &s->other.dz, &s->other.dw};
  double **rows[] = {&s->y,    &s->dy,       &s->rp,    &s->rhs, &s->live,   &s->solved,
                     &s->rest, &s->other.dy, &s->guess, &s->way, &s->product};
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
  static const double force = 10, price = 1; /* weights of a block */
  for (long k = 0; k <= s->n; k++) {
    s->x[k] = force;
    s->z[k] = price;
    s->most[k] = k < s->n ? p->columns[k].most.value : INFINITY;
    if (!tp_interior_is_bounded(s, k)) continue;
    s->x[k] = s->most[k] / 2;
    s->w[k] = s->z[k];
    s->bounded++;
  }
  for (long r = 0; r < p->rows; r++) s->live[r] = p->live[r].value;
  return TP_OK;
}
