/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Which motions can begin at every tilt, of random scenes with all effects. The ranges together are
 * the windows in which any motion can begin, and at the scene's tilt their motions are those whose
 * accelerations and forces are found there one by one. */

#include "random_runs.h"
#include "random_scenes.h"
#include "suite.h"

#include <math.h>

/* What lies closer to an end than this is not looked at, degrees. */
static const double beside = 1e-6;

static tp_solution *solve(const random_scene *drawn, bool ranges) {
  char *text = random_scene_text(drawn);
  tp_message message;
  tp_scene *scene = NULL;
  tp_solution *solution = NULL;
  tp_solve_options options = tp_solve_options_default();
  options.strength_reduction = false;
  options.motion_ranges = ranges;
  tp_status status = tp_scene_read_text(&scene, text, "random.yaml", &message);
  if (status == TP_OK) status = tp_solve(&solution, scene, &options, &message);
  tp_scene_free(scene);
  free(text);
  return status == TP_OK ? solution : NULL;
}

static bool same(tp_bounded a, tp_bounded b) {
  return fabs(a.value - b.value) <= a.error + b.error;
}

static bool is_long(const tp_window *w) {
  return w->from_below || w->to_above || !same(w->from_deg, w->to_deg);
}

/* Ranges that meet, put together, are the windows of more than one tilt. */
static void claim_windows(const tp_onset *onset, uint64_t seed) {
  size_t k = 0;
  for (size_t w = 0; w < onset->window_count; w++) {
    const tp_window *own = onset->windows + w;
    if (!is_long(own)) continue;
    ck_assert_msg(k < onset->range_count, "%lu: a window without a range", (ulong)seed);
    const tp_motion_range *first = onset->ranges + k;
    while (k + 1 < onset->range_count && !onset->ranges[k].to_above &&
           onset->ranges[k].to_deg.value == onset->ranges[k + 1].from_deg.value) {
      ck_assert_msg(onset->ranges[k].motions != onset->ranges[k + 1].motions,
                    "%lu: two ranges of the same motions", (ulong)seed);
      k++;
    }
    const tp_motion_range *last = onset->ranges + k++;
    ck_assert_msg(first->from_below == own->from_below && last->to_above == own->to_above &&
                      (own->from_below || same(first->from_deg, own->from_deg)) &&
                      (own->to_above || same(last->to_deg, own->to_deg)),
                  "%lu: ranges are not the window", (ulong)seed);
  }
  ck_assert_msg(k == onset->range_count, "%lu: a range without a window", (ulong)seed);
}

/* True where the tilt lies well within a range, or well without all. At 90 degrees nothing presses
 * the block against its base, and all ways to leave it are one. */
static bool find_motions(unsigned *motions, const tp_onset *onset, double tilt) {
  *motions = 0;
  if (90 - tilt < beside) return false;
  for (size_t k = 0; k < onset->range_count; k++) {
    const tp_motion_range *own = onset->ranges + k;
    const double from = own->from_below ? -INFINITY : own->from_deg.value;
    const double to = own->to_above ? INFINITY : own->to_deg.value;
    if (fabs(tilt - from) < beside || fabs(tilt - to) < beside) return false;
    if (from < tilt && tilt < to) *motions = own->motions;
  }
  for (size_t k = 0; k < onset->window_count; k++) { /* of one tilt alone */
    const tp_window *own = onset->windows + k;
    if (!is_long(own) && fabs(tilt - own->from_deg.value) < beside) return false;
  }
  return true;
}

static bool claim_motions(const tp_onset *onset, double tilt, uint64_t seed) {
  unsigned motions = 0, found = 0;
  /* level and without friction, sliding one way and the other meet: in both, and standing still */
  if (tilt == 0 && onset->friction_angle_deg.value == 0) return false;
  if (!onset->has_motions || !find_motions(&motions, onset, tilt)) return false;
  for (size_t k = 0; k < onset->motion_count; k++) found |= 1U << onset->motions[k].mechanism;
  ck_assert_msg(motions == found, "%lu: motions %x in the range, %x at the tilt", (ulong)seed,
                motions, found);
  return motions != 0;
}

START_TEST(test_ranges_of_random_scenes) {
  const uint64_t first = random_seed();
  const long count = random_scenes_or(1000);
  long windows = 0, moving = 0;
  for (long k = 0; k < count; k++) {
    random_numbers state = random_numbers_from(first + (uint64_t)k);
    random_scene scene;
    random_scene_draw(&scene, &state);
    if (k % 2 == 0) random_effects_draw(&scene, &state);
    tp_solution *asked = solve(&scene, true), *plain = solve(&scene, false);
    ck_assert((asked == NULL) == (plain == NULL));
    for (size_t c = 0; asked != NULL && c < asked->case_count; c++) {
      const tp_onset *onset = &asked->cases[c].onset;
      ck_assert(!plain->cases[c].onset.has_ranges && plain->cases[c].onset.range_count == 0);
      if (!onset->has_ranges) continue;
      claim_windows(onset, first + (uint64_t)k);
      windows += onset->window_count > 0;
      moving += asked->has_tilt_angle &&
                claim_motions(onset, asked->tilt_angle_deg.value, first + (uint64_t)k);
    }
    tp_solution_free(asked);
    tp_solution_free(plain);
    random_scene_clear(&scene);
  }
  printf("%ld cases with windows, %ld moving\n", windows, moving);
  if (count < 200) return;
  ck_assert_int_gt(windows, count / 2);
  ck_assert_int_gt(moving, count / 10);
}
END_TEST

SUITE(random_motions) {
  Suite *suite = suite_create("random motions");
  TCase *cases = tcase_create("random motions");
  tcase_set_timeout(cases, 0);
  tcase_add_test(cases, test_ranges_of_random_scenes);
  suite_add_tcase(suite, cases);
  return suite;
}
