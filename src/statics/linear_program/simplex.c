/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Bounded simplex method with three rows and the explicit 3 x 3 inverse of the basis, in two phases
 * with artificial variables; the column of the most negative reduced cost enters. */

#include "linear_program/simplex.h"

#include "plane/vector.h"

#include <math.h>
#include <stddef.h>

/* Three rows take a dozen steps, of many columns some dozens: more is a circle that rounding made.
 * The tolerances below are chosen, not derived: they stand a hundred times and more above the
 * roundings of three products of size 1, 1e-15; a wrong proposal costs time, since all of them are
 * proven or refuted afterwards (certificate/). */
enum { ARTIFICIAL = TP_SIMPLEX_NONE, MOST_STEPS = 1000 };

/* Columns lie in the order of the contact, and those that enter one after the other mostly near one
 * end of it: of many, most steps look at the share of them where the last one was. */
enum { MANY_COLUMNS = 4096, SHARES_OF_MANY = 64 };

typedef struct tableau {
  const tp_simplex_program *program;
  bool *at_most;
  long first_bounded;   /* no column before it is */
  bool first_phase;     /* minimise the sum of the artificial variables */
  bool has_t;           /* false: no direction is given, it is asked for any solution */
  double sign[3];       /* artificial column r is sign[r] times the r-th unit vector */
  long basis[3];        /* ARTIFICIAL - r: the artificial variable of row r */
  double inverse[3][3]; /* of the basis matrix */
  double values[3];
  double size;             /* of what the values are sums of */
  long share_count, share; /* of columns without bound: find_column */
} tableau;

static bool is_artificial(long variable) {
  return variable <= ARTIFICIAL;
}

static double bound(const tableau *s, long variable) {
  if (variable < 0 || s->program->most == NULL) return INFINITY;
  return s->program->most[variable];
}

static double cost(const tableau *s, long variable) {
  if (is_artificial(variable)) return s->first_phase ? 1 : 0;
  return variable == TP_SIMPLEX_T && !s->first_phase ? -1 : 0;
}

/* Row vector of the costs of the basis times its inverse. */
static void prices(const tableau *s, double y[3]) {
  double costs[3];
  for (int r = 0; r < 3; r++) costs[r] = cost(s, s->basis[r]);
  for (int c = 0; c < 3; c++) {
    y[c] = 0;
    for (int r = 0; r < 3; r++) y[c] += costs[r] * s->inverse[r][c];
  }
}

static bool in_basis(const tableau *s, long variable) {
  return s->basis[0] == variable || s->basis[1] == variable || s->basis[2] == variable;
}

/* Of a share of the columns, none of them bounded, the one of the largest gain above `best`, which
 * is raised to it. */
static long find_in_share(const tableau *s, const double y[3], long share, double *best) {
  const tp_simplex_program *p = s->program;
  const long from = p->count * share / s->share_count;
  const long before = p->count * (share + 1) / s->share_count;
  long entering = ARTIFICIAL;
  for (long k = from; k < before; k++) {
    const double gain = tp_double_dot(y, p->columns[k]);
    if (gain <= *best || in_basis(s, k)) continue;
    *best = gain;
    entering = k;
  }
  return entering;
}

/* Of columns without bound the one of the largest gain above `least`: of the share that the last
 * one came from, or where that has none, of all. */
static long find_column(tableau *s, const double y[3], double least) {
  double best = least;
  long entering = find_in_share(s, y, s->share, &best);
  if (entering != ARTIFICIAL) return entering;
  const long known = s->share;
  for (long share = 0; share < s->share_count; share++) {
    const long own = share != known ? find_in_share(s, y, share, &best) : ARTIFICIAL;
    if (own == ARTIFICIAL) continue;
    entering = own;
    s->share = share;
  }
  return entering;
}

/* The variable that lowers the cost most as it moves off its bound, and the way it moves. Costs
 * below rounding, relative to columns and prices of size one, count as nothing. */
static long find_entering(tableau *s, const double y[3], double *way) {
  static const double rounding = 1e-13;
  const tp_simplex_program *p = s->program;
  const double size = fabs(y[0]) + fabs(y[1]) + fabs(y[2]);
  double best = rounding * size;
  long entering = ARTIFICIAL;
  if (s->has_t && !in_basis(s, TP_SIMPLEX_T)) {
    const double reduced = cost(s, TP_SIMPLEX_T) - tp_double_dot(y, p->direction);
    if (fabs(reduced) > best) {
      best = INFINITY; /* t first: it never leaves */
      entering = TP_SIMPLEX_T;
      *way = reduced < 0 ? 1 : -1;
    }
  }
  if (size == 0) return entering; /* no artificial variable is left: nothing gains */
  if (s->at_most == NULL) {
    if (entering == TP_SIMPLEX_T) return entering;
    *way = 1;
    return find_column(s, y, best);
  }
  for (long k = 0; k < p->count && best < INFINITY; k++) {
    const bool high = s->at_most[k];
    const double gain = high ? -tp_double_dot(y, p->columns[k]) : tp_double_dot(y, p->columns[k]);
    if (gain <= best || in_basis(s, k)) continue;
    best = gain;
    entering = k;
    *way = high ? -1 : 1;
  }
  return entering;
}

/* How far the entering variable may move, and what stops it: a row of the basis, or -1 for its own
 * other bound. Of rows that stop it alike, an artificial one goes, then the one of largest pivot.
 */
static double find_leaving(const tableau *s, const double step[3], double way, double own_bound,
                           int *leaving, bool *to_bound) {
  static const double least_pivot = 1e-11;
  double most = own_bound;
  *leaving = -1;
  *to_bound = false;
  for (int r = 0; r < 3; r++) {
    const double rate = way * step[r]; /* the basic variable falls at this rate */
    if (fabs(rate) < least_pivot || s->basis[r] == TP_SIMPLEX_T) continue;
    const double limit = bound(s, s->basis[r]);
    double far = INFINITY;
    if (rate > 0) {
      far = fmax(s->values[r], 0) / rate;
    } else if (is_artificial(s->basis[r]) && !s->first_phase) {
      far = 0; /* what is zero stays zero */
    } else if (isfinite(limit)) {
      far = fmax(limit - s->values[r], 0) / -rate;
    }
    const bool preferred = far == most && *leaving >= 0 && fabs(step[r]) > fabs(step[*leaving]);
    if (far < most || preferred) {
      most = far;
      *leaving = r;
      *to_bound = rate < 0 && !is_artificial(s->basis[r]);
    }
  }
  return most;
}

static void replace(tableau *s, int row, long entering, const double step[3], double value) {
  const double pivot = step[row];
  for (int c = 0; c < 3; c++) s->inverse[row][c] /= pivot;
  for (int r = 0; r < 3; r++) {
    if (r == row) continue;
    for (int c = 0; c < 3; c++) s->inverse[r][c] -= step[r] * s->inverse[row][c];
  }
  s->basis[row] = entering;
  s->values[row] = value;
}

/* Move the entering variable; false where nothing stops it. */
static bool enter(tableau *s, long entering, double way) {
  const tp_simplex_program *p = s->program;
  double step[3];
  const double *column = entering == TP_SIMPLEX_T ? p->direction : p->columns[entering];
  for (int r = 0; r < 3; r++) step[r] = tp_double_dot(s->inverse[r], column);
  int leaving = -1;
  bool to_bound = false;
  const double far = find_leaving(s, step, way, bound(s, entering), &leaving, &to_bound);
  if (!isfinite(far)) return false;
  for (int r = 0; r < 3; r++) s->values[r] -= way * far * step[r];
  const bool was_high = way < 0 && entering >= 0;
  if (leaving < 0) { /* which only a bounded column can */
    if (s->at_most != NULL) s->at_most[entering] = !was_high;
    return true;
  }
  const long out = s->basis[leaving];
  if (out >= 0 && s->at_most != NULL) s->at_most[out] = to_bound;
  if (was_high && s->at_most != NULL) s->at_most[entering] = false;
  replace(s, leaving, entering, step, was_high ? bound(s, entering) - far : way * far);
  return true;
}

/* What is left of the target for the basis, columns at their bound taken off; with the sum of what
 * was rounded away (Neumaier), since thousands may be. */
static void find_rest(tableau *s, double rest[3]) {
  const tp_simplex_program *p = s->program;
  double low[3] = {0, 0, 0};
  s->size = 0;
  for (int r = 0; r < 3; r++) {
    rest[r] = p->target[r];
    s->size += fabs(rest[r]);
  }
  for (long k = s->first_bounded; k < p->count; k++) {
    if (!s->at_most[k]) continue;
    for (int r = 0; r < 3; r++) {
      const double own = -p->most[k] * p->columns[k][r], sum = rest[r] + own;
      low[r] += fabs(rest[r]) >= fabs(own) ? (rest[r] - sum) + own : (own - sum) + rest[r];
      rest[r] = sum;
      s->size = fmax(s->size, fabs(own));
    }
  }
  for (int r = 0; r < 3; r++) rest[r] += low[r];
}

/* One sweep over the bounded columns: each moves as soon as it gains, most of them from bound to
 * bound, which leaves the prices as they are. Thousands of them cost a sweep or two instead of a
 * look at all columns each. */
static bool sweep(tableau *s) {
  static const double rounding = 1e-13;
  const tp_simplex_program *p = s->program;
  double y[3], rest[3];
  if (s->at_most == NULL) return true;
  prices(s, y);
  for (long k = s->first_bounded; k < p->count; k++) {
    const double power = tp_double_dot(y, p->columns[k]), gain = s->at_most[k] ? -power : power;
    if (gain <= rounding * (fabs(y[0]) + fabs(y[1]) + fabs(y[2])) || in_basis(s, k)) continue;
    if (!isfinite(p->most[k])) continue;
    if (!enter(s, k, s->at_most[k] ? -1 : 1)) return false;
    prices(s, y);
  }
  find_rest(s, rest);
  for (int r = 0; r < 3; r++) s->values[r] = tp_double_dot(s->inverse[r], rest);
  return true;
}

/* One step; false at the end, with the outcome. */
static bool advance(tableau *s, tp_simplex_outcome *outcome) {
  double y[3], way = 1;
  prices(s, y);
  const long entering = find_entering(s, y, &way);
  *outcome = entering == ARTIFICIAL ? TP_SIMPLEX_OPTIMAL : TP_SIMPLEX_UNBOUNDED;
  if (entering == ARTIFICIAL || !enter(s, entering, way)) return false;
  return entering < 0 || !isfinite(bound(s, entering)) || sweep(s);
}

static void begin(tableau *s) {
  const tp_simplex_program *p = s->program;
  double rest[3];
  s->first_bounded = p->count;
  for (long k = p->count - 1; k >= 0 && s->at_most != NULL; k--) {
    if (isfinite(p->most[k])) {
      s->first_bounded = k;
    } else {
      s->at_most[k] = false;
    }
  }
  find_rest(s, rest);
  for (int r = 0; r < 3; r++) {
    s->sign[r] = rest[r] < 0 ? -1 : 1;
    s->basis[r] = ARTIFICIAL - r;
    s->inverse[r][r] = s->sign[r];
    s->values[r] = fabs(rest[r]);
  }
}

static double infeasibility(const tableau *s) {
  double sum = 0;
  for (int r = 0; r < 3; r++) sum += is_artificial(s->basis[r]) ? fabs(s->values[r]) : 0;
  return sum;
}

tp_simplex_answer tp_simplex_solve(const tp_simplex_program *program, bool *at_most) {
  static const double rounding = 1e-12;
  tableau s = {.program = program,
               .at_most = program->most != NULL ? at_most : NULL,
               .first_phase = true,
               .share_count = program->count < MANY_COLUMNS ? 1 : SHARES_OF_MANY,
               .has_t = tp_double_dot(program->direction, program->direction) > 0};
  tp_simplex_answer answer = {.outcome = TP_SIMPLEX_STUCK};
  begin(&s);
  int steps = 0;
  while (steps < MOST_STEPS && advance(&s, &answer.outcome)) steps++;
  const bool feasible = infeasibility(&s) <= rounding * s.size;
  if (steps < MOST_STEPS && feasible) {
    s.first_phase = false;
    while (steps < MOST_STEPS && advance(&s, &answer.outcome)) steps++;
  }
  if (steps == MOST_STEPS) {
    answer.outcome = TP_SIMPLEX_STUCK;
  } else if (!feasible) {
    answer.outcome = TP_SIMPLEX_INFEASIBLE;
  }
  double y[3];
  prices(&s, y);
  for (int r = 0; r < 3; r++) {
    answer.basis[r] = is_artificial(s.basis[r]) ? TP_SIMPLEX_NONE : s.basis[r];
    answer.values[r] = s.values[r];
    answer.dual[r] = -y[r];
    if (s.basis[r] == TP_SIMPLEX_T) answer.t = s.values[r];
  }
  return answer;
}
