/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* minimise -s:  A f + s w1 = -w0,  A^T y + z_f = 0,  w1 . y + z_s = -1,  x z = mu, with s + 1 as
 * the last variable: what falls without the load has a limit below zero. A factor that is bounded,
 * x + u = b, has a second multiplier: A^T y + z - w = 0, u w = mu. A step solves (A D A^T + d_s w1
 * w1^T) dy = r,  D = diag(1 / (z / x + w / u)), twice with one factorisation. */

#include "assemblage/interior_point.h"

#include "assemblage/normal_equations.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_STEPS = 150 };

/* Variables: forces, then s - TP_LEAST_LOAD. */
typedef struct interior {
  const tp_force_program *p;
  tp_normal_equations normal;
  long n;
  double *x, *z, *dx, *dz, *d, *centre, *rd; /* n + 1 */
  double *most, *w, *dw,
      *centre_w; /* n + 1: bounds, an infinity where there is none; then w is 0 */
  long bounded;  /* how many have one */
  double *y, *dy, *rp, *rhs, *live, *solved, *rest, *guess, *way, *product; /* rows */
  double mu, live_live;                                                     /* w1 . M0^-1 w1 */
} interior;

static double dot(const double *a, const double *b, long count) {
  double sum = 0;
  for (long k = 0; k < count; k++) sum += a[k] * b[k];
  return sum;
}

static void add_column(double *rows, const tp_force_column *c, double force) {
  for (int k = 0; k < 2; k++) {
    if (c->row[k] < 0) continue;
    for (int e = 0; e < 3; e++) rows[c->row[k] + e] += force * c->entry[k][e].value;
  }
}

static bool is_bounded(const interior *s, long k) {
  return isfinite(s->most[k]);
}

/* The sum of u w after steps of x and of w. */
static double bounded_products(const interior *s, double of_x, double of_w) {
  double sum = 0;
  for (long k = 0; k < s->n && s->bounded > 0; k++) {
    if (!is_bounded(s, k)) continue;
    sum += (s->most[k] - s->x[k] - of_x * s->dx[k]) * (s->w[k] + of_w * s->dw[k]);
  }
  return sum;
}

static void find_residuals(interior *s) {
  const tp_force_program *p = s->p;
  for (long r = 0; r < p->rows; r++)
    s->rp[r] = -p->dead[r].value - (s->x[s->n] + TP_LEAST_LOAD) * s->live[r];
  for (long k = 0; k < s->n; k++) {
    add_column(s->rp, p->columns + k, -s->x[k]);
    s->rd[k] = -tp_force_column_work(p->columns + k, s->y) - s->z[k] + s->w[k];
  }
  s->rd[s->n] = -1 - dot(s->live, s->y, p->rows) - s->z[s->n];
  s->mu = (dot(s->x, s->z, s->n + 1) + bounded_products(s, 0, 0)) / (double)(s->n + 1 + s->bounded);
}

/* M0^-1 of r less what s adds (Sherman and Morrison). */
static void solve_once(interior *s, double *own) {
  tp_normal_equations_solve(&s->normal, own);
  const double share = s->d[s->n] * dot(s->live, own, s->p->rows) / (1 + s->d[s->n] * s->live_live);
  for (long r = 0; r < s->p->rows; r++) own[r] -= share * s->solved[r];
}

/* The normal equations times v. */
static void multiply(double *product, const interior *s, const double *v) {
  const long rows = s->p->rows;
  const double share = s->d[s->n] * dot(s->live, v, rows);
  for (long r = 0; r < rows; r++) product[r] = share * s->live[r];
  for (long k = 0; k < s->n; k++) {
    add_column(product, s->p->columns + k, s->d[k] * tp_force_column_work(s->p->columns + k, v));
  }
}

/* dy of the right-hand side: by conjugate gradients, preconditioned by the factor, as near the
 * collapse what the formula subtracts cancels. */
static void solve(interior *s) {
  enum { MOST_ROUNDS = 30 };
  static const double enough = 1e-14;
  const long rows = s->p->rows;
  double *rest = s->rest, *guess = s->guess, *way = s->way, *product = s->product;
  memcpy(rest, s->rhs, (size_t)rows * sizeof *rest);
  memset(s->dy, 0, (size_t)rows * sizeof *s->dy);
  const double size = dot(rest, rest, rows);
  double before = 0;
  for (int round = 0; round < MOST_ROUNDS && dot(rest, rest, rows) > enough * enough * size;
       round++) {
    memcpy(guess, rest, (size_t)rows * sizeof *guess);
    solve_once(s, guess);
    const double power = dot(rest, guess, rows), share = round > 0 ? power / before : 0;
    for (long r = 0; r < rows; r++) way[r] = guess[r] + share * way[r];
    multiply(product, s, way);
    const double length = power / dot(way, product, rows);
    if (!(power > 0 && isfinite(length))) break;
    for (long r = 0; r < rows; r++) {
      s->dy[r] += length * way[r];
      rest[r] -= length * product[r];
    }
    before = power;
  }
}

/* What the multipliers of the bounds pull a factor by: centre / x, less centre_w / u. */
static double pull_of(const interior *s, long k) {
  const double pull = s->centre[k] / s->x[k];
  return is_bounded(s, k) ? pull - s->centre_w[k] / (s->most[k] - s->x[k]) : pull;
}

/* A dx = rp, A^T dy + dz - dw = rd, z dx + x dz = centre, w du + u dw = centre_w with du = -dx. */
static void find_step(interior *s) {
  const tp_force_program *p = s->p;
  memcpy(s->rhs, s->rp, (size_t)p->rows * sizeof *s->rhs);
  for (long k = 0; k < s->n; k++) {
    add_column(s->rhs, p->columns + k, s->d[k] * (s->rd[k] - pull_of(s, k)));
  }
  const double own = s->d[s->n] * s->rd[s->n] - s->centre[s->n] / s->z[s->n];
  for (long r = 0; r < p->rows; r++) s->rhs[r] += own * s->live[r];
  solve(s);
  for (long k = 0; k <= s->n; k++) {
    const double power =
        k < s->n ? tp_force_column_work(p->columns + k, s->dy) : dot(s->live, s->dy, p->rows);
    if (is_bounded(s, k)) {
      s->dx[k] = s->d[k] * (power - s->rd[k] + pull_of(s, k));
      s->dz[k] = (s->centre[k] - s->z[k] * s->dx[k]) / s->x[k];
      s->dw[k] = (s->centre_w[k] + s->w[k] * s->dx[k]) / (s->most[k] - s->x[k]);
    } else {
      s->dz[k] = s->rd[k] - power;
      s->dx[k] = (s->centre[k] - s->x[k] * s->dz[k]) / s->z[k];
    }
  }
}

/* The share of a step, at most all of it, that keeps all above zero by so much of what would not.
 */
static double reach(const double *at, const double *step, long count, double damping) {
  double most = INFINITY;
  for (long k = 0; k < count; k++) {
    if (step[k] < 0) most = fmin(most, -at[k] / step[k]);
  }
  return fmin(1, damping * most);
}

/* The share of a step of x that keeps what is left to its bounds above zero too. */
static double reach_of_x(const interior *s, double damping) {
  double most = reach(s->x, s->dx, s->n + 1, damping);
  for (long k = 0; k < s->n && s->bounded > 0; k++) {
    if (is_bounded(s, k) && s->dx[k] > 0) {
      most = fmin(most, damping * (s->most[k] - s->x[k]) / s->dx[k]);
    }
  }
  return most;
}

static double reach_of_z(const interior *s, double damping) {
  return fmin(reach(s->z, s->dz, s->n + 1, damping), reach(s->w, s->dw, s->n, damping));
}

/* Towards the products `target`, less what is there and the products of the step that is known. */
static void set_centre(interior *s, double target, double known) {
  for (long k = 0; k <= s->n; k++) {
    s->centre[k] = target - s->x[k] * s->z[k] - known * s->dx[k] * s->dz[k];
    if (!is_bounded(s, k)) continue;
    s->centre_w[k] = target - (s->most[k] - s->x[k]) * s->w[k] + known * s->dx[k] * s->dw[k];
  }
}

static void predict_and_correct(interior *s) {
  const long count = s->n + 1;
  set_centre(s, 0, 0);
  find_step(s);
  const double of_x = reach_of_x(s, 1), of_z = reach_of_z(s, 1);
  double after = bounded_products(s, of_x, of_z);
  for (long k = 0; k < count; k++) {
    after += (s->x[k] + of_x * s->dx[k]) * (s->z[k] + of_z * s->dz[k]);
  }
  const double share = after / ((double)(count + s->bounded) * s->mu);
  set_centre(s, share * share * share * s->mu, 1);
  find_step(s);
}

/* What is left of the blocks' equilibrium, taken up by the forces in proportion to D with the load
 * as it is: near the collapse a step's own errors are far above those of one so small. And what is
 * left of the twists' conditions, moved from contacts that bear much, where the least would refute
 * a proof, to those that open far. */
static void restore(interior *s) {
  enum { ROUNDS = 2 };
  static const double damping = 0.5;
  const double of_load = s->d[s->n];
  s->d[s->n] = 0;
  for (int round = 0; round < ROUNDS; round++) {
    find_residuals(s);
    memcpy(s->rhs, s->rp, (size_t)s->p->rows * sizeof *s->rhs);
    solve(s);
    for (long k = 0; k < s->n; k++)
      s->dx[k] = s->d[k] * tp_force_column_work(s->p->columns + k, s->dy);
    s->dx[s->n] = 0;
    const double share = reach_of_x(s, damping);
    for (long k = 0; k < s->n; k++) s->x[k] += share * s->dx[k];
  }
  find_residuals(s);
  memset(s->rhs, 0, (size_t)s->p->rows * sizeof *s->rhs);
  for (long k = 0; k < s->n; k++) add_column(s->rhs, s->p->columns + k, s->d[k] * s->rd[k]);
  solve(s);
  for (long r = 0; r < s->p->rows; r++) s->y[r] += s->dy[r];
  s->d[s->n] = of_load;
}

static bool advance(interior *s) {
  static const double damping = 0.99;
  const long count = s->n + 1;
  for (long k = 0; k < count; k++) {
    s->d[k] = is_bounded(s, k) ? 1 / (s->z[k] / s->x[k] + s->w[k] / (s->most[k] - s->x[k]))
                               : s->x[k] / s->z[k];
  }
  if (!tp_normal_equations_factorise(&s->normal, s->d)) return false;
  memcpy(s->solved, s->live, (size_t)s->p->rows * sizeof *s->solved);
  tp_normal_equations_solve(&s->normal, s->solved);
  s->live_live = dot(s->live, s->solved, s->p->rows);
  predict_and_correct(s);
  const double of_x = reach_of_x(s, damping), of_z = reach_of_z(s, damping);
  for (long k = 0; k < count; k++) {
    s->x[k] += of_x * s->dx[k];
    s->z[k] += of_z * s->dz[k];
    s->w[k] += of_z * s->dw[k];
    if (!(s->x[k] > 0 && s->z[k] > 0 && isfinite(s->x[k]) && isfinite(s->z[k]))) return false;
  }
  for (long r = 0; r < s->p->rows; r++) s->y[r] += of_z * s->dy[r];
  return true;
}

static void clear(interior *s) {
  double *all[] = {s->x,     s->z,   s->dx,      s->dz,   s->d,    s->centre, s->rd,
                   s->y,     s->dy,  s->rp,      s->rhs,  s->live, s->solved, s->rest,
                   s->guess, s->way, s->product, s->most, s->w,    s->dw,     s->centre_w};
  for (size_t k = 0; k < sizeof all / sizeof all[0]; k++) free(all[k]);
  tp_normal_equations_clear(&s->normal);
}

static tp_status make(interior *s, const tp_force_program *p, tp_message *message) {
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
    if (!is_bounded(s, k)) continue;
    s->x[k] = s->most[k] / 2;
    s->w[k] = 1;
    s->bounded++;
  }
  for (long r = 0; r < p->rows; r++) s->live[r] = p->live[r].value;
  return TP_OK;
}

tp_status tp_interior_point(const tp_force_program *p, tp_interior_watch *watch, void *context,
                            tp_message *message) {
  static const double lost = 1e12; /* roundings lead away from what all came near to */
  double first = INFINITY;
  interior s = {.p = NULL};
  const tp_status status = make(&s, p, message);
  bool goes_on = status == TP_OK;
  for (int k = 0; k < MOST_STEPS && goes_on; k++) {
    if (k > 0) restore(&s);
    find_residuals(&s);
    const tp_interior_iterate iterate = {s.x, s.x[s.n] + TP_LEAST_LOAD, s.y,
                                         s.mu * (double)(s.n + 1)};
    const double off = dot(s.rd, s.rd, s.n + 1);
    if (k == 0) first = off;
    goes_on = !watch(context, &iterate) && off <= lost * first && advance(&s);
  }
  clear(&s);
  return status;
}

/* ---- towards the centre ------------------------------------------------------------------------
 */

/* minimise -sum log x - sum log u, by Newton's method: with H = diag(1 / x^2 + 1 / u^2), D = H^-1
 * and the gradient g = 1 / u - 1 / x,  dx = -D (g + A^T y),  A D A^T y = -A D g - rp. */
static double gradient_of(const interior *s, long k) {
  return is_bounded(s, k) ? 1 / (s->most[k] - s->x[k]) - 1 / s->x[k] : -1 / s->x[k];
}

static bool recentre(interior *s) {
  static const double damping = 0.9;
  const tp_force_program *p = s->p;
  for (long k = 0; k < s->n; k++) {
    const double rest = s->most[k] - s->x[k];
    s->d[k] =
        is_bounded(s, k) ? 1 / (1 / (s->x[k] * s->x[k]) + 1 / (rest * rest)) : s->x[k] * s->x[k];
  }
  if (!tp_normal_equations_factorise(&s->normal, s->d)) return false;
  s->d[s->n] = 0; /* the load stays */
  for (long r = 0; r < p->rows; r++) s->rhs[r] = -s->rp[r];
  for (long k = 0; k < s->n; k++) {
    add_column(s->rhs, p->columns + k, -s->d[k] * gradient_of(s, k));
  }
  solve(s);
  for (long k = 0; k < s->n; k++) {
    s->dx[k] = -s->d[k] * (gradient_of(s, k) + tp_force_column_work(p->columns + k, s->dy));
  }
  s->dx[s->n] = 0;
  const double share = reach_of_x(s, damping);
  for (long k = 0; k < s->n; k++) {
    s->x[k] += share * s->dx[k];
    if (!(s->x[k] > 0 && isfinite(s->x[k]))) return false;
  }
  return true;
}

tp_status tp_interior_centre(const tp_force_program *p, const double *forces, double load,
                             tp_interior_watch *watch, void *context, tp_message *message) {
  enum { MOST = 60 };
  interior s = {.p = NULL};
  const tp_status status = make(&s, p, message);
  bool goes_on = status == TP_OK;
  if (goes_on) {
    memcpy(s.x, forces, (size_t)s.n * sizeof *s.x);
    s.x[s.n] = load - TP_LEAST_LOAD;
  }
  for (int k = 0; k < MOST && goes_on; k++) {
    if (k > 0) restore(&s);
    find_residuals(&s);
    const tp_interior_iterate iterate = {s.x, load, s.y, 0};
    goes_on = !watch(context, &iterate) && recentre(&s);
  }
  clear(&s);
  return status;
}
