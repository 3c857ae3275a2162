/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The quasi-static path of random blocks, half of them under loads, in every shape and contact that
 * scenes may have, against what the solve proves of them: wherever the path collapses a motion can
 * begin, it never stands beyond the limit, and where onset and limit are one the collapse is there,
 * whatever the ratio of the stiffnesses. */

#include "quasi_static/path.h"
#include "random_runs.h"
#include "random_scenes.h"
#include "suite.h"

#include <math.h>
#include <string.h>

/* Tilts closer than this are one, degrees: twice the tolerance of the path, and what an imbalance
 * of 1e-11 of the weight turns. */
static const double beside = 3e-6;

static const double last_deg = 80;

typedef struct run {
  tp_solution *solution;
  tp_rigid_body body;
  tp_path_result path;
} run;

/* False where the scene, its problem or its body is refused: laws of friction that the body does
 * not know, contacts without restraint; and where the solution is of the worst of several
 * earthquakes, of which the path has one. */
static bool prepare(run *r, const char *text, tp_direction towards, double ratio) {
  tp_message message;
  tp_scene *scene = NULL;
  tp_problem problem;
  const tp_solve_options options = tp_solve_options_default();
  memset(r, 0, sizeof *r);
  tp_status status = tp_scene_read_text(&scene, text, "random.yaml", &message);
  if (status == TP_OK) status = tp_solve(&r->solution, scene, &options, &message);
  if (status == TP_OK) {
    tp_solution *noted = calloc(1, sizeof *noted);
    ck_assert_ptr_nonnull(noted);
    status = tp_problem_init(&problem, scene, &options, noted, &message);
    if (status == TP_OK) {
      status = tp_rigid_body_init(&r->body, &problem, towards, &message);
      tp_problem_clear(&problem);
    }
    tp_solution_free(noted);
  }
  tp_scene_free(scene);
  if (status != TP_OK || r->body.closed_count == 0 || r->solution->earthquake_count > 0) {
    return false;
  }
  tp_path_settings settings = tp_path_settings_default();
  settings.normal_pa_m = 1e6 * r->body.mass_kg * TP_GRAVITY_M_S2 /
                         (r->body.extent_m * r->body.extent_m * r->body.thickness_m);
  settings.shear_pa_m = ratio * settings.normal_pa_m;
  settings.to_angle = last_deg * acos(-1) / 180;
  settings.moments_every = 0;
  settings.most_events = 500;
  status = tp_path_run(&r->path, &r->body, &settings, NULL, &message);
  ck_assert_msg(status == TP_OK || strstr(message.text, "stiffness must be") != NULL, "%s",
                message.text);
  return status == TP_OK;
}

static void clear(run *r) {
  tp_rigid_body_clear(&r->body);
  tp_solution_free(r->solution);
}

static bool can_begin(const tp_onset *onset, double deg) {
  for (size_t k = 0; k < onset->window_count; k++) {
    const tp_window *own = onset->windows + k;
    if (!own->from_below && deg < own->from_deg.value - beside) continue;
    if (own->to_above || deg <= own->to_deg.value + beside) return true;
  }
  return false;
}

static double limit_deg(const tp_limit *limit) {
  return limit->kind == TP_LIMIT_AT_ANGLE      ? limit->critical_angle_deg.value
         : limit->kind == TP_LIMIT_INTERLOCKED ? 90
                                               : -90;
}

/* Of those at a limit `wide`: what happens close to it was not sure. */
typedef struct tally {
  long runs, collapsed, at_once, stood, tied, wide, within, undecided;
} tally;

static void claim(tally *t, const run *r, const tp_case *own, ulong seed) {
  const double degree = 180 / acos(-1), limit = limit_deg(&own->limit);
  const double stands = r->path.stands_to * degree, falls = r->path.collapses_at * degree;
  t->runs++;
  if (r->path.end == TP_RUN_UNDECIDED) {
    t->undecided++;
    return;
  }
  if (r->path.stood) {
    ck_assert_msg(stands <= limit + beside, "%lu: stands at %.9g, limit %.9g", seed, stands, limit);
  }
  if (r->path.end == TP_RUN_STANDS) {
    t->stood++;
    return;
  }
  ck_assert_msg(can_begin(&own->onset, falls), "%lu: falls at %.9g, no motion can begin there",
                seed, falls);
  ck_assert(r->path.imbalance <= 1e-10);
  t->at_once += !r->path.stood;
  t->collapsed += r->path.stood;
  const bool tied = own->onset.kind == TP_ONSET_AT_ANGLE && !own->onset.below_limit;
  if (r->path.stood && tied) {
    ck_assert_msg(stands <= limit + beside && falls >= limit - beside,
                  "%lu: stands to %.9g, falls at %.9g, limit %.9g", seed, stands, falls, limit);
    t->wide += falls - stands > beside;
    t->tied++;
  } else if (r->path.stood && falls < limit - beside) {
    t->within++;
  }
}

static bool is_decided(const tp_case *own) {
  return own->limit.kind != TP_LIMIT_UNDECIDED && own->limit.kind != TP_LIMIT_NOT_ASKED &&
         own->onset.kind != TP_ONSET_UNDECIDED && own->onset.kind != TP_ONSET_NOT_ASKED;
}

START_TEST(paths_collapse_where_motions_can_begin) {
  static const double ratios[] = {0.01, 0.4, 1};
  const uint64_t first = random_seed();
  const long count = random_scenes_or(1500);
  tally t = {0};
  for (long k = 0; k < count; k++) {
    const uint64_t seed = first + (uint64_t)k;
    random_numbers state = random_numbers_from(seed);
    random_scene scene;
    random_scene_draw(&scene, &state);
    if (seed % 2 == 0) random_effects_draw(&scene, &state);
    char *text = random_scene_text(&scene);
    run r;
    const tp_direction towards = seed % 4 < 2 ? TP_TOWARDS_LEFT : TP_TOWARDS_RIGHT;
    if (prepare(&r, text, towards, ratios[seed % 3])) {
      for (size_t c = 0; c < r.solution->case_count; c++) {
        const tp_case *own = r.solution->cases + c;
        if (own->towards == towards && is_decided(own)) {
          claim(&t, &r, own, (ulong)seed);
        }
      }
    }
    clear(&r);
    free(text);
    random_scene_clear(&scene);
  }
  printf(
      "%ld paths: %ld collapse (%ld where onset and limit are one, %ld of them wide, %ld between "
      "them), %ld at once, %ld stand, %ld undecided\n",
      t.runs, t.collapsed, t.tied, t.wide, t.within, t.at_once, t.stood, t.undecided);
  if (count < 200) return;
  ck_assert_int_gt(t.collapsed, count / 20);
  ck_assert_int_gt(t.tied, count / 50);
  ck_assert_int_le(t.undecided, t.runs / 100);
  ck_assert_int_le(t.wide, t.runs / 100);
}
END_TEST

SUITE(random_path) {
  Suite *suite = suite_create("random path");
  TCase *cases = tcase_create("random path");
  tcase_set_timeout(cases, 0);
  tcase_add_test(cases, paths_collapse_where_motions_can_begin);
  suite_add_tcase(suite, cases);
  return suite;
}
