/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What it takes to set a block down on a rough profile, exactly.
 *
 * Measured: a block of 100 vertices on profiles of 10^3 to 10^6 points, from a random walk with a
 * fixed seed. `bodies`: their coordinates copied, in doubles, and boxes around the profile's edges;
 * `pose`: all of tp_settle, with the bodies: the proven pose. Then of a solve: the rest with the
 * checks of the scene before it, its contact after it, and the whole. Medians of 5, in ms. To be
 * read: seconds grow with the profile, as each of its points is turned into doubles and looked at
 * once, not with its square. `place: all` of the same block: every pose found, solved, and where
 * its basin ends. The aim of a pose is 0.2 ms in doubles and 2 ms certified of 10^3 points, and 1 s
 * of 10^6; doubles with bounds tell nearly all of it, so it has one column. */

#include "bench.h"

#include "rest/settle.h"
#include "topple.h"

#include <math.h>
#include <string.h>

enum { ROUNDS = 5, CORNERS = 100 };

static const double grain = 0x1p20; /* coordinates are multiples of 1 / grain */

typedef struct bodies {
  double *block, *profile; /* x0, y0, x1, y1, ... */
  long points;
} bodies;

static void fail(const char *what) {
  fprintf(stderr, "bench_rest: %s\n", what);
  exit(BENCH_FAILED);
}

static double drawn(unsigned long *state) {
  *state = *state * 6364136223846793005UL + 1442695040888963407UL;
  return (double)(*state >> 11) / 9007199254740992.0 - 0.5;
}

static void make(bodies *b, long points) {
  unsigned long state = 16;
  *b = (bodies){malloc(2 * CORNERS * sizeof *b->block),
                malloc(2 * (size_t)points * sizeof *b->profile), points};
  if (b->block == NULL || b->profile == NULL) fail("out of memory");
  for (long k = 0; k < CORNERS; k++) {
    const double angle = 8 * atan(1) * (double)k / CORNERS, reach = 50 + 5 * drawn(&state);
    b->block[2 * k] = round(reach * cos(angle) * grain) / grain;
    b->block[2 * k + 1] = round((200 + 0.8 * reach * sin(angle)) * grain) / grain;
  }
  double height = 0;
  for (long k = 0; k < points; k++) {
    height = 0.9 * height + 2 * drawn(&state);
    b->profile[2 * k] = round((-100 + 200 * (double)k / (double)(points - 1)) * grain) / grain;
    b->profile[2 * k + 1] = round(height * grain) / grain;
  }
}

static void append(tp_polyline *line, double x, double y) {
  fmpq_t exact_x, exact_y;
  fmpq_init(exact_x);
  fmpq_init(exact_y);
  fmpq_set_si(exact_x, lround(x * grain), (unsigned long)grain);
  fmpq_set_si(exact_y, lround(y * grain), (unsigned long)grain);
  const bool done = tp_polyline_append(line, exact_x, exact_y, (tp_mark){0, 0});
  fmpq_clear(exact_x);
  fmpq_clear(exact_y);
  if (!done) fail("out of memory");
}

typedef struct times {
  double bodies[ROUNDS], pose[ROUNDS];
  double rest[ROUNDS], contact[ROUNDS], whole[ROUNDS];
  long turns;
} times;

static void time_pose(times *t, const bodies *b) {
  tp_polyline block = {0}, base = {0};
  tp_exact_point centroid;
  for (long k = 0; k < CORNERS; k++) append(&block, b->block[2 * k], b->block[2 * k + 1]);
  for (long k = 0; k < b->points; k++) append(&base, b->profile[2 * k], b->profile[2 * k + 1]);
  append(&base, 100, -900);
  append(&base, -100, -900);
  tp_exact_point_init(&centroid);
  fmpq_set_si(&centroid.x, 1, 2);
  fmpq_set_si(&centroid.y, 200, 1);
  fmpq_t none; /* no shift */
  fmpq_init(none);
  for (int k = 0; k < ROUNDS; k++) {
    tp_bodies alone;
    tp_settling settling;
    double began = bench_computed();
    if (tp_bodies_init(&alone, &block, &base, &centroid, NULL) != TP_OK) fail("no bodies");
    t->bodies[k] = bench_computed() - began;
    tp_bodies_clear(&alone);
    began = bench_computed();
    if (tp_settle(&settling, &block, &base, &centroid, none, NULL) != TP_OK) fail("no pose");
    t->pose[k] = bench_computed() - began;
    t->turns = settling.turns;
    tp_settling_clear(&settling);
  }
  fmpq_clear(none);
  tp_exact_point_clear(&centroid);
  tp_polyline_clear(&block);
  tp_polyline_clear(&base);
}

static double seconds_of(const tp_solution *solution, const char *effect) {
  double seconds = 0;
  for (size_t k = 0; k < solution->effect_count; k++) {
    if (strcmp(solution->effects[k].name, effect) == 0) seconds += solution->effects[k].seconds;
  }
  return seconds;
}

static tp_scene *make_scene(const bodies *b, bool all) {
  const tp_coordinates outline = tp_coordinates_of(b->block, CORNERS);
  const tp_coordinates profile = tp_coordinates_of(b->profile, (size_t)b->points);
  tp_message message = {.text = ""};
  tp_scene *scene = NULL;
  if (tp_scene_new(&scene, "m", &message) != TP_OK ||
      tp_scene_set_outline(scene, outline, &message) != TP_OK ||
      tp_scene_set_base_profile(scene, profile, &message) != TP_OK ||
      (all ? tp_scene_set_base_poses(scene, true, &message)
           : tp_scene_set_base_rest(scene, true, &message)) != TP_OK ||
      tp_scene_set_friction_angle_deg(scene, tp_exact_of(35), &message) != TP_OK) {
    fail(message.text);
  }
  return scene;
}

static void time_solve(times *t, const bodies *b) {
  const tp_solve_options options = tp_solve_options_default();
  tp_message message = {.text = ""};
  tp_scene *scene = make_scene(b, false);
  for (int k = 0; k < ROUNDS; k++) {
    tp_solution *solution = NULL;
    const double began = bench_computed();
    if (tp_solve(&solution, scene, &options, &message) != TP_OK) fail(message.text);
    t->whole[k] = bench_computed() - began;
    t->rest[k] = seconds_of(solution, "rest");
    t->contact[k] = seconds_of(solution, "contact");
    tp_solution_free(solution);
  }
  tp_scene_free(scene);
}

/* All poses in which the block can rest: how many, and from how many starting positions. */
static void time_poses(double *seconds, size_t *found, size_t *settlings, const bodies *b) {
  const tp_solve_options options = tp_solve_options_default();
  tp_message message = {.text = ""};
  tp_scene *scene = make_scene(b, true);
  for (int k = 0; k < ROUNDS; k++) {
    tp_solution *solution = NULL;
    const double began = bench_computed();
    if (tp_solve(&solution, scene, &options, &message) != TP_OK) fail(message.text);
    seconds[k] = bench_computed() - began;
    *found = solution->poses.pose_count;
    *settlings = solution->poses.settlings;
    tp_solution_free(solution);
  }
  tp_scene_free(scene);
}

static double ms(double *seconds) {
  return 1e3 * gsl_stats_median(seconds, 1, ROUNDS);
}

int main(void) {
  printf("%7s %10s %10s %6s %10s %10s %10s\n", "points", "bodies ms", "pose ms", "turns", "rest ms",
         "contact ms", "solve ms");
  for (long points = 1000; points <= 1000000; points *= 10) {
    bodies b;
    times t = {0};
    make(&b, points);
    time_pose(&t, &b);
    time_solve(&t, &b);
    printf("%7ld %10.3f %10.3f %6ld %10.3f %10.3f %10.2f\n", points, ms(t.bodies), ms(t.pose),
           t.turns, ms(t.rest), ms(t.contact), ms(t.whole));
    free(b.block);
    free(b.profile);
  }
  printf("\n%7s %6s %10s %13s %13s\n", "points", "poses", "settlings", "place: all ms",
         "a settling ms");
  for (long points = 10; points <= 100; points *= 10) {
    bodies b;
    double seconds[ROUNDS];
    size_t found = 0, settlings = 0;
    make(&b, points);
    time_poses(seconds, &found, &settlings, &b);
    printf("%7ld %6zu %10zu %13.1f %13.3f\n", points, found, settlings, ms(seconds),
           ms(seconds) / (double)settlings);
    free(b.block);
    free(b.profile);
  }
  return 0;
}
