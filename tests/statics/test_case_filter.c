/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What doubles with bounds tell of a case, against a solve of the same scene: the same words, and
 * numbers whose bounds meet. The solve shares none of it. */

#include "random_runs.h"
#include "suite.h"

#include "case_filter/case_filter.h"
#include "evaluation/case_numbers.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { TEXT = 3000, VARIABLES = 4, NUMBERS = VARIABLES + 2 + TP_LOAD_NUMBERS };

/* A scene, what varies in it, and the filter of it. */
typedef struct stage {
  tp_scene *scene;
  tp_scene_key keys[NUMBERS]; /* the variables, then friction and tilt, then those of loads: */
  tp_load_number loads[TP_LOAD_NUMBERS];
  double means[VARIABLES], load_means[TP_LOAD_NUMBERS];
  size_t count, load_count;
  bool keeps_tilt; /* its loads are those of one tilt */
  tp_case_filter *filter;
} stage;

static void expect(tp_status status, const tp_message *message) {
  ck_assert_msg(status == TP_OK, "%s", message->text);
}

/* `variables`: so many parameters p0, p1, … */
static void set_stage(stage *s, const char *text, size_t variables) {
  tp_message message = {.text = ""};
  *s = (stage){.count = variables};
  expect(tp_scene_read_text(&s->scene, text, "scene.yaml", &message), &message);
  static const char *const names[] = {"parameters.p0", "parameters.p1", "parameters.p2",
                                      "parameters.p3"};
  for (size_t k = 0; k < variables; k++) {
    expect(tp_scene_key_find(s->keys + k, s->scene, names[k], &message), &message);
  }
  expect(tp_scene_key_find(s->keys + variables, s->scene, "friction_angle_deg", &message),
         &message);
  expect(tp_scene_key_find(s->keys + variables + 1, s->scene, "tilt.angle_deg", &message),
         &message);
  expect(tp_case_filter_new(&s->filter, s->scene, s->keys, variables, &message), &message);
}

/* What its loads depend on varies, too. */
static void add_load_numbers(stage *s) {
  tp_message message;
  for (int k = 0; k < TP_LOAD_NUMBERS; k++) {
    tp_scene_key *key = s->keys + s->count + 2 + s->load_count;
    const tp_load_number number = (tp_load_number)k;
    if (tp_scene_key_find(key, s->scene, tp_load_number_key(number), &message) != TP_OK) continue;
    s->load_means[s->load_count] = s->filter != NULL ? s->filter->loads.numbers[k].value : 0;
    s->loads[s->load_count++] = number;
  }
}

static void clear_stage(stage *s) {
  free(s->filter);
  tp_scene_free(s->scene);
}

/* ---- against a solve ---------------------------------------------------------------------------
 */

/* NULL where there is no such block. */
static tp_solution *solve(const stage *s, const double *values) {
  fmpq numbers[NUMBERS];
  const size_t count = s->count + 2 + s->load_count;
  for (size_t k = 0; k < count; k++) {
    fmpq_init(numbers + k);
    fmpq_set_si(numbers + k, (slong)(values[k] * 65536), 65536);
  }
  tp_message message;
  tp_scene *scene = NULL;
  tp_solution *solution = NULL;
  tp_solve_options options = tp_solve_options_default();
  if (tp_scene_vary(&scene, s->scene, s->keys, numbers, count, &message) == TP_OK &&
      tp_solve(&solution, scene, &options, &message) != TP_OK) {
    solution = NULL;
  }
  tp_scene_free(scene);
  for (size_t k = 0; k < count; k++) fmpq_clear(numbers + k);
  return solution;
}

static void meets(tp_near own, tp_bounded other, const char *what) {
  ck_assert_msg(fabs(own.value - other.value) <= own.error + other.error, "%s: %.17g +- %g, %.17g",
                what, own.value, own.error, other.value);
  ck_assert_msg(own.error <= 1e-9 * fabs(own.value) + 1e-13, "%s is wide: %.17g +- %g", what,
                own.value, own.error);
}

static void meets_factor(tp_fos_told own, tp_case_state state, tp_bounded other, const char *what) {
  const bool number = own.state == TP_FOS_NUMBER;
  ck_assert_msg(state == (number ? TP_CASE_NUMBER : TP_CASE_ALWAYS), "%s: %d", what, (int)state);
  if (number) meets(own.value, other, what);
}

/* The governing factor. Where a solve leaves the one by strength open, as near a limit of friction
 * alone, the filter may tell it: false. */
static bool compare_factor(const tp_case_told_at *at, const tp_case *c) {
  const tp_governing_fos *g = &c->governing_fos;
  if (c->onset.fos.state == TP_FOS_UNDECIDED) return false;
  ck_assert_int_eq(at->fos.state, g->fos.state);
  if (at->fos.state == TP_FOS_NUMBER) meets(at->fos.value, g->fos.value, "the factor");
  ck_assert_int_eq(at->fos_definition, g->factors[g->factor].definition);
  ck_assert_msg(at->fos_mechanism == g->factors[g->factor].mechanism, "%s, not %s: %s, %.9g",
                tp_mechanism_name(at->fos_mechanism),
                tp_mechanism_name(g->factors[g->factor].mechanism),
                tp_fos_definition_name(at->fos_definition), g->fos.value.value);
  ck_assert(g->complete);
  return true;
}

static bool compare(const tp_case_told *told, const tp_case_told_at *at, const tp_case *c) {
  ck_assert_int_eq(c->limit.kind, TP_LIMIT_AT_ANGLE);
  ck_assert(c->has_toppling_pivot);
  ck_assert_int_eq(told->never_topples, c->pivots[c->toppling_pivot].never);
  if (!told->never_topples) {
    meets(told->moments_deg, c->pivots[c->toppling_pivot].critical_angle_deg, "moments");
  }
  meets(told->pivot_x_m, c->pivots[c->toppling_pivot].x_m, "the pivot's x");
  meets(told->pivot_y_m, c->pivots[c->toppling_pivot].y_m, "the pivot's y");
  meets(told->limit_deg, c->limit.critical_angle_deg, "the limit");
  ck_assert_str_eq(tp_mechanism_name(told->limit), tp_mechanism_name(c->limit.mechanism));
  ck_assert_int_eq(c->onset.kind, told->never ? TP_ONSET_NEVER : TP_ONSET_AT_ANGLE);
  if (!told->never) meets(told->onset_deg, c->onset.critical_angle_deg, "the onset");
  ck_assert_str_eq(tp_mechanism_name(at->mechanism), tp_mechanism_name(c->mechanism));
  tp_bounded moments, shear;
  meets_factor(at->by_moments, tp_case_fos_moments(&moments, c), moments, "the factor by moments");
  meets_factor(at->by_shear, tp_case_fos_sliding(&shear, c), shear, "the factor of sliding");
  return compare_factor(at, c);
}

/* The filter's word on one sample, and that it is true: did it tell? */
static bool tell(const stage *s, const double *values) {
  static tp_case_told told;
  tp_near variables[VARIABLES];
  tp_case_told_at at;
  for (size_t k = 0; k < s->count; k++) variables[k] = (tp_near){values[k], 0};
  tp_case_sample sample = {.friction_deg = {values[s->count], 0}, .variables = variables};
  const tp_near tilt = {values[s->count + 1], 0};
  if (s->filter == NULL) return false;
  memcpy(sample.numbers, s->filter->loads.numbers, sizeof sample.numbers);
  for (size_t k = 0; k < s->load_count; k++) {
    sample.numbers[s->loads[k]] = (tp_near){values[s->count + 2 + k], 0};
  }
  if (!tp_case_filter_tell(&told, s->filter, &sample) ||
      !tp_case_filter_tell_at(&at, &told, tilt)) {
    return false;
  }
  tp_solution *solution = solve(s, values);
  ck_assert_msg(solution != NULL, "the filter tells of a scene that is none");
  const bool same = compare(&told, &at, solution->cases);
  tp_solution_free(solution);
  return same;
}

/* To sixteen binary digits behind the point, so that the scene's rational is the double. */
static double drawn(random_numbers *state, double mean, double spread) {
  return rint((mean + spread * (2 * draw_part(state) - 1)) * 65536) / 65536;
}

static bool tell_drawn(const stage *s, random_numbers *state, double spread) {
  double values[NUMBERS];
  for (size_t k = 0; k < s->count; k++) values[k] = drawn(state, s->means[k], spread);
  values[s->count] = drawn(state, 32, 28);
  values[s->count + 1] = s->keeps_tilt ? 10 : draw_once_in(state, 8) ? 0 : drawn(state, 25, 24);
  for (size_t k = 0; k < s->load_count; k++) { /* with its sign */
    values[s->count + 2 + k] = drawn(state, s->load_means[k], 0.5 * fabs(s->load_means[k]));
  }
  return tell(s, values);
}

/* ---- blocks ------------------------------------------------------------------------------------
 */

/* Loads that turn with the tilt: an earthquake of either sign, water along the face with its uplift
 * or without, and weights on the two edges of the top. Of a block that varies an earthquake alone.
 */
static void draw_loads(char *text, size_t size, random_numbers *state, bool all, double height) {
  const bool shakes = !all || draw_once_in(state, 2), floods = all && draw_once_in(state, 2);
  size_t used = (size_t)snprintf(text, size, "loads:\n");
  if (shakes || !floods) {
    used += (size_t)snprintf(
        text + used, size - used, "  seismic: {horizontal: %.17g, vertical: %.17g}\n",
        drawn(state, 0.02, 0.15), draw_once_in(state, 2) ? 0 : drawn(state, 0, 0.1));
  }
  if (floods) {
    used += (size_t)snprintf(text + used, size - used,
                             "  water: {height: %.17g, uplift: %s, unit_weight_kn_m3: 9.8125}\n",
                             drawn(state, height / 4, height / 4),
                             draw_once_in(state, 2) ? "true" : "false");
  }
  if (all && draw_once_in(state, 3)) {
    snprintf(text + used, size - used,
             "  surcharges: [{from: [p2, p1], to: [0.45, 2*p1 + 1], kpa: %.17g}, "
             "{from: [p3, p1], to: [0.45, 2*p1 + 1], kpa: 5}]\n",
             drawn(state, 8, 8));
  }
}

/* Loads that stay with the block: anchors, active and passive, at either side; pressures on the
 * edge from the end of the underside at `end`, and a lining; with or without an earthquake that
 * turns.
 */
static void draw_staying(char *text, size_t size, random_numbers *state, double end) {
  size_t used = (size_t)snprintf(text, size, "loads:\n");
  if (draw_once_in(state, 2)) {
    used += (size_t)snprintf(text + used, size - used,
                             "  seismic: {horizontal: %.17g, direction: down_dip}\n",
                             drawn(state, 0.02, 0.15));
  }
  if (draw_once_in(state, 3)) {
    used += (size_t)snprintf(text + used, size - used,
                             "  pressures: [{from: [1, %.17g], to: [p3, p1], kpa: [%.17g, 0]}]\n",
                             end, drawn(state, 3, 3));
  }
  if (draw_once_in(state, 3)) {
    used += (size_t)snprintf(
        text + used, size - used,
        "  support_pressures: [{from: [p2, p1], to: [0, 0], kpa: %.17g, passive: %s}]\n",
        drawn(state, 3, 3), draw_once_in(state, 2) ? "true" : "false");
  }
  snprintf(
      text + used, size - used,
      "  anchors:\n  - {at: [0.45, 2*p1 + 1], direction_deg: %.17g, force_kn: %.17g, passive: %s}\n"
      "  - {at: [p2, p1], dip_deg: %.17g, force_kn: %.17g, passive: %s}\n",
      drawn(state, 0, 180), drawn(state, 4, 3), draw_once_in(state, 2) ? "true" : "false",
      drawn(state, 10, 40), drawn(state, 6, 4), draw_once_in(state, 2) ? "true" : "false");
}

/* Water and ice of a site, which press as they do at one tilt. */
static void draw_site(char *text, size_t size, random_numbers *state, double height) {
  static const char *const faces[] = {"behind", "front", "both"};
  static const char *const uplifts[] = {"none", "triangular", "full"};
  snprintf(text, size,
           "loads:\n  water: {level: %.17g, faces: %s, uplift: %s, unit_weight_kn_m3: 9.8125, "
           "ice_kpa: %.17g, ice_thickness: 0.125}\n",
           drawn(state, height / 3, height / 4), faces[draw_below(state, 3)],
           uplifts[draw_below(state, 3)], drawn(state, 10, 10));
}

/* Cohesion, a bond, or both, with or without loads that stay. */
static void draw_strength(char *text, size_t size, random_numbers *state, bool stays, double end) {
  if (stays) draw_staying(text, size, state, end);
  const bool bonds = draw_once_in(state, 2), shears = !bonds || draw_once_in(state, 2);
  size_t used = strlen(text);
  if (used == 0) used += (size_t)snprintf(text, size, "loads:\n");
  if (shears) {
    used += (size_t)snprintf(text + used, size - used, "  cohesion_kpa: %.17g\n",
                             drawn(state, 4, 3.75));
  }
  if (bonds) snprintf(text + used, size - used, "  bond_kpa: %.17g\n", drawn(state, 4, 3.75));
}

typedef enum load_draw {
  NO_LOADS,
  LOADS_THAT_TURN,
  LOADS_THAT_STAY,
  WATER_OF_A_SITE,
  STRENGTH,
  STRENGTH_AND_LOADS
} load_draw;

/* A block on one facet, on a valley or on a peak, whose top corners and middle vary; in one of two
 * units, with loads or without. */
static void set_block(stage *s, random_numbers *state, bool varies, load_draw loaded) {
  static const char *const sides[] = {"left", "right"};
  const double middle = drawn(state, 0, 0.3), height = drawn(state, 2, 1.5);
  const double means[VARIABLES] = {middle, height, drawn(state, -0.1, 0.3), drawn(state, 1.1, 0.3)};
  const bool ends = draw_once_in(state, 2);
  const double end = ends ? 0 : middle;
  char text[TEXT], loads[TEXT / 2] = "";
  if (loaded == LOADS_THAT_TURN) draw_loads(loads, sizeof loads, state, !varies, height);
  if (loaded == LOADS_THAT_STAY) draw_staying(loads, sizeof loads, state, end);
  if (loaded == WATER_OF_A_SITE) draw_site(loads, sizeof loads, state, height);
  if (loaded >= STRENGTH) {
    draw_strength(loads, sizeof loads, state, loaded == STRENGTH_AND_LOADS && !varies, end);
  }
  snprintf(
      text, sizeof text,
      "topple: 1\nlength_unit: %s\n"
      "parameters: {p0: %.17g, p1: %.17g, p2: %.17g, p3: %.17g}\n"
      "block: {outline: [[0, 0], [0.5, p0], [1, %.17g], [p3, p1], [0.45, 2*p1 + 1], [p2, p1]],\n"
      "  unit_weight_kn_m3: 25.5, thickness: 1.5}\n"
      "base: {mated: true, between: [[0, 0], [1, %.17g]]%s}\n"
      "friction_angle_deg: 30\ntilt: {towards: %s, angle_deg: 10}\n%s",
      draw_once_in(state, 2) ? "m" : "ft", means[0], means[1], means[2], means[3], end, end,
      draw_once_in(state, 2) ? ", beyond: {left: 0.5, right: 0.25}" : "",
      sides[draw_below(state, 2)], loads);
  set_stage(s, text, varies ? VARIABLES : 0);
  memcpy(s->means, means, sizeof means);
  if (loaded != NO_LOADS) add_load_numbers(s);
  s->keeps_tilt = loaded == WATER_OF_A_SITE;
}

/* Friction and tilt of a block that stays as it is, and blocks whose vertices vary by a little,
 * each without loads and with some that vary, and the former with some that stay with it: of those
 * that stand level nearly all are told. */
START_TEST(blocks_of_six) {
  enum { SAMPLES = 40 };
  const bool varies = (_i % 2 == 1 && _i < 4) || _i == 8;
  const load_draw loaded = (load_draw)(_i < 4 ? _i / 2 : _i < 8 ? _i - 2 : STRENGTH);
  long told = 0, blocks = 0;
  for (long k = 0; k < random_scenes_or(loaded < LOADS_THAT_STAY ? 60 : 20); k++) {
    random_numbers state = random_numbers_from(random_seed() + (uint64_t)k);
    stage s;
    set_block(&s, &state, varies, loaded);
    blocks += s.filter != NULL;
    for (int j = 0; j < SAMPLES; j++) told += tell_drawn(&s, &state, 0.01);
    clear_stage(&s);
  }
  const long least = blocks * SAMPLES / (loaded != NO_LOADS ? 4 : 2);
  ck_assert_msg(blocks > 0 && told > least, "%ld told of %ld blocks", told, blocks);
}
END_TEST

/* The toothed block E of Alejano et al. on a base that ends with it, and on one that goes on:
 * facets in parallel, of which any may slide. */
START_TEST(teeth) {
  static const char *const beyond[] = {"", ", beyond: {left: 60, right: 60}"};
  char text[TEXT];
  snprintf(text, sizeof text,
           "topple: 1\nlength_unit: mm\n"
           "block: {teeth: {count: 3, width: 30, height: 120, depth: 5, left_end: %s}}\n"
           "base: {mated: true%s}\nfriction_angle_deg: 30\ntilt: {towards: left, angle_deg: 20}\n",
           _i % 2 == 0 ? "valley" : "peak", beyond[_i / 2]);
  stage s;
  set_stage(&s, text, 0);
  random_numbers state = random_numbers_from(random_seed());
  ck_assert(s.filter != NULL);
  long told = 0;
  for (int k = 0; k < 200; k++) told += tell_drawn(&s, &state, 0);
  ck_assert_msg(told >= 60, "%ld of 200 told", told);
  clear_stage(&s);
}
END_TEST

/* ---- what is left to the ladder ----------------------------------------------------------------
 */

static const char slab[] = "topple: 1\nlength_unit: m\nparameters: {p0: 1, p1: 3, p2: 0, p3: 1}\n"
                           "block: {outline: [[0, 0], [p0, p2], [p0, p1], [0, p1]]}\n"
                           "base: {mated: true}\n"
                           "friction_angle_deg: 30\ntilt: {towards: left, angle_deg: 10}\n";

/* That slab with one piece of its text another. */
static void set_slab(stage *s, const char *piece, const char *other, size_t variables) {
  char text[TEXT];
  const char *at = strstr(slab, piece);
  ck_assert_ptr_nonnull(at);
  snprintf(text, sizeof text, "%.*s%s%s", (int)(at - slab), slab, other, at + strlen(piece));
  set_stage(s, text, variables);
}

/* A slab that slides at the tilt at which it topples: no double parts the two. */
START_TEST(a_tie_is_not_told) {
  stage s;
  set_slab(&s, "[p0, p2]", "[p0, 0]", 2);
  ck_assert(s.filter != NULL);
  ck_assert(tell(&s, (double[]){1, 3, 45, 10}));
  ck_assert(!tell(&s, (double[]){2, 2, 45, 10})); /* 45 degrees both */
  ck_assert(!tell(&s, (double[]){4, 1, 30, 30})); /* the tilt that it slides at */
  clear_stage(&s);
}
END_TEST

/* A base that is level is so by its numbers: with one that may differ a hair from another the
 * contact may be another. Where it is not level at all, it is told. */
START_TEST(a_contact_that_may_change_is_not_told) {
  stage s;
  set_stage(&s, slab, 3);
  ck_assert_msg(s.filter == NULL, "level by chance");
  clear_stage(&s);
  set_slab(&s, "p2: 0", "p2: 0.1", 3);
  ck_assert(s.filter != NULL);
  ck_assert(tell(&s, (double[]){1, 3, 0.125, 30, 5}));
  ck_assert(!tell(&s, (double[]){1, 3, 0, 30, 5}));
  ck_assert(!tell(&s, (double[]){1, 3, -0.125, 30, 5}));
  ck_assert(!tell(&s, (double[]){-1, 3, 0.125, 30, 5})); /* no such block */
  clear_stage(&s);
}
END_TEST

/* Numbers that the outline does not depend on alone, or not as an affine function. */
START_TEST(other_scenes_have_no_filter) {
  static const char *const changes[][2] = {
      {"[p0, p2]", "[p0, p1*p0/9]"},
      {"mated: true", "mated: true, beyond: {left: p1, right: 0}"},
      {"angle_deg: 30", "angle_deg: 30*p0"},
      {"{mated: true}", "{profile: [[-1, 0], [p1, 0]]}"}};
  stage s;
  set_stage(&s, slab, 2);
  ck_assert(s.filter != NULL);
  clear_stage(&s);
  for (size_t k = 0; k < sizeof changes / sizeof changes[0]; k++) {
    set_slab(&s, changes[k][0], changes[k][1], 2);
    ck_assert_msg(s.filter == NULL, "%s", changes[k][1]);
    clear_stage(&s);
  }
}
END_TEST

SUITE(case_filter) {
  Suite *suite = suite_create("case_filter");
  TCase *tests = tcase_create("case_filter");
  tcase_set_timeout(tests, 0);
  tcase_add_loop_test(tests, blocks_of_six, 0, 9);
  tcase_add_loop_test(tests, teeth, 0, 4);
  tcase_add_test(tests, a_tie_is_not_told);
  tcase_add_test(tests, a_contact_that_may_change_is_not_told);
  tcase_add_test(tests, other_scenes_have_no_filter);
  suite_add_tcase(suite, tests);
  return suite;
}
