/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The interior point method of many blocks: what its normal equations are factorised into and
 * solved for, and that beginning from points of other programs changes nothing but the steps. */

#include "assemblage/interior_start.h"
#include "assemblage/normal_equations.h"
#include "block_pile.h"
#include "suite.h"

#include <math.h>
#include <stdlib.h>

/* The factor of a wall that is dissected some six times over, and of two that do not touch: what it
 * solves for, taken through every contact, is what was given. */
START_TEST(normal_equations) {
  for (int walls = 1; walls <= 2; walls++) {
    block_pile p = {.count = 0};
    pile_add_wall(&p, 15, 14);
    if (walls == 2) pile_add_box(&p, 5800, 0, 5900, 900, 100, false);
    pile_build(&p);
    tp_force_program program;
    tp_normal_equations normal;
    tp_message message = {.text = ""};
    pile_program(&program, &p, 0.6, true);
    ck_assert_int_eq(tp_normal_equations_init(&normal, &program, &message), TP_OK);
    double *d = calloc((size_t)program.count, sizeof *d);
    double *given = calloc(2 * (size_t)program.rows, sizeof *given), *found = given + program.rows;
    for (long k = 0; k < program.count; k++) d[k] = 1 + (double)(k * 7919 % 101) / 10;
    for (long r = 0; r < program.rows; r++) given[r] = found[r] = (double)(r * 31 % 17) - 8;
    ck_assert(tp_normal_equations_factorise(&normal, d));
    tp_normal_equations_solve(&normal, found);
    for (long k = 0; k < program.count; k++) {
      const tp_force_column *c = program.columns + k;
      const double force = d[k] * tp_force_column_work(c, found);
      for (int side = 0; side < 2; side++) {
        for (int e = 0; e < 3 && c->row[side] >= 0; e++) {
          given[c->row[side] + e] -= force * c->entry[side][e].value;
        }
      }
    }
    for (long r = 0; r < program.rows; r++) ck_assert_double_le(fabs(given[r]), 1e-9);
    free(d);
    free(given);
    tp_normal_equations_clear(&normal);
    tp_force_program_clear(&program);
    pile_clear(&p);
  }
}
END_TEST

/* Of every instruction set that this machine has: the same bits of factors and solutions, of fronts
 * with few rows and with more than a stripe of them. L (L^T v) of what was solved is what was
 * given. */
static void factorise_front(const tp_front_kernel *kernel, double *columns, double *v, long rows,
                            long own) {
  const long behind = rows - own;
  double *rest = columns + rows * own;
  for (long c = 0; c < rows; c++) {
    double *to = c < own ? columns + c * rows : rest + (c - own) * behind - own;
    for (long r = c < own ? 0 : own; r < rows; r++) {
      to[r] = r == c ? (double)rows : (double)((r + c) * 7919 % 31) / 31;
    }
    v[c] = (double)(c * 31 % 17) - 8;
  }
  ck_assert(kernel->factorise(columns, rows, own, rest));
  for (long c = 1; c < behind; c++) { /* above the diagonal */
    for (long r = 0; r < c; r++) rest[c * behind + r] = 0;
  }
  kernel->solve(v, columns, rows, own);
  kernel->solve_back(v, columns, rows, own);
}

static double product_of_front(const double *columns, const double *v, long rows, long row) {
  double sum = 0;
  for (long k = 0; k <= row; k++) {
    for (long r = k; r < rows; r++) sum += columns[k * rows + row] * columns[k * rows + r] * v[r];
  }
  return sum;
}

START_TEST(fronts_by_every_instruction) {
  enum { MOST = 120 };
  static const long sizes[][2] = {{3, 3}, {9, 6}, {21, 3}, {57, 48}, {MOST, 99}, {MOST, MOST}};
  double *first = calloc(2 * MOST * MOST, sizeof *first), *other = first + MOST * MOST;
  for (size_t k = 0; k < sizeof sizes / sizeof sizes[0]; k++) {
    const long rows = sizes[k][0], own = sizes[k][1];
    const size_t entries = (size_t)(rows * own + (rows - own) * (rows - own));
    double v[MOST], w[MOST];
    factorise_front(tp_front_kernel_choose(TP_INSTRUCTIONS_BASELINE), first, v, rows, own);
    for (long row = 0; row < own && own == rows; row++) {
      const double given = (double)(row * 31 % 17) - 8;
      ck_assert_double_eq_tol(product_of_front(first, v, rows, row), given, 1e-10);
    }
    for (int set = TP_INSTRUCTIONS_AVX2; set < TP_INSTRUCTIONS_COUNT; set++) {
      if (!tp_instructions_present((tp_instructions)set)) continue;
      factorise_front(tp_front_kernel_choose((tp_instructions)set), other, w, rows, own);
      for (long c = 1; c < own; c++) {
        for (long r = 0; r < c; r++) first[c * rows + r] = other[c * rows + r] = 0;
      }
      ck_assert_mem_eq(first, other, entries * sizeof *first);
      ck_assert_mem_eq(v, w, (size_t)rows * sizeof *v);
    }
  }
  free(first);
}
END_TEST

/* The steps until the gap is a millionth of the load. */
static bool count_steps(void *context, const tp_interior_iterate *at) {
  int *steps = context;
  ++*steps;
  return at->gap <= 1e-6 * at->load;
}

static int steps_from(const block_pile *p, double tangent, const tp_interior_from *from) {
  int steps = 0;
  bool began_near;
  tp_message message = {.text = ""};
  tp_force_program program;
  pile_program(&program, p, tangent, true);
  ck_assert_int_eq(tp_interior_point(&began_near, &program, from, count_steps, &steps, &message),
                   TP_OK);
  tp_force_program_clear(&program);
  return steps;
}

/* Limits of friction that changes by much, by little, and back, each begun from points of those
 * before, are what they are from nothing, and as narrow; little is a matter of a few steps. */
START_TEST(begun_from_near_states) {
  static const double share = 1e-6;
  static const double tangents[] = {0.65, 0.65 * (1 - 1e-6), 0.6, 0.3, 0.65};
  tp_interior_start start = {.n = 0};
  block_pile p = {.count = 0};
  pile_add_wall(&p, 8, 8);
  pile_build(&p);
  for (size_t k = 0; k < sizeof tangents / sizeof tangents[0]; k++) {
    const tp_interior_from nothing = {.start = NULL}, near = {&start, log(tangents[k])};
    tp_message message = {.text = ""};
    tp_force_program program;
    tp_load_bracket own, cold = pile_limit(&p, tangents[k], true, share);
    pile_program(&program, &p, tangents[k], true);
    const tp_bracket_aim aim = {.share = share, .enough = INFINITY, .from = near};
    ck_assert_int_eq(tp_load_bracket_find(&own, &program, &aim, &message), TP_OK);
    ck_assert(own.is_held && own.is_bounded && own.bound - own.held <= share * own.bound);
    ck_assert(own.held <= cold.bound && cold.held <= own.bound);
    if (k == 1) {
      const int few = steps_from(&p, tangents[k], &near),
                many = steps_from(&p, tangents[k], &nothing);
      ck_assert_msg(3 * few <= many, "%d and %d steps", few, many);
    }
    tp_force_program_clear(&program);
    tp_load_bracket_clear(&own);
    tp_load_bracket_clear(&cold);
  }
  tp_interior_start_clear(&start);
  pile_clear(&p);
}
END_TEST

SUITE(interior_point) {
  Suite *suite = suite_create("interior_point");
  TCase *tests = tcase_create("programs");
  tcase_set_timeout(tests, 300);
  tcase_add_test(tests, normal_equations);
  tcase_add_test(tests, fronts_by_every_instruction);
  tcase_add_test(tests, begun_from_near_states);
  suite_add_tcase(suite, tests);
  return suite;
}
