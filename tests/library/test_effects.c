/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Only the effects that a scene calls for are computed: calls counted, not timed.
 *
 * The linker routes the entries of every effect through counters (--wrap). The bare scene must
 * enter none of them; the scene that names an effect must enter that one, and no other. */

#include "runner.h"

#include "block/corners.h"
#include "block/ellipse.h"
#include "common/clock.h"
#include "evaluation/stages.h"
#include "load/loads.h"
#include "problem/facet_friction.h"
#include "shaking/shaking.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum {
  SEISMIC,
  WATER,
  UPLIFT,
  WET,
  PRESSURE,
  SURCHARGE,
  ANCHOR,
  LOADS,
  ROUNDING,
  ROLLING,
  ELLIPSE,
  ELEMENTS,
  SLIDING,
  FACETS,
  SIMULATION,
  SHAKING,
  EFFECTS
};

static long calls[EFFECTS];

#define COUNTED(effect, result, name, parameters, arguments)                                       \
  result __real_##name parameters;                                                                 \
  result __wrap_##name parameters;                                                                 \
  result __wrap_##name parameters {                                                                \
    calls[effect]++;                                                                               \
    return __real_##name arguments;                                                                \
  }

COUNTED(SEISMIC, void, tp_load_seismic, (tp_wrench * w, const tp_load_setting *s), (w, s))
COUNTED(WATER, void, tp_load_water, (tp_wrench * w, const tp_load_setting *s), (w, s))
COUNTED(UPLIFT, void, tp_load_uplift, (tp_wrench * w, const tp_load_setting *s), (w, s))
COUNTED(WET, void, tp_load_wet_lines,
        (tp_wrench * w, const tp_wet_lines *l, const tp_load_setting *s), (w, l, s))
COUNTED(PRESSURE, void, tp_load_pressure,
        (tp_wrench * w, const tp_line_load *l, const tp_load_setting *s), (w, l, s))
COUNTED(SURCHARGE, void, tp_load_surcharge,
        (tp_wrench * w, const tp_line_load *l, const tp_load_setting *s), (w, l, s))
COUNTED(ANCHOR, void, tp_load_anchor,
        (tp_wrench * w, const tp_anchor_description *a, long row, const tp_load_setting *s),
        (w, a, row, s))
COUNTED(LOADS, void, tp_loads_evaluate, (tp_load * l, const tp_load_setting *s), (l, s))
COUNTED(ROUNDING, void, tp_corners_take_off,
        (tp_moments * m, const tp_corners *c, const tp_section *s, const tp_lattice *l, long bits),
        (m, c, s, l, bits))
COUNTED(ROLLING, void, tp_evaluate_rolling,
        (const tp_evaluation *e, tp_case *c, const tp_direction_ball *t, tp_certainty *own),
        (e, c, t, own))
COUNTED(ELLIPSE, void, tp_ellipse_sums,
        (arb_struct * s, const tp_ellipse *e, const tp_lattice *l, const fmpq_t metres, long bits),
        (s, e, l, metres, bits))
COUNTED(ELEMENTS, tp_status, tp_elements_init,
        (tp_elements * e, const tp_section *s, const tp_lattice *l, long chain,
         const tp_geom_triangulation *t, tp_message *m),
        (e, s, l, chain, t, m))
COUNTED(SLIDING, void, tp_evaluate_sliding,
        (const tp_evaluation *e, tp_case *c, tp_direction_ball *s, tp_certainty *own),
        (e, c, s, own))

COUNTED(FACETS, tp_status, tp_facet_friction_init,
        (tp_facet_friction * f, const tp_scene *s, const tp_base *b, const tp_lattice *l,
         const tp_contact *c, tp_facets_counted counted, tp_solution *own, tp_message *m),
        (f, s, b, l, c, counted, own, m))

COUNTED(SIMULATION, tp_status, tp_rigid_body_init,
        (tp_rigid_body * b, const tp_problem *p, tp_direction d, tp_message *m), (b, p, d, m))
COUNTED(SHAKING, tp_status, tp_base_shaking_init,
        (tp_base_shaking * b, const tp_scene *s, tp_message *m), (b, s, m))

/* Solve a scene written to a file, and count. */
static void solve(const char *block, const char *rest) {
  char path[] = "/tmp/topple-effects-XXXXXX";
  const int handle = mkstemp(path);
  ck_assert_int_ge(handle, 0);
  FILE *file = fdopen(handle, "w");
  ck_assert_ptr_nonnull(file);
  fprintf(file, "topple: 1\nlength_unit: m\nblock:\n  %s\n  unit_weight_kn_m3: 26\n%s\n%s", block,
          rest, strstr(rest, "tilt") == NULL ? "tilt: {towards: left}\n" : "");
  fclose(file);
  memset(calls, 0, sizeof calls);
  tp_scene *scene = NULL;
  tp_solution *solution = NULL;
  tp_message message = {.text = ""};
  const tp_solve_options options = tp_solve_options_default();
  ck_assert_msg(tp_scene_read(&scene, path, &message) == TP_OK, "%s", message.text);
  ck_assert_msg(tp_solve(&solution, scene, &options, &message) == TP_OK, "%s", message.text);
  tp_solution_free(solution);
  tp_scene_free(scene);
  unlink(path);
}

#define SLAB "slab: {width: 2, height: 5}"

/* None, and one after the other; `loads` also counts for each load, `uplift` for water. */
START_TEST(only_what_is_called_for) {
  static const struct {
    int effect, also;
    const char *block, *rest;
  } scenes[] = {
      {-1, -1, SLAB, ""},
      {SEISMIC, LOADS, SLAB, "loads: {seismic: {horizontal: 0.1}}"},
      {WATER, LOADS, SLAB, "loads: {water: {height: 1}}"},
      {WET, LOADS, SLAB, "loads: {water: {level: 1}}"},
      {PRESSURE, LOADS, SLAB, "loads: {pressures: [{from: [2, 0], to: [2, 5], kpa: 1}]}"},
      {SURCHARGE, LOADS, SLAB, "loads: {surcharges: [{from: [0, 5], to: [2, 5], kpa: 1}]}"},
      {ANCHOR, LOADS, SLAB, "loads: {anchors: [{at: [0, 4], direction_deg: 0, force_kn: 1}]}"},
      {LOADS, -1, SLAB, "loads: {bond_kpa: 1}"},
      {ROUNDING, ROLLING, SLAB "\n  rounded: {corners: [{at: left_end, radius: 0.1}]}", ""},
      {ELLIPSE, -1, "ellipse: {width: 4, height: 3, flat: 1}", ""},
      {SLIDING, -1, SLAB, "friction_angle_deg: 30"},
      {FACETS, SLIDING, SLAB,
       "friction_angle_deg: 30\nfriction: {facets: [{facet: 1, angle_deg: 20}]}"},
      {ELEMENTS, -1, SLAB, "tilt: {towards: left, angle_deg: 5}"},
  };
  for (size_t k = 0; k < sizeof scenes / sizeof scenes[0]; k++) {
    solve(scenes[k].block, scenes[k].rest);
    for (int effect = 0; effect < EFFECTS; effect++) {
      const bool called_for = effect == scenes[k].effect || effect == scenes[k].also;
      ck_assert_msg((calls[effect] > 0) == called_for, "scene %zu, effect %d: %ld calls", k, effect,
                    calls[effect]);
    }
  }
}
END_TEST

/* Water takes the uplift only with `uplift: true`. */
START_TEST(uplift) {
  solve(SLAB, "loads: {water: {height: 1, uplift: true}}");
  ck_assert_int_gt(calls[UPLIFT], 0);
  ck_assert_int_gt(calls[WATER], 0);
}
END_TEST

#define PATH "tilt_test: {engine: path}\n"
#define SHAKES                                                                                     \
  "tilt_test: {engine: dynamics, duration_s: 0.01}\n"                                              \
  "shaking: {horizontal: {half_sine: {peak_g: 0.1, frequency_hz: 200}}}\n"

/* `solve` enters no simulation, and a test that nothing shakes no shaking. */
START_TEST(simulations) {
  static const char *const scenes[] = {PATH, SHAKES};
  for (int k = 0; k < 2; k++) {
    char text[500];
    tp_scene *scene = NULL;
    tp_tilt_test *test = NULL;
    tp_message message = {.text = ""};
    const tp_tilt_options options = tp_tilt_options_default();
    snprintf(text, sizeof text, "friction_angle_deg: 30\n%s", scenes[k]);
    solve(SLAB, text);
    ck_assert(calls[SIMULATION] == 0 && calls[SHAKING] == 0);
    snprintf(text, sizeof text,
             "topple: 1\nlength_unit: m\nblock: {%s}\nfriction_angle_deg: 30\n%s", SLAB, scenes[k]);
    ck_assert_msg(tp_scene_read_text(&scene, text, "scene", &message) == TP_OK, "%s", message.text);
    ck_assert_msg(tp_tilt_test_run(&test, scene, &options, &message) == TP_OK, "%s", message.text);
    ck_assert(calls[SIMULATION] > 0 && (calls[SHAKING] > 0) == (k == 1));
    tp_tilt_test_free(test);
    tp_scene_free(scene);
  }
}
END_TEST

/* What an effect took within another one counts once: the moments of a block with rounded corners
 * held the rounding too, and of two loads the second held the first, so that the effects added up
 * to more than all took. Hundreds of anchors tell. */
START_TEST(time_counts_once) {
  enum { TEETH = 150, ANCHORS = 300, SIZE = 1 << 16 };
  char *text = calloc(1, SIZE), *at = text;
  tp_scene *scene = NULL;
  tp_solution *solution = NULL;
  tp_message message = {.text = ""};
  tp_solve_options options = tp_solve_options_default();
  options.digits = 300;
  at = stpcpy(at, "topple: 1\nlength_unit: m\ntilt: {towards: left}\n");
  at += sprintf(at,
                "block:\n  teeth: {count: %d, width: 2, height: 200, depth: 1, left_end: valley}\n"
                "  unit_weight_kn_m3: 26\n  rounded:\n    corners:\n",
                TEETH);
  at = stpcpy(at, "    - {at: left_end, radius: 0.125}\n    - {at: right_end, radius: 0.125}\n");
  at = stpcpy(at, "loads:\n  seismic: {horizontal: 0.1}\n  anchors:\n");
  for (int k = 0; k < ANCHORS; k++) {
    at += sprintf(at, "  - {at: [0, %d], direction_deg: 7, force_kn: 1}\n", 10 + k % 150);
  }
  ck_assert_int_lt(at - text, SIZE);
  ck_assert_msg(tp_scene_read_text(&scene, text, "scene", &message) == TP_OK, "%s", message.text);
  const double began = tp_clock_now();
  ck_assert_msg(tp_solve(&solution, scene, &options, &message) == TP_OK, "%s", message.text);
  const double all = tp_clock_now() - began;
  double sum = 0;
  for (size_t k = 0; k < solution->effect_count; k++) {
    ck_assert_double_ge(solution->effects[k].seconds, 0);
    sum += solution->effects[k].seconds;
  }
  /* the sum is rounded some hundred times */
  ck_assert_msg(sum <= all * (1 + 1e-10), "the effects took %g s, all took %g s", sum, all);
  tp_solution_free(solution);
  tp_scene_free(scene);
  free(text);
}
END_TEST

int main(void) {
  Suite *suite = suite_create("effects");
  TCase *tests = tcase_create("calls");
  tcase_add_test(tests, only_what_is_called_for);
  tcase_add_test(tests, uplift);
  tcase_add_test(tests, simulations);
  tcase_add_test(tests, time_counts_once);
  suite_add_tcase(suite, tests);
  return run_suite(suite);
}
