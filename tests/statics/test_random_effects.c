/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Random scenes that combine effects: rounded corners, arcs, ellipses, holes, parts, profiles with
 * notches and walls, bases that go on, kinks, all loads and all laws of friction; slopes that are
 * shaken both ways, water of a level with cracks, uplift and ice, bolts of a spacing, linings.
 * Whatever is true
 * of a block is true of its mirror image, of the same block elsewhere, larger, in another unit,
 * written otherwise, tilted towards one side at a time, by another arithmetic and to other digits.
 * This is the test that finds what no list of cases does: each wrong answer of one of these
 * programs was at odds with one of them. TOPPLE_RANDOM_SCENES above 10 000 holds each scene against
 * one property drawn for it, else against all. */

#include "random_variants.h"
#include "suite.h"

#include <string.h>
#include <time.h>

enum { SHOWN = 20 };

static uint64_t seed; /* of the scene in hand */
static long failed;   /* claims that did not hold: a long run goes on to find more than one kind */

static void claim(bool condition, const char *what, const char *why, const char *text) {
  if (condition || failed++ >= SHOWN) return;
  printf("%s: %s: TOPPLE_RANDOM_SEED=%lu TOPPLE_RANDOM_SCENES=1\n%s\n", what, why, (ulong)seed,
         text);
  fflush(stdout); /* the runner ends a test that fails without it */
}

typedef struct result {
  char *text;
  tp_status status; /* TP_OK, TP_BAD_INPUT, TP_NO_ANSWER or TP_UNDECIDED */
  tp_message message;
  tp_solution *solution; /* NULL where there is none */
  double seconds;
} result;

enum { BUDGET_SECONDS = 5, ENDLESS_SECONDS = 60 }; /* told apart from a slow machine */

static result solve(const random_scene *drawn, const tp_solve_options *options) {
  result r = {.text = random_scene_text(drawn)};
  tp_scene *scene = NULL;
  const clock_t start = clock();
  r.status = tp_scene_read_text(&scene, r.text, "random.yaml", &r.message);
  if (r.status == TP_OK) r.status = tp_solve(&r.solution, scene, options, &r.message);
  r.seconds = (double)(clock() - start) / CLOCKS_PER_SEC;
  claim(r.status != TP_OUT_OF_MEMORY && r.status != TP_SYSTEM_FAILED &&
            r.status != TP_DEPENDENCY_FAILED,
        "solved, refused or undecided", r.message.text, r.text);
  tp_scene_free(scene);
  return r;
}

static void clear(result *r) {
  tp_solution_free(r->solution);
  free(r->text);
}

static bool is_refused(const result *r) {
  return r->status == TP_BAD_INPUT || r->status == TP_NO_ANSWER;
}

/* The tangents of an arc's pieces stand for it where it might be crossed, and its pieces begin at
 * one of its ends: of an edge that passes an arc by less than those, a mirror image may be let by.
 */
static bool is_passed_closely(const result *r) {
  return is_refused(r) &&
         strstr(r->message.text, "the outline with its arcs crosses itself") != NULL;
}

enum { DIRECTIONS_APART = VARIANTS, OTHER_DIGITS, CHEAPER_LEVEL, PROPERTIES };

typedef struct counts {
  long scenes, refused, undecided, slow, compared[PROPERTIES];
} counts;

/* The changed scene is refused where the first one is, and otherwise tells the same. */
static void claim_same(counts *seen, const result *one, const random_scene *changed,
                       const relation *r, const tp_solve_options *options, int property,
                       const char *name) {
  char why[256];
  result other = solve(changed, options);
  claim(other.seconds < ENDLESS_SECONDS, name, "does not end", other.text);
  if (is_refused(one) != is_refused(&other) && !is_passed_closely(one) &&
      !is_passed_closely(&other)) {
    claim(false, is_refused(one) ? "refused, but not" : name,
          is_refused(one) ? one->message.text : other.message.text, other.text);
  }
  if (one->solution != NULL && other.solution != NULL) {
    const bool agree = solutions_agree(why, one->solution, other.solution, r);
    claim(agree, name, why, other.text);
    if (!agree && failed <= SHOWN) printf("which is of the scene\n%s\n", one->text);
    seen->compared[property]++;
  }
  clear(&other);
}

static void claim_variant(counts *seen, const random_scene *scene, const result *one, int variant,
                          random_numbers *state) {
  const tp_solve_options options = tp_solve_options_default();
  random_scene changed;
  relation r;
  random_scene_copy(&changed, scene);
  relation_init(&r);
  r.capacities = random_effects_allow(&scene->effects);
  if (random_variants[variant].change(&changed, &r, state)) {
    claim_same(seen, one, &changed, &r, &options, variant, random_variants[variant].name);
  }
  relation_clear(&r);
  random_scene_clear(&changed);
}

/* Both directions are those of each by itself. */
static void claim_direction(counts *seen, const random_scene *scene, const result *one,
                            random_numbers *state) {
  if (scene->effects.towards != TOWARDS_BOTH) return;
  const tp_solve_options options = tp_solve_options_default();
  random_scene changed;
  relation r;
  char why[256];
  random_scene_copy(&changed, scene);
  relation_init(&r);
  r.capacities = random_effects_allow(&scene->effects);
  const int side = (int)draw_below(state, 2);
  changed.effects.towards = side == 0 ? TOWARDS_LEFT : TOWARDS_RIGHT;
  result other = solve(&changed, &options);
  claim(is_refused(one) || !is_refused(&other), "one direction", other.message.text, other.text);
  if (one->solution != NULL && other.solution != NULL) {
    tp_solution half = *one->solution;
    half.case_count = 1;
    half.cases = one->solution->cases + side;
    claim(solutions_agree(why, &half, other.solution, &r), "one direction", why, other.text);
    seen->compared[DIRECTIONS_APART]++;
  }
  clear(&other);
  relation_clear(&r);
  random_scene_clear(&changed);
}

static void claim_options(counts *seen, const random_scene *scene, const result *one, int property,
                          random_numbers *state) {
  static const int digits[] = {1, 3, 6, 12, 15, 20, 30};
  tp_solve_options options = tp_solve_options_default();
  relation r;
  relation_init(&r);
  r.capacities = random_effects_allow(&scene->effects);
  if (property == OTHER_DIGITS) options.digits = digits[draw_below(state, 7)];
  if (property == CHEAPER_LEVEL) options.level = (tp_level)draw_below(state, TP_LEVEL_EXACT);
  r.uncertain = property == CHEAPER_LEVEL;
  char name[64];
  snprintf(name, sizeof name, "to %d digits by %s", options.digits, tp_level_name(options.level));
  claim_same(seen, one, scene, &r, &options, property, name);
  relation_clear(&r);
}

/* Each property draws from the seed by itself, so that one scene alone shows what failed among
 * many. */
static void claim_property(counts *seen, const random_scene *scene, const result *one,
                           int property) {
  random_numbers state = random_numbers_from(~(seed * PROPERTIES + (uint64_t)property));
  if (property < VARIANTS) claim_variant(seen, scene, one, property, &state);
  if (property == DIRECTIONS_APART) claim_direction(seen, scene, one, &state);
  if (property > DIRECTIONS_APART) claim_options(seen, scene, one, property, &state);
}

enum { ALL_PROPERTIES_UP_TO = 10000, ENOUGH = 80 };

static void claim_scene(counts *seen, long count) {
  const tp_solve_options options = tp_solve_options_default();
  random_numbers state = random_numbers_from(seed);
  random_scene scene;
  random_scene_draw(&scene, &state);
  random_effects_draw(&scene, &state);
  result one = solve(&scene, &options);
  claim(one.seconds < ENDLESS_SECONDS, "as drawn", "does not end", one.text);
  if (one.seconds > BUDGET_SECONDS) {
    printf("TOPPLE_RANDOM_SEED=%lu takes %.1f s\n", (ulong)seed, one.seconds);
    seen->slow++;
  }
  seen->scenes++;
  seen->refused += is_refused(&one);
  seen->undecided += one.solution != NULL && tp_solution_is_undecided(one.solution);
  if (count > ALL_PROPERTIES_UP_TO) {
    claim_property(seen, &scene, &one, (int)draw_below(&state, PROPERTIES));
  } else {
    for (int p = 0; p < PROPERTIES; p++) claim_property(seen, &scene, &one, p);
  }
  clear(&one);
  random_scene_clear(&scene);
}

START_TEST(test_effects_of_random_scenes) {
  const uint64_t first = random_seed();
  const long count = random_scenes_of(80, 2500);
  counts seen = {0};
  for (long k = 0; k < count; k++) {
    seed = first + (uint64_t)k;
    claim_scene(&seen, count);
  }
  ck_assert_int_eq(failed, 0);
  printf("%ld scenes: %ld refused, %ld undecided, %ld over %d s\n", seen.scenes, seen.refused,
         seen.undecided, seen.slow, BUDGET_SECONDS);
  if (count < ENOUGH) return;
  ck_assert_int_lt(seen.refused, count / 2);
  ck_assert_int_lt(seen.undecided, count / 100 + 1);
  for (int p = 0; p < PROPERTIES; p++) ck_assert_int_gt(seen.compared[p], count / 400);
}
END_TEST

SUITE(random_effects) {
  Suite *suite = suite_create("random effects");
  TCase *cases = tcase_create("random effects");
  tcase_set_timeout(cases, 0);
  tcase_add_test(cases, test_effects_of_random_scenes);
  suite_add_tcase(suite, cases);
  return suite;
}
