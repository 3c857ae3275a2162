/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Random scenes, moved, scaled, mirrored, written otherwise or turned: what they tell changes as it
 * must. Scaled by a power of two, not even a bit changes. */

#include "compare_bits.h"
#include "random_truth.h"
#include "random_variants.h"
#include "suite.h"

#include <string.h>

static uint64_t seed; /* of the scene in hand */

/* Check writes to a file for each assertion that holds. */
static void claim(bool condition, const char *what, const char *why, const char *text) {
  if (condition) return;
  ck_abort_msg("%s: %s: TOPPLE_RANDOM_SEED=%lu TOPPLE_RANDOM_SCENES=1\n%s", what, why, (ulong)seed,
               text);
}

/* NULL where the scene is refused. */
static tp_solution *solve(const random_scene *drawn, char **text) {
  tp_message message;
  tp_scene *scene = NULL;
  tp_solution *solution = NULL;
  *text = random_scene_text(drawn);
  const tp_solve_options options = tp_solve_options_default();
  claim(tp_scene_read_text(&scene, *text, "random.yaml", &message) == TP_OK, "read", message.text,
        *text);
  const tp_status status = tp_solve(&solution, scene, &options, &message);
  claim(status == TP_OK || status == TP_BAD_INPUT, "solved or refused", message.text, *text);
  tp_scene_free(scene);
  return solution;
}

enum { ENOUGH = 200 }; /* scenes to speak of shares */

typedef struct counts {
  long refused, compared[VARIANTS];
} counts;

static void claim_variant(counts *seen, const random_scene *scene, const tp_solution *one,
                          int variant, random_numbers *state) {
  random_scene changed;
  relation r;
  char why[256], *text = NULL;
  random_scene_copy(&changed, scene);
  relation_init(&r);
  const random_variant *v = random_variants + variant;
  if (v->change(&changed, &r, state)) {
    tp_solution *other = solve(&changed, &text);
    claim(other != NULL, v->name, "refused", text);
    claim(solutions_agree(why, one, other, &r), v->name, why, text);
    seen->compared[variant]++;
    tp_solution_free(other);
    free(text);
  }
  relation_clear(&r);
  random_scene_clear(&changed);
}

/* Beyond 2^22: together with 30 powers of two and some for what the scene adds, beyond a double. */
static bool is_large(const polygon *p) {
  bool large = false;
  for (long k = 0; k < p->count; k++) {
    large = large || labs(p->x[k]) > 1L << 22 || labs(p->y[k]) > 1L << 22;
  }
  return large;
}

/* All lengths times a power of two, with which the integers of the lattice stay below 2^53 and
 * doubles hold them; or with both so far beyond that doubles hold neither. */
static void claim_powers_of_two(random_scene *scene, random_numbers *state) {
  char why[256], *texts[2] = {NULL, NULL};
  const bool beyond = draw_once_in(state, 2) || is_large(&scene->outline);
  random_scene_make_even(scene);
  if (beyond) random_scene_double(scene, 60);
  tp_solution *one = solve(scene, texts);
  const int power = (int)draw_below(state, beyond ? 100 : 30);
  random_scene_double(scene, power);
  tp_solution *other = solve(scene, texts + 1);
  claim((one == NULL) == (other == NULL), "a power of two", "refused", texts[1]);
  const bool same = one == NULL || solutions_same_bits(why, one, other, power);
  claim(same, "a power of two", why, texts[1]);
  tp_solution_free(one);
  tp_solution_free(other);
  free(texts[0]);
  free(texts[1]);
}

/* Scene by scene: the truth by triangles, then all its variants. */
START_TEST(test_variants_of_random_scenes) {
  const uint64_t first = random_seed();
  const long count = random_scenes();
  counts seen = {0};
  for (long k = 0; k < count; k++) {
    seed = first + (uint64_t)k;
    random_numbers state = random_numbers_from(seed);
    random_scene scene;
    char *text = NULL, why[256];
    random_scene_draw(&scene, &state);
    tp_solution *one = solve(&scene, &text);
    if (one == NULL) {
      seen.refused++;
    } else {
      claim(solution_is_true(why, one, &scene), "by triangles", why, text);
      for (int v = 0; v < VARIANTS; v++) claim_variant(&seen, &scene, one, v, &state);
    }
    claim_powers_of_two(&scene, &state);
    tp_solution_free(one);
    free(text);
    random_scene_clear(&scene);
  }
  ck_assert_int_le(seen.refused, count / 50 + 1);
  for (int v = 0; v < VARIANTS && count >= ENOUGH; v++) {
    ck_assert_int_gt(seen.compared[v], count / 10);
  }
}
END_TEST

SUITE(random_scenes) {
  Suite *suite = suite_create("random scenes");
  TCase *cases = tcase_create("random scenes");
  tcase_set_timeout(cases, 0);
  tcase_add_test(cases, test_variants_of_random_scenes);
  suite_add_tcase(suite, cases);
  return suite;
}
