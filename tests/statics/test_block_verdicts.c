/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The verdicts of many blocks are what tp_solve tells of each alone, by any number of threads: the
 * same words, and numbers whose bounds meet. Most are told by doubles, a solve by none. */

#include "drawn_blocks.h"
#include "random_runs.h"
#include "suite.h"

#include "evaluation/case_numbers.h"

#include <math.h>
#include <string.h>

static tp_message message;

enum { SOLVED = 900, FEW_EDGES = 8, MOST_EDGES = 80, STONE = MOST_EDGES + 4 };

typedef struct verdicts {
  tp_mechanism mechanism[SOLVED], first[SOLVED];
  double angle[SOLVED], critical[SOLVED], limit[SOLVED], onset[SOLVED], fos[SOLVED];
  double angle_error[SOLVED], critical_error[SOLVED], limit_error[SOLVED], onset_error[SOLVED];
  double fos_error[SOLVED], moments[SOLVED], moments_error[SOLVED];
  double sliding[SOLVED], sliding_error[SOLVED];
  tp_mechanism fos_mechanism[SOLVED];
  tp_fos_definition fos_definition[SOLVED];
  tp_limit_kind limit_kind[SOLVED];
  tp_onset_kind onset_kind[SOLVED];
  tp_status status[SOLVED];
  tp_blocks_summary summary;
} verdicts;

static double friction[SOLVED], tilt[SOLVED];

static void solve(verdicts *v, const tp_outlines *outlines, size_t threads) {
  tp_blocks_options options = tp_blocks_options_default();
  options.threads = threads;
  options.towards = TP_TOWARDS_RIGHT;
  memset(v, 0, sizeof *v);
  const tp_verdict_columns columns = {.mechanism = v->mechanism,
                                      .first = v->first,
                                      .first_angle_deg = v->angle,
                                      .first_error_deg = v->angle_error,
                                      .critical_angle_deg = v->critical,
                                      .critical_error_deg = v->critical_error,
                                      .limit_kind = v->limit_kind,
                                      .limit_angle_deg = v->limit,
                                      .limit_error_deg = v->limit_error,
                                      .onset_kind = v->onset_kind,
                                      .onset_angle_deg = v->onset,
                                      .onset_error_deg = v->onset_error,
                                      .fos = v->fos,
                                      .fos_error = v->fos_error,
                                      .fos_mechanism = v->fos_mechanism,
                                      .fos_definition = v->fos_definition,
                                      .fos_moments = v->moments,
                                      .fos_moments_error = v->moments_error,
                                      .fos_sliding = v->sliding,
                                      .fos_sliding_error = v->sliding_error,
                                      .status = v->status};
  ck_assert_int_eq(tp_blocks_solve(&columns, &v->summary, outlines, tp_numbers_each(friction),
                                   tp_numbers_each(tilt), &options, &message),
                   TP_OK);
}

static void claim_same(double own, double error, bool given, tp_bounded number) {
  ck_assert_int_eq(isnan(own), !given);
  if (!given) return;
  ck_assert_double_le(fabs(own - number.value), error + number.error);
  ck_assert_double_le(error, 1e-8 * fabs(own));
}

/* The factors at the tilt. */
static void claim_factors(const verdicts *v, size_t k, const tp_case *one) {
  const tp_governing_fos *g = &one->governing_fos;
  const tp_factor *factor = tp_case_factor(one);
  tp_bounded number = {0};
  claim_same(v->fos[k], v->fos_error[k], g->fos.state == TP_FOS_NUMBER, g->fos.value);
  bool given = tp_case_fos_moments(&number, one) == TP_CASE_NUMBER;
  claim_same(v->moments[k], v->moments_error[k], given, number);
  given = tp_case_fos_sliding(&number, one) == TP_CASE_NUMBER;
  claim_same(v->sliding[k], v->sliding_error[k], given, number);
  ck_assert_int_eq(v->fos_mechanism[k],
                   factor != NULL ? factor->mechanism : TP_MECHANISM_UNDECIDED);
  ck_assert_int_eq(v->fos_definition[k], factor != NULL ? factor->definition : TP_FOS_BY_MOMENTS);
}

/* As tp_solve tells of each alone. */
static void claim_verdict(const verdicts *v, size_t k) {
  tp_scene *scene = NULL;
  tp_solution *solution = NULL;
  const tp_coordinates own =
      tp_coordinates_of(all_xy + 2 * first_of[k], first_of[k + 1] - first_of[k]);
  tp_status status = tp_scene_new(&scene, "km", &message);
  if (status == TP_OK) status = tp_scene_set_outline(scene, own, &message);
  if (status == TP_OK) status = tp_scene_set_tilt_towards(scene, false, true, &message);
  if (status == TP_OK && !isnan(friction[k])) {
    status = tp_scene_set_friction_angle_deg(scene, tp_exact_of(friction[k]), &message);
  }
  if (status == TP_OK && !isnan(tilt[k])) {
    status = tp_scene_set_tilt_angle_deg(scene, tp_exact_of(tilt[k]), &message);
  }
  const tp_solve_options options = tp_solve_options_default();
  if (status == TP_OK) status = tp_solve(&solution, scene, &options, &message);
  tp_scene_free(scene);
  if (status == TP_OK && tp_solution_is_undecided(solution)) status = TP_UNDECIDED;
  ck_assert_int_eq(status, v->status[k]);
  if (status == TP_BAD_INPUT) ck_assert_int_eq(v->mechanism[k], TP_MECHANISM_UNDECIDED);
  if (solution == NULL) return;
  const tp_case *one = solution->cases;
  ck_assert_int_eq(v->mechanism[k], one->mechanism);
  ck_assert_int_eq(v->first[k], one->first);
  ck_assert_int_eq(v->limit_kind[k], one->limit.kind);
  ck_assert_int_eq(v->onset_kind[k], one->onset.kind);
  claim_same(v->angle[k], v->angle_error[k], one->has_first_angle, one->first_angle_deg);
  claim_same(v->critical[k], v->critical_error[k], one->has_toppling_pivot,
             one->has_toppling_pivot ? one->pivots[one->toppling_pivot].critical_angle_deg
                                     : (tp_bounded){0});
  claim_same(v->limit[k], v->limit_error[k], one->limit.kind == TP_LIMIT_AT_ANGLE,
             one->limit.critical_angle_deg);
  claim_same(v->onset[k], v->onset_error[k], one->onset.kind == TP_ONSET_AT_ANGLE,
             one->onset.critical_angle_deg);
  claim_factors(v, k, one);
  tp_solution_free(solution);
}

START_TEST(verdicts_of_many) {
  static verdicts first, other;
  tp_outlines outlines = draw_blocks();
  outlines.count = SOLVED;
  for (size_t k = 0; k < SOLVED; k++) {
    friction[k] = k % 5 == 0 ? NAN : 20 + (double)(k % 30);
    tilt[k] = k % 7 == 0 ? NAN : (double)(k % 40);
  }
  friction[10] = 91; /* an angle of friction that is none */
  solve(&first, &outlines, 1);
  ck_assert_int_eq(first.status[10], TP_BAD_INPUT);
  for (size_t k = 0; k < SOLVED; k++) claim_verdict(&first, k);
  solve(&other, &outlines, 7);
  ck_assert(same_bytes(&first, &other, sizeof first));
  const size_t all = first.summary.done + first.summary.bad + first.summary.undecided;
  ck_assert_uint_eq(all, SOLVED);
}
END_TEST

/* The height of a vertex of an underside: rough all over; teeth, a direction twice; level in
 * places; rough on a bow. */
static double draw_height(long kind, size_t k, double x, size_t edges, random_numbers *state) {
  if (kind == 0) return 0.5 * draw_part(state);
  if (kind == 1) return k % 2 == 0 ? 0 : 0.25;
  if (kind == 2) return k < 2 || draw_once_in(state, 2) ? 0 : 0.125;
  const double middle = x / (double)edges - 0.5;
  return (double)edges * (0.02 * draw_part(state) + 0.1 * middle * middle);
}

/* A block on a rough, a toothed, a bowed or a level underside of few edges or many, below a leaning
 * top: either way round, begun anywhere, in one of two units. Its number of vertices. */
static size_t draw_stone(double xy[2 * STONE], random_numbers *state, bool has_many) {
  const size_t edges = has_many ? 1 + FEW_EDGES + draw_below(state, MOST_EDGES - FEW_EDGES)
                                : 1 + draw_below(state, FEW_EDGES);
  const size_t count = edges + 3, turned = draw_below(state, count);
  const long kind = draw_below(state, 4);
  const double unit = draw_once_in(state, 2) ? 1 : 0.3048, height = 0.3 + 3 * draw_part(state);
  const bool clockwise = draw_once_in(state, 2), even = kind > 0 || draw_once_in(state, 2);
  for (size_t k = 0; k < count; k++) {
    const double lean = 0.4 * (draw_part(state) - 0.3);
    double x = even ? (double)k : (double)k + 0.6 * draw_part(state);
    double y = draw_height(kind, k, x, edges, state);
    if (k == edges + 1) x = (double)edges + 0.6 + lean;
    if (k == edges + 2) x = lean;
    if (k > edges) y = height * (double)edges + lean;
    const size_t at = (turned + (clockwise ? count - k : k)) % count;
    xy[2 * at] = x * unit;
    xy[2 * at + 1] = y * unit;
  }
  return count;
}

/* Most of such blocks are told by doubles; all as tp_solve tells of each alone. */
START_TEST(verdicts_of_stones) {
  static verdicts all;
  random_numbers state = random_numbers_from(random_seed());
  first_of[0] = 0;
  for (size_t k = 0; k < SOLVED; k++) {
    first_of[k + 1] = first_of[k] + draw_stone(all_xy + 2 * first_of[k], &state, k % 6 == 0);
    friction[k] = 5 + 60 * draw_part(&state);
    tilt[k] = draw_once_in(&state, 9) ? NAN : draw_once_in(&state, 9) ? 0 : 55 * draw_part(&state);
  }
  const tp_outlines outlines = tp_outlines_ragged(all_xy, SOLVED, first_of);
  solve(&all, &outlines, 2);
  for (size_t k = 0; k < SOLVED; k++) claim_verdict(&all, k);
  ck_assert_msg(all.summary.climbed < SOLVED / 3, "%zu climbed", all.summary.climbed);
}
END_TEST

/* The same stones elsewhere: each coordinate on a grid of 2^-20 as before, so that both sums are
 * exact. */
static void move_stones(double x, double y) {
  for (size_t k = 0; k < first_of[SOLVED]; k++) {
    all_xy[2 * k] += x;
    all_xy[2 * k + 1] += y;
  }
}

/* Bounds that meet, and no word another. */
static void claim_moved(const verdicts *home, const verdicts *away, size_t k) {
  const double *const numbers[][2] = {{home->angle, home->angle_error},
                                      {home->limit, home->limit_error},
                                      {home->onset, home->onset_error},
                                      {home->fos, home->fos_error}};
  const double *const moved[][2] = {{away->angle, away->angle_error},
                                    {away->limit, away->limit_error},
                                    {away->onset, away->onset_error},
                                    {away->fos, away->fos_error}};
  ck_assert_int_eq(home->status[k], away->status[k]);
  ck_assert_int_eq(home->mechanism[k], away->mechanism[k]);
  ck_assert_int_eq(home->fos_mechanism[k], away->fos_mechanism[k]);
  for (size_t n = 0; n < sizeof numbers / sizeof numbers[0]; n++) {
    const double own = numbers[n][0][k], other = moved[n][0][k];
    ck_assert_int_eq(isnan(own), isnan(other));
    if (isnan(own)) continue;
    ck_assert_double_le(fabs(own - other), numbers[n][1][k] + moved[n][1][k]);
  }
}

/* Map coordinates (x 500 000, y 4 600 000) cost what the origin costs: 20 000 blocks of a GIS left
 * the filter, all of them, as the bound of a centroid grew with its distance from the origin. A
 * translation that is exact changes nothing else; and what tp_solve tells is the same. */
START_TEST(verdicts_at_map_coordinates) {
  static const double places[][2] = {{500000, 4600000}, {-3e6, 1}, {0, 0x1p27}};
  static verdicts home, away;
  static const double grid = 0x1p20;
  random_numbers state = random_numbers_from(random_seed());
  first_of[0] = 0;
  for (size_t k = 0; k < SOLVED; k++) {
    first_of[k + 1] = first_of[k] + draw_stone(all_xy + 2 * first_of[k], &state, k % 6 == 0);
    friction[k] = 5 + 60 * draw_part(&state);
    tilt[k] = draw_once_in(&state, 9) ? NAN : draw_once_in(&state, 9) ? 0 : 55 * draw_part(&state);
  }
  for (size_t k = 0; k < 2 * first_of[SOLVED]; k++) {
    all_xy[k] = nearbyint(all_xy[k] * grid) / grid;
  }
  const tp_outlines outlines = tp_outlines_ragged(all_xy, SOLVED, first_of);
  solve(&home, &outlines, 2);
  ck_assert_msg(home.summary.climbed < SOLVED / 3, "%zu climbed", home.summary.climbed);
  for (size_t place = 0; place < sizeof places / sizeof places[0]; place++) {
    move_stones(places[place][0], places[place][1]);
    solve(&away, &outlines, 2);
    for (size_t k = 0; k < SOLVED; k++) claim_moved(&home, &away, k);
    for (size_t k = 0; k < SOLVED; k += 9) claim_verdict(&away, k);
    const size_t more = away.summary.climbed - home.summary.climbed;
    ck_assert_msg(away.summary.climbed <= home.summary.climbed || more <= SOLVED / 100,
                  "%zu climbed, and %zu at the origin", away.summary.climbed, home.summary.climbed);
    move_stones(-places[place][0], -places[place][1]);
  }
}
END_TEST

SUITE(block_verdicts) {
  Suite *suite = suite_create("block_verdicts");
  TCase *tests = tcase_create("blocks");
  tcase_set_timeout(tests, 0);
  tcase_add_test(tests, verdicts_of_many);
  tcase_add_test(tests, verdicts_of_stones);
  tcase_add_test(tests, verdicts_at_map_coordinates);
  suite_add_tcase(suite, tests);
  return suite;
}
