/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The law of the factor that governs, over random scenes with all effects, at tilts of a sweep and
 * on both sides of every tilt at which motions begin or end: it is below 1 exactly where a motion
 * can begin at the tilt, it names a motion that can begin there, and it passes 1 without a leap
 * where motions begin as the tilt rises. Where they end more load would stop them, which is no
 * factor of safety.
 * The verdict, the windows and the motions are found by other rooms than the factor.
 */

#include "random_runs.h"
#include "random_variants.h"
#include "suite.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { SWEEP = 10, SHORT = 120, SHOWN = 20 };

typedef struct counts {
  long points, standing, moving, undecided, ends, told, mirrored, law, names, leaps, apart;
} counts;

static uint64_t seed;
static long shown;

static void show(const char *what, const tp_case *c, double tilt) {
  if (shown++ >= SHOWN) return;
  const tp_governing_fos *g = &c->governing_fos;
  printf("%s: TOPPLE_RANDOM_SEED=%lu TOPPLE_RANDOM_SCENES=1, %s at %.12g: %s, state %d, fos %.9g "
         "(%s)\n",
         what, (ulong)seed, c->towards == TP_TOWARDS_LEFT ? "left" : "right", tilt,
         tp_mechanism_name(c->mechanism), (int)g->fos.state, g->fos.value.value,
         g->has_factor ? tp_fos_definition_name(g->factors[g->factor].definition) : "-");
  fflush(stdout);
}

static tp_solution *solve(const random_scene *drawn) {
  char *text = random_scene_text(drawn);
  tp_message message;
  tp_scene *scene = NULL;
  tp_solution *solution = NULL;
  const tp_solve_options options = tp_solve_options_default();
  tp_status status = tp_scene_read_text(&scene, text, "random.yaml", &message);
  if (status == TP_OK) status = tp_solve(&solution, scene, &options, &message);
  tp_scene_free(scene);
  free(text);
  return status == TP_OK ? solution : NULL;
}

static tp_solution *solve_at(random_scene *scene, double tilt) {
  fmpq *number = scene->numbers + TILT;
  fmpq_set_si(number, (slong)llrint(ldexp(tilt, 40)), 1);
  fmpz_mul_2exp(fmpq_denref(number), fmpq_denref(number), 40);
  fmpq_canonicalise(number);
  scene->has_tilt = true;
  return solve(scene);
}

static bool stands(const tp_case *c) {
  return c->mechanism == TP_STANDS || c->mechanism == TP_INTERLOCKED;
}

/* Certainly below 1, where none is as well; certainly above 1, where unbounded is as well. */
static bool is_below(const tp_governing_fos *g) {
  return g->fos.state == TP_FOS_UNDEFINED ||
         (g->fos.state == TP_FOS_NUMBER && g->fos.value.value + g->fos.value.error < 1);
}

static bool is_above(const tp_governing_fos *g) {
  return g->fos.state == TP_FOS_NO_OVERTURNING ||
         (g->fos.state == TP_FOS_NUMBER && g->fos.value.value - g->fos.value.error > 1);
}

static bool names_a_motion(const tp_case *c) {
  const tp_governing_fos *g = &c->governing_fos;
  if (!g->has_factor || !c->onset.has_motions || c->onset.beginning_count == 0) return true;
  const tp_mechanism named = g->factors[g->factor].mechanism;
  for (size_t k = 0; k < c->onset.beginning_count; k++) {
    if (c->onset.beginnings[k] == named) return true;
  }
  return false;
}

static void claim_law(counts *seen, const tp_case *c, double tilt) {
  const tp_governing_fos *g = &c->governing_fos;
  const bool told = g->fos.state == TP_FOS_NUMBER || g->fos.state == TP_FOS_UNDEFINED ||
                    g->fos.state == TP_FOS_NO_OVERTURNING;
  if (c->mechanism == TP_MECHANISM_UNDECIDED || !told || !g->complete) {
    seen->undecided++;
    return;
  }
  const bool holds = stands(c);
  seen->points++;
  seen->standing += holds;
  seen->moving += !holds;
  if (holds ? is_below(g) : is_above(g)) {
    seen->law++;
    show(holds ? "below 1, and stands" : "above 1, and moves", c, tilt);
  }
  if (!holds && !names_a_motion(c)) {
    seen->names++;
    show("names no motion that can begin", c, tilt);
  }
}

/* A case at a tilt: how far from 1 its factor is, or NAN, and whether it stands. */
typedef struct beside {
  double distance;
  bool stands;
  tp_case c; /* numbers alone */
} beside;

static beside look(counts *seen, random_scene *scene, size_t number, double tilt) {
  beside at = {.distance = NAN};
  tp_solution *solution = solve_at(scene, tilt);
  if (solution != NULL && number < solution->case_count) {
    const tp_case *c = solution->cases + number;
    const tp_fos *fos = &c->governing_fos.fos;
    claim_law(seen, c, tilt);
    at.c = *c;
    at.stands = stands(c);
    if (fos->state == TP_FOS_NUMBER) at.distance = fabs(log(fmax(fos->value.value, 1e-9)));
    if (fos->state == TP_FOS_UNDEFINED || fos->state == TP_FOS_NO_OVERTURNING) {
      at.distance = INFINITY;
    }
  }
  tp_solution_free(solution);
  return at;
}

/* Where motions begin, so that the verdict differs on both sides, the factor comes to 1 as
 * the tilt does: a hundredth of the way leaves less than a third of the distance, where any is left
 * to speak of. */
static void claim_end(counts *seen, random_scene *scene, size_t number, double end, bool leaps) {
  static const double far = 1e-3, near = 1e-5, nothing = 0.01, part = 0.3, upright = 89.9;
  if (!(end > 2 * far && end < upright)) return;
  const beside below = look(seen, scene, number, end - near);
  const beside above = look(seen, scene, number, end + near);
  if (!leaps || below.stands == above.stands || isnan(below.distance) || isnan(above.distance))
    return;
  for (int side = -1; side <= 1; side += 2) {
    const beside *own = side < 0 ? &below : &above;
    const beside farther = look(seen, scene, number, end + side * far);
    if (isnan(farther.distance)) continue;
    seen->ends++;
    if (own->distance < nothing || own->distance < part * farther.distance) continue;
    seen->leaps++;
    show("a leap", &own->c, end + side * near);
  }
}

static bool is_same(const tp_governing_fos *a, const tp_governing_fos *b) {
  return a->fos.state == b->fos.state &&
         (a->fos.state != TP_FOS_NUMBER ||
          fabs(a->fos.value.value - b->fos.value.value) <= a->fos.value.error + b->fos.value.error);
}

/* The mirror image tilts the other way and has the same factor. */
static void claim_mirrored(counts *seen, const random_scene *scene, const tp_solution *one,
                           double tilt) {
  random_scene image;
  random_numbers none = random_numbers_from(0);
  relation r;
  size_t k = 0;
  while (strcmp(random_variants[k].name, "mirrored") != 0) k++;
  random_scene_copy(&image, scene);
  relation_init(&r);
  (void)random_variants[k].change(&image, &r, &none);
  tp_solution *other = solve_at(&image, tilt);
  const size_t count = other != NULL && other->case_count == one->case_count ? one->case_count : 0;
  for (size_t n = 0; n < count; n++) {
    const tp_case *c = one->cases + n, *mirrored = other->cases + (count - 1 - n);
    seen->mirrored++;
    if (!c->governing_fos.complete || !mirrored->governing_fos.complete ||
        is_same(&c->governing_fos, &mirrored->governing_fos)) {
      continue;
    }
    seen->apart++;
    show("not that of its mirror image", c, tilt);
  }
  tp_solution_free(other);
  relation_clear(&r);
  random_scene_clear(&image);
}

static void claim_scene(counts *seen, random_numbers *state) {
  random_scene scene;
  random_scene_draw(&scene, state);
  if (seed % 2 == 0) random_effects_draw(&scene, state);
  tp_solution *first = scene.has_friction ? solve_at(&scene, 10) : NULL;
  for (size_t n = 0; first != NULL && n < first->case_count; n++) {
    const tp_onset *onset = &first->cases[n].onset;
    for (size_t w = 0; w < onset->window_count && !first->friction_is_residual; w++) {
      const tp_window *own = onset->windows + w;
      if (!own->from_below) claim_end(seen, &scene, n, own->from_deg.value, true);
      if (!own->to_above) claim_end(seen, &scene, n, own->to_deg.value, false);
    }
  }
  for (int k = 0; first != NULL && k < SWEEP; k++) {
    const double tilt = k == 0 ? 0 : 80 * draw_part(state);
    tp_solution *solution = solve_at(&scene, tilt);
    for (size_t n = 0; solution != NULL && n < solution->case_count; n++) {
      claim_law(seen, solution->cases + n, tilt);
    }
    if (k == 1 && solution != NULL) claim_mirrored(seen, &scene, solution, tilt);
    tp_solution_free(solution);
  }
  seen->told += first != NULL;
  tp_solution_free(first);
  random_scene_clear(&scene);
}

START_TEST(test_governing_of_random_scenes) {
  const uint64_t begin = random_seed();
  const long count = random_scenes_or(SHORT);
  counts seen = {0};
  for (long k = 0; k < count; k++) {
    seed = begin + (uint64_t)k;
    random_numbers state = random_numbers_from(seed);
    claim_scene(&seen, &state);
  }
  printf("%ld scenes, %ld points: %ld stand, %ld move, %ld undecided; %ld sides of ends\n",
         seen.told, seen.points, seen.standing, seen.moving, seen.undecided, seen.ends);
  printf("against the law: %ld below or above 1, %ld names, %ld leaps; %ld of %ld mirrored\n",
         seen.law, seen.names, seen.leaps, seen.apart, seen.mirrored);
  fflush(stdout); /* the runner ends a test that fails without it */
  ck_assert_int_eq(seen.law, 0);
  ck_assert_int_eq(seen.names, 0);
  ck_assert_int_eq(seen.leaps, 0);
  ck_assert_int_eq(seen.apart, 0);
  if (count < SHORT) return;
  ck_assert_int_gt(seen.standing, 2 * count);
  ck_assert_int_gt(seen.moving, 2 * count);
  ck_assert_int_gt(seen.ends, count / 2);
  ck_assert_int_lt(seen.undecided, seen.points / 20);
}
END_TEST

SUITE(random_governing) {
  Suite *suite = suite_create("random governing");
  TCase *cases = tcase_create("random governing");
  tcase_set_timeout(cases, 0);
  tcase_add_test(cases, test_governing_of_random_scenes);
  suite_add_tcase(suite, cases);
  return suite;
}
