/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The proof of a limit: it agrees with the exact program of the same columns, and takes the right
 * basis and no other. */

#include "certificate/excess.h"
#include "certificate/prove.h"
#include "limit/limit.h"
#include "limit/search.h"
#include "random_numbers.h"
#include "suite.h"

#include "geom/geom.h"

#include <flint/fmpq_vec.h>
#include <math.h>

static random_numbers state;

/* Facets of a random rough underside as cones of rational friction, and the weight of a block. */
typedef struct scene {
  tp_cones cones;
  tp_wrench load;
  tp_scaled scaled;
  tp_vector drive;
  tp_limit_question question;
} scene;

static void scene_init(scene *s) {
  const long facets = 1 + draw_below(&state, 4);
  ck_assert(tp_cones_init(&s->cones, 2 * facets));
  long x = 0, y = draw_below(&state, 9);
  for (long k = 0; k < facets; k++) {
    const long dx = 1 + draw_below(&state, 9), dy = draw_below(&state, 13) - 6;
    for (int end = 0; end < 2; end++) {
      const long own = 2 * k + end;
      fmpz_t at_x, at_y;
      fmpz_init_set_si(at_x, end == 0 ? x : x + dx);
      fmpz_init_set_si(at_y, end == 0 ? y : y + dy);
      tp_cones_set_whole(&s->cones, own, at_x, at_y);
      fmpz_clear(at_x);
      fmpz_clear(at_y);
      fmpz_set_si(s->cones.tx + own, dx);
      fmpz_set_si(s->cones.ty + own, dy);
      s->cones.points[own] = (tp_cone_point){.site = (int32_t)k + end, .facet = (int32_t)k};
    }
    x += dx;
    y += dy;
  }
  arb_set_si(s->cones.friction, draw_below(&state, 9));
  arb_mul_2exp_si(s->cones.friction, s->cones.friction, -2);
  tp_wrench_init(&s->load); /* W = 1 at (gx, gy): F = (-sin, -cos), gx F_y - gy F_x */
  arb_set_si(s->load.x.of + TP_SIN, -1);
  arb_set_si(s->load.y.of + TP_COS, -1);
  arb_set_si(s->load.moment.of + TP_COS, -draw_below(&state, x + 1));
  arb_set_si(s->load.moment.of + TP_SIN, 7 + draw_below(&state, 30));
  s->question = (tp_limit_question){
      .cones = &s->cones, .load = &s->load, .judge = {.bits = 160, .precision = ARF_PREC_EXACT}};
  tp_vector size;
  tp_vector_init(&size);
  tp_vector_init(&s->drive);
  tp_question_load_term(&s->drive, &s->load, TP_SIN);
  tp_question_load_term(&size, &s->load, TP_COS);
  ck_assert(tp_scaled_init(&s->scaled, &s->cones, &size, 160));
  tp_vector_clear(&size);
}

static void scene_clear(scene *s) {
  tp_scaled_clear(&s->scaled);
  tp_vector_clear(&s->drive);
  tp_wrench_clear(&s->load);
  tp_cones_clear(&s->cones);
}

/* tan of the limit by the exact program of the same columns. */
static tp_geom_outcome exact_limit(fmpq_t value, const scene *s) {
  const long count = tp_cones_column_count(&s->cones);
  fmpq *columns = _fmpq_vec_init(3 * count + 6);
  tp_vector entries;
  tp_vector_init(&entries);
  for (long k = 0; k < count + 2; k++) {
    if (k < count) tp_cones_column(entries.of, &s->cones, k, ARF_PREC_EXACT);
    if (k >= count) tp_question_load_term(&entries, &s->load, k == count ? TP_SIN : TP_COS);
    if (k > count) tp_vector_neg(&entries);
    for (int row = 0; row < 3; row++)
      arf_get_fmpq(columns + 3 * k + row, arb_midref(entries.of + row));
  }
  const tp_geom_program given = {(size_t)count, columns, columns + 3 * count,
                                 columns + 3 * count + 3, NULL};
  tp_geom_maximum maximum = {.value = value};
  ck_assert_int_eq(tp_geom_maximise(&maximum, &given), TP_GEOM_OK);
  tp_vector_clear(&entries);
  _fmpq_vec_clear(columns, 3 * count + 6);
  return maximum.outcome;
}

static bool tells(const tp_limit_answer *answer, const fmpq_t tangent) {
  arb_t ratio;
  arb_init(ratio);
  arb_div(ratio, answer->sine, answer->cosine, 160);
  const bool contains = arb_contains_fmpq(ratio, tangent) != 0;
  arb_clear(ratio);
  return contains;
}

START_TEST(limit_is_that_of_the_exact_program) {
  state = random_numbers_from(43);
  int seen[3] = {0};
  for (int round = 0; round < 3000; round++) {
    scene s;
    fmpq_t tangent;
    tp_limit_answer answer;
    fmpq_init(tangent);
    scene_init(&s);
    ck_assert(tp_limit_answer_init(&answer, &s.cones));
    const tp_geom_outcome outcome = exact_limit(tangent, &s);
    if (tp_limit_find(&answer, &s.question) == TP_LIMIT_PROVEN) {
      seen[outcome]++;
      ck_assert_int_eq(answer.kind, outcome == TP_GEOM_OPTIMAL     ? TP_LIMIT_AT_ANGLE
                                    : outcome == TP_GEOM_UNBOUNDED ? TP_LIMIT_INTERLOCKED
                                                                   : TP_LIMIT_NOWHERE);
      if (outcome == TP_GEOM_OPTIMAL) ck_assert(tells(&answer, tangent));
    }
    tp_limit_answer_clear(&answer);
    scene_clear(&s);
    fmpq_clear(tangent);
  }
  ck_assert_int_gt(seen[TP_GEOM_OPTIMAL], 1000);
  ck_assert_int_gt(seen[TP_GEOM_UNBOUNDED], 100);
  ck_assert_int_gt(seen[TP_GEOM_INFEASIBLE], 3);
  ck_assert_int_gt(seen[0] + seen[1] + seen[2], 2990); /* rank-deficient ones may stay open */
}
END_TEST

/* Every pair of columns is handed to the proof as if it were the basis: what it takes is the limit.
 */
START_TEST(wrong_bases_are_refused) {
  state = random_numbers_from(44);
  long taken = 0, refused = 0, optimal = 0;
  for (int round = 0; round < 400; round++) {
    scene s;
    fmpq_t tangent;
    fmpq_init(tangent);
    scene_init(&s);
    const tp_geom_outcome outcome = exact_limit(tangent, &s);
    const long count = tp_cones_column_count(&s.cones);
    bool any = false;
    for (long i = 0; i < count; i++) {
      for (long j = 0; j < count; j++) {
        if (i == j) continue;
        tp_limit_answer answer;
        ck_assert(tp_limit_answer_init(&answer, &s.cones));
        const tp_basis basis = {TP_SIMPLEX_OPTIMAL, 2, {i, j, -1}};
        const bool proven =
            tp_prove_limit(&answer, &s.question, &s.scaled, &basis, &s.drive, 0) == TP_YES;
        ck_assert(!proven || (outcome == TP_GEOM_OPTIMAL && tells(&answer, tangent)));
        any = any || proven;
        *(proven ? &taken : &refused) += 1;
        tp_limit_answer_clear(&answer);
      }
    }
    if (outcome == TP_GEOM_OPTIMAL) {
      optimal++;
      ck_assert(any);
    }
    scene_clear(&s);
    fmpq_clear(tangent);
  }
  ck_assert_int_gt(optimal, 100);
  ck_assert_int_gt(taken, 2 * optimal - 1); /* either order */
  ck_assert_int_gt(refused, 10 * taken);
}
END_TEST

SUITE(limit) {
  Suite *suite = suite_create("limit");
  TCase *cases = tcase_create("limit");
  tcase_set_timeout(cases, 120);
  tcase_add_test(cases, limit_is_that_of_the_exact_program);
  tcase_add_test(cases, wrong_bases_are_refused);
  suite_add_tcase(suite, cases);
  return suite;
}
