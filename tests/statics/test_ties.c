/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Two mechanisms that tie do so in blocks of every size.
 *
 * A square of side s and weight W under an earthquake, on a bond of 2 W / 9 over its base with 45
 * degrees of friction. With T along the base and N across it, at the centroid, it slides where
 * T = N + 2 W / 9 and topples where T s / 2 = N s / 2 + (2 W / 9) s / 2: at one tilt, and tilted
 * back likewise. Which columns of the limit's program carry it there is arbitrary, and changes with
 * the size; those of a cohesion that it has not may not decide. */

#include "suite.h"

#include "topple.h"

#include <stdio.h>
#include <stdlib.h>

enum { LEAST = -6, SIZES = 36 }; /* powers of 7 */

static tp_solution *solve_square(int size) {
  char side[16], text[800];
  snprintf(side, sizeof side, size < 0 ? "1/7^%d" : "7^%d", abs(size));
  snprintf(text, sizeof text,
           "topple: 1\nlength_unit: m\nblock:\n  unit_weight_kn_m3: 26\n"
           "  outline: [[0, 0], [%s, 0], [%s, %s], [0, %s]]\n"
           "loads:\n  seismic: {horizontal: 1/16, vertical: -1/8}\n  bond_kpa: 52/9 * %s\n"
           "friction_angle_deg: 45\ntilt: {towards: left}\n",
           side, side, side, side, side);
  tp_scene *scene = NULL;
  tp_solution *solution = NULL;
  tp_message message = {.text = ""};
  const tp_solve_options options = tp_solve_options_default();
  ck_assert_msg(tp_scene_read_text(&scene, text, "square", &message) == TP_OK, "%s", message.text);
  ck_assert_msg(tp_solve(&solution, scene, &options, &message) == TP_OK, "%s", message.text);
  tp_scene_free(scene);
  return solution;
}

START_TEST(a_tie_is_one_at_every_size) {
  for (int size = LEAST; size < LEAST + SIZES; size++) {
    tp_solution *solution = solve_square(size);
    const tp_case *own = solution->cases;
    const tp_limit *limits[] = {&own->limit, &own->limit_otherwise, &own->limit_holds_from};
    for (int k = 0; k < 3; k++) {
      ck_assert_msg(limits[k]->kind == TP_LIMIT_AT_ANGLE, "limit %d at 7^%d", k, size);
      ck_assert_msg(limits[k]->tie, "no tie of limit %d at 7^%d", k, size);
    }
    tp_solution_free(solution);
  }
}
END_TEST

SUITE(ties) {
  Suite *suite = suite_create("ties");
  TCase *tests = tcase_create("ties");
  tcase_add_test(tests, a_tie_is_one_at_every_size);
  suite_add_tcase(suite, tests);
  return suite;
}
