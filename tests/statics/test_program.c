/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Linear programs of three rows: the exact solver against all bases, the simplex method in doubles
 * against the exact solver. */

#include "linear_program/precise_step.h"
#include "linear_program/simplex.h"
#include "random_numbers.h"
#include "suite.h"

#include "geom/geom.h"

#include <flint/fmpq_mat.h>
#include <flint/fmpq_vec.h>
#include <math.h>
#include <string.h>

enum { MOST = 12 };

static random_numbers state;

/* A program whose entries are eighths: the same in doubles and in rationals. */
typedef struct program {
  long count;
  double columns[MOST][3], most[MOST], direction[3], target[3];
  fmpq *exact, *bounds; /* columns, direction, target; bounds */
} program;

static void set_eighths(double *values, fmpq *exact, int count) {
  for (int k = 0; k < count; k++) {
    const long own = draw_below(&state, 17) - 8;
    values[k] = (double)own / 8;
    fmpq_set_si(exact + k, own, 8);
  }
}

static void copy_column(program *p, long to, long from, long factor) {
  for (int row = 0; row < 3; row++) {
    p->columns[to][row] = (double)factor * p->columns[from][row];
    fmpq_set_si(p->exact + 3 * to + row, factor, 1);
    fmpq_mul(p->exact + 3 * to + row, p->exact + 3 * to + row, p->exact + 3 * from + row);
  }
}

/* Columns may come twice, be parallel, or not longer than zero; bounds may be zero. */
static void program_init(program *p, long count, bool bounded) {
  p->count = count;
  p->exact = _fmpq_vec_init(3 * count + 6);
  p->bounds = _fmpq_vec_init(count);
  for (long k = 0; k < count; k++) {
    set_eighths(p->columns[k], p->exact + 3 * k, 3);
    if (k > 0 && draw_below(&state, 4) == 0)
      copy_column(p, k, draw_below(&state, k), draw_below(&state, 3));
    const long most = bounded && draw_below(&state, 3) > 0 ? draw_below(&state, 17) : -1;
    p->most[k] = most < 0 ? INFINITY : (double)most / 8;
    fmpq_set_si(p->bounds + k, most, 8);
  }
  do {
    set_eighths(p->direction, p->exact + 3 * count, 3);
  } while (p->direction[0] == 0 && p->direction[1] == 0 && p->direction[2] == 0);
  set_eighths(p->target, p->exact + 3 * count + 3, 3);
}

static void program_clear(program *p) {
  _fmpq_vec_clear(p->exact, 3 * p->count + 6);
  _fmpq_vec_clear(p->bounds, p->count);
}

static tp_geom_outcome solve_exactly(fmpq_t value, tp_geom_maximum *maximum, const program *p) {
  const fmpq *most[MOST];
  for (long k = 0; k < p->count; k++) most[k] = isinf(p->most[k]) ? NULL : p->bounds + k;
  const tp_geom_program given = {(size_t)p->count, p->exact, p->exact + 3 * p->count,
                                 p->exact + 3 * p->count + 3, most};
  maximum->value = value;
  ck_assert_int_eq(tp_geom_maximise(maximum, &given), TP_GEOM_OK);
  return maximum->outcome;
}

/* Solve for t and two columns, or for three columns (k < 0: t), the others at zero or at the bounds
 * that the bits of `high` tell. False where singular. */
static bool solve_basis(fmpq_mat_t x, const program *p, const long basis[3], unsigned high,
                        const fmpq *target) {
  fmpq_mat_t a, b;
  fmpq_mat_init(a, 3, 3);
  fmpq_mat_init(b, 3, 1);
  for (int row = 0; row < 3; row++) {
    for (int k = 0; k < 3; k++) {
      fmpq_set(fmpq_mat_entry(a, row, k),
               p->exact + 3 * (basis[k] < 0 ? p->count : basis[k]) + row);
    }
    fmpq_set(fmpq_mat_entry(b, row, 0), target + row);
    for (long k = 0; k < p->count; k++) {
      if ((high >> k & 1U) != 0) {
        fmpq_submul(fmpq_mat_entry(b, row, 0), p->exact + 3 * k + row, p->bounds + k);
      }
    }
  }
  const bool solved = fmpq_mat_solve(x, a, b) != 0;
  fmpq_mat_clear(a);
  fmpq_mat_clear(b);
  return solved;
}

static bool within(const fmpq *value, const program *p, long column) {
  if (column < 0) return true;
  return fmpq_sgn(value) >= 0 &&
         (isinf(p->most[column]) || fmpq_cmp(value, p->bounds + column) <= 0);
}

/* May the columns of the set be at their bounds while these are basic? */
static bool is_choice(const program *p, unsigned high, const long basis[3]) {
  for (long k = 0; k < p->count; k++) {
    const bool basic = k == basis[0] || k == basis[1] || k == basis[2];
    if ((high >> k & 1U) != 0 && (basic || isinf(p->most[k]))) return false;
  }
  return true;
}

/* All bases with t; sets the largest t. False: none is feasible. `*regular`: some basis is one. */
static bool largest(fmpq_t value, const program *p, bool *regular) {
  bool found = false;
  fmpq_mat_t x;
  fmpq_mat_init(x, 3, 1);
  *regular = false;
  for (long i = 0; i < p->count; i++) {
    for (long j = 0; j < i; j++) {
      const long basis[3] = {-1, i, j};
      for (unsigned high = 0; high < 1U << p->count; high++) {
        if (!is_choice(p, high, basis)) continue;
        if (!solve_basis(x, p, basis, high, p->exact + 3 * p->count + 3)) break;
        *regular = true;
        if (!within(fmpq_mat_entry(x, 1, 0), p, i) || !within(fmpq_mat_entry(x, 2, 0), p, j))
          continue;
        if (!found || fmpq_cmp(fmpq_mat_entry(x, 0, 0), value) > 0) {
          fmpq_set(value, fmpq_mat_entry(x, 0, 0));
        }
        found = true;
      }
    }
  }
  fmpq_mat_clear(x);
  return found;
}

/* Do three unbounded columns add up to minus the direction? */
static bool has_ray(const program *p, bool *regular) {
  bool found = false;
  fmpq_mat_t x;
  fmpq *target = _fmpq_vec_init(3);
  fmpq_mat_init(x, 3, 1);
  *regular = false;
  for (int row = 0; row < 3; row++) fmpq_neg(target + row, p->exact + 3 * p->count + row);
  for (long i = 0; i < p->count; i++) {
    for (long j = 0; j < i; j++) {
      for (long k = 0; k < j; k++) {
        const long basis[3] = {i, j, k};
        if (!isinf(p->most[i]) || !isinf(p->most[j]) || !isinf(p->most[k])) continue;
        if (!solve_basis(x, p, basis, 0, target)) continue;
        *regular = true;
        found = found ||
                (fmpq_sgn(fmpq_mat_entry(x, 0, 0)) >= 0 && fmpq_sgn(fmpq_mat_entry(x, 1, 0)) >= 0 &&
                 fmpq_sgn(fmpq_mat_entry(x, 2, 0)) >= 0);
      }
    }
  }
  _fmpq_vec_clear(target, 3);
  fmpq_mat_clear(x);
  return found;
}

START_TEST(exact_against_all_bases) {
  state = random_numbers_from(41);
  int seen[3] = {0};
  for (int round = 0; round < 1500; round++) {
    program p;
    tp_geom_maximum maximum = {.basis_count = 0};
    fmpq_t value, best;
    fmpq_init(value);
    fmpq_init(best);
    program_init(&p, 3 + draw_below(&state, 4), round % 2 == 1);
    const tp_geom_outcome outcome = solve_exactly(value, &maximum, &p);
    bool regular = false, spans = false;
    const bool feasible = largest(best, &p, &regular), ray = has_ray(&p, &spans);
    if (regular) {
      seen[outcome]++;
      ck_assert_int_eq(outcome == TP_GEOM_INFEASIBLE, !feasible);
      if (spans && feasible) ck_assert_int_eq(outcome == TP_GEOM_UNBOUNDED, ray);
      if (outcome == TP_GEOM_OPTIMAL) ck_assert(fmpq_equal(value, best));
    }
    program_clear(&p);
    fmpq_clear(value);
    fmpq_clear(best);
  }
  for (int k = 0; k < 3; k++) ck_assert_int_gt(seen[k], 100);
}
END_TEST

/* The steps in floating point of 128 bits on the same numbers. */
static tp_simplex_outcome solve_precisely(double *t, const tp_simplex_program *given,
                                          bool *at_most) {
  arf_struct columns[3 * MOST], most[MOST], scratch[TP_PRECISE_SCRATCH];
  for (long k = 0; k < TP_PRECISE_SCRATCH; k++) arf_init(scratch + k);
  for (long k = 0; k < given->count; k++) {
    for (int row = 0; row < 3; row++) {
      arf_init(columns + 3 * k + row);
      arf_set_d(columns + 3 * k + row, given->columns[k][row]);
    }
    arf_init(most + k);
    arf_set_d(most + k, given->most != NULL ? given->most[k] : INFINITY);
  }
  tp_precise p = {.count = given->count,
                  .bits = 128,
                  .columns = columns,
                  .most = most,
                  .at_most = given->most != NULL ? at_most : NULL,
                  .scratch = scratch};
  tp_precise_share(&p);
  for (int row = 0; row < 3; row++) {
    arf_set_d(p.direction + row, given->direction[row]);
    arf_set_d(p.target + row, given->target[row]);
  }
  const tp_simplex_outcome outcome = tp_precise_run(&p);
  for (int r = 0; r < 3; r++) {
    if (p.basis[r] == TP_SIMPLEX_T) *t = arf_get_d(p.values + r, ARF_RND_NEAR);
  }
  for (long k = 0; k < 3 * given->count; k++) arf_clear(columns + k);
  for (long k = 0; k < given->count; k++) arf_clear(most + k);
  for (long k = 0; k < TP_PRECISE_SCRATCH; k++) arf_clear(scratch + k);
  return outcome;
}

static tp_simplex_outcome simplex_outcome(tp_geom_outcome outcome) {
  return outcome == TP_GEOM_OPTIMAL     ? TP_SIMPLEX_OPTIMAL
         : outcome == TP_GEOM_UNBOUNDED ? TP_SIMPLEX_UNBOUNDED
                                        : TP_SIMPLEX_INFEASIBLE;
}

START_TEST(doubles_against_exact) {
  state = random_numbers_from(42);
  int seen[3] = {0};
  for (int round = 0; round < 20000; round++) {
    program p;
    tp_geom_maximum maximum = {.basis_count = 0};
    bool at_most[MOST]; /* where it starts does not matter */
    for (int k = 0; k < MOST; k++) at_most[k] = draw_below(&state, 3) == 0;
    fmpq_t value;
    fmpq_init(value);
    program_init(&p, 1 + draw_below(&state, MOST), round % 2 == 1);
    const tp_geom_outcome outcome = solve_exactly(value, &maximum, &p);
    tp_simplex_program given = {.count = p.count,
                                .columns = (const double(*)[3])p.columns,
                                .most = round % 2 == 1 ? p.most : NULL};
    for (int row = 0; row < 3; row++) {
      given.direction[row] = p.direction[row];
      given.target[row] = p.target[row];
    }
    bool flags[MOST];
    memcpy(flags, at_most, sizeof flags);
    double precise = 0;
    const tp_simplex_outcome precisely = solve_precisely(&precise, &given, flags);
    const tp_simplex_answer answer = tp_simplex_solve(&given, at_most);
    const tp_simplex_outcome expected = simplex_outcome(outcome);
    ck_assert_msg(answer.outcome == expected, "round %d: %d, not %d", round, answer.outcome,
                  expected);
    ck_assert_msg(precisely == expected, "round %d: %d, not %d", round, precisely, expected);
    if (outcome == TP_GEOM_OPTIMAL) {
      const double truth = fmpq_get_d(value);
      /* eighths: pivots are no smaller than 8^-3, their products of three rows amplify 2^-53 */
      ck_assert_double_le(fabs(answer.t - truth), 1e-10 * (1 + fabs(truth)));
      ck_assert_double_le(fabs(precise - truth), 1e-15 * (1 + fabs(truth)));
    }
    seen[outcome]++;
    program_clear(&p);
    fmpq_clear(value);
  }
  for (int k = 0; k < 3; k++) ck_assert_int_gt(seen[k], 1000);
}
END_TEST

/* Of many columns the simplex method looks at a share of them at a step. A program of few columns,
 * each of them at one place among thousands and its multiples at more, has the same answer,
 * wherever the columns that the answer rests on lie. */
START_TEST(many_columns_as_few) {
  enum { MANY = 5000 };
  static double columns[MANY][3];
  state = random_numbers_from(43);
  int seen[3] = {0};
  for (int round = 0; round < 400; round++) {
    program p;
    tp_geom_maximum maximum = {.basis_count = 0};
    fmpq_t value;
    fmpq_init(value);
    program_init(&p, 1 + draw_below(&state, MOST), false);
    const tp_geom_outcome outcome = solve_exactly(value, &maximum, &p);
    const long rare = draw_below(&state, p.count), place = draw_below(&state, MANY);
    for (long k = 0; k < MANY; k++) { /* one of them at a single place */
      const long often = p.count > 1 ? (rare + 1 + draw_below(&state, p.count - 1)) % p.count : 0;
      const double factor = (double)(1 + draw_below(&state, 2));
      for (int row = 0; row < 3; row++) columns[k][row] = factor * p.columns[often][row];
    }
    memcpy(columns[place], p.columns[rare], sizeof columns[place]);
    tp_simplex_program given = {.count = MANY, .columns = (const double(*)[3])columns};
    memcpy(given.direction, p.direction, sizeof given.direction);
    memcpy(given.target, p.target, sizeof given.target);
    const tp_simplex_answer answer = tp_simplex_solve(&given, NULL);
    const tp_simplex_outcome expected = simplex_outcome(outcome);
    ck_assert_msg(answer.outcome == expected, "round %d: %d, not %d", round, answer.outcome,
                  expected);
    if (outcome == TP_GEOM_OPTIMAL) {
      const double truth = fmpq_get_d(value);
      ck_assert_double_le(fabs(answer.t - truth), 1e-10 * (1 + fabs(truth))); /* as above */
    }
    seen[outcome]++;
    program_clear(&p);
    fmpq_clear(value);
  }
  for (int k = 0; k < 3; k++) ck_assert_int_gt(seen[k], 20);
}
END_TEST

SUITE(program) {
  Suite *suite = suite_create("program");
  TCase *cases = tcase_create("program");
  tcase_set_timeout(cases, 120);
  tcase_add_test(cases, exact_against_all_bases);
  tcase_add_test(cases, doubles_against_exact);
  tcase_add_test(cases, many_columns_as_few);
  suite_add_tcase(suite, cases);
  return suite;
}
