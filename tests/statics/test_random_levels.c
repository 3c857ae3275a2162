/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Random scenes at each level of arithmetic and to various numbers of digits: what a cheap level
 * certifies is what exact arithmetic says; where it cannot, it says so, and its numbers hold still.
 * A second run gives the same bytes. */

#include "compare_solutions.h"
#include "random_scenes.h"
#include "stability/solution.h"
#include "stability/solve.h"
#include "suite.h"

#include <string.h>

static uint64_t seed; /* of the scene in hand */
static char *text;

/* Check writes to a file for each assertion that holds. */
static void claim(bool condition, const char *what, const char *why) {
  if (condition) return;
  ck_abort_msg("%s: %s: TOPPLE_RANDOM_SEED=%lu TOPPLE_RANDOM_SCENES=1\n%s", what, why, (ulong)seed,
               text);
}

static tp_solution *solve_prepared(tp_status *status, const tp_problem *problem,
                                   tp_solve_options options) {
  tp_message message;
  tp_solution *solution = tp_solution_new();
  *status = tp_solve_problem(solution, problem, &options, &message);
  claim(*status == TP_OK || *status == TP_UNDECIDED, "no failure but undecided", message.text);
  return solution;
}

/* As JSON without the times. */
static char *report(tp_solution *solution) {
  char *json = NULL;
  for (size_t k = 0; k < solution->effect_count; k++) solution->effects[k].seconds = 0;
  claim(tp_report_json(&json, solution) == TP_OK, "report", "JSON");
  return json;
}

enum { ENOUGH = 200 }; /* scenes to speak of shares */

typedef struct counts {
  long certain[TP_LEVELS], open[TP_LEVELS], refused, ties;
} counts;

static void claim_levels(counts *seen, const tp_problem *problem, const tp_solution *exact,
                         int digits) {
  relation same;
  char why[256];
  relation_init(&same);
  for (int level = TP_LEVEL_DOUBLE; level <= TP_LEVEL_EXACT; level++) {
    tp_solve_options options = tp_solve_options_default();
    options.level = (tp_level)level;
    options.digits = digits;
    tp_status status = TP_OK;
    tp_solution *solution = solve_prepared(&status, problem, options);
    same.uncertain = status == TP_UNDECIDED;
    claim((int)solution->level <= level, "no dearer level than allowed",
          tp_level_name(solution->level));
    claim(solutions_agree(why, exact, solution, &same), tp_level_name((tp_level)level), why);
    *(same.uncertain ? seen->open + level : seen->certain + level) += 1;
    tp_solution_free(solution);
  }
  relation_clear(&same);
}

static void claim_scene(counts *seen, const tp_scene *scene, random_numbers *state) {
  static const int digits[] = {3, 9, 13, 15, 25, 50};
  tp_solution *prepared = calloc(1, sizeof *prepared); /* what the preparation notes */
  tp_problem problem;
  tp_message message;
  tp_solve_options options = tp_solve_options_default();
  if (tp_problem_init(&problem, scene, &options, prepared, &message) != TP_OK) {
    tp_solution_free(prepared);
    seen->refused++;
    return;
  }
  tp_status status = TP_OK;
  tp_solution *exact = solve_prepared(&status, &problem, options);
  claim(status == TP_OK, "exact arithmetic decides", "status");
  tp_solution *again = solve_prepared(&status, &problem, options);
  char *first = report(exact), *second = report(again);
  claim(strcmp(first, second) == 0, "the same bytes", second);
  claim_levels(seen, &problem, exact, digits[draw_below(state, 6)]);
  for (size_t k = 0; k < exact->case_count; k++) seen->ties += exact->cases[k].toppling_tie;
  free(first);
  free(second);
  tp_solution_free(prepared);
  tp_solution_free(exact);
  tp_solution_free(again);
  tp_problem_clear(&problem);
}

START_TEST(test_levels_of_random_scenes) {
  const uint64_t first = random_seed();
  const long count = random_scenes();
  counts seen = {0};
  for (long k = 0; k < count; k++) {
    seed = first + (uint64_t)k;
    random_numbers state = random_numbers_from(seed);
    random_scene drawn;
    random_scene_draw(&drawn, &state);
    text = random_scene_text(&drawn);
    tp_scene *scene = NULL;
    tp_message message;
    claim(tp_scene_read_text(&scene, text, "random.yaml", &message) == TP_OK, "read", message.text);
    claim_scene(&seen, scene, &state);
    tp_scene_free(scene);
    free(text);
    random_scene_clear(&drawn);
  }
  ck_assert_int_le(seen.refused, count / 50 + 1);
  if (count < ENOUGH) return;
  ck_assert_int_gt(seen.ties, count / 50);
  for (int level = TP_LEVEL_DOUBLE; level < TP_LEVEL_EXACT; level++) {
    ck_assert_int_gt(seen.certain[level], count / 10);
    ck_assert_int_gt(seen.open[level], count / 50);
  }
  ck_assert_int_eq(seen.open[TP_LEVEL_EXACT], 0);
}
END_TEST

SUITE(random_levels) {
  Suite *suite = suite_create("random levels");
  TCase *cases = tcase_create("random levels");
  tcase_set_timeout(cases, 0);
  tcase_add_test(cases, test_levels_of_random_scenes);
  suite_add_tcase(suite, cases);
  return suite;
}
