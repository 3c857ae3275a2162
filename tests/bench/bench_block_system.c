/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Many blocks: what walls of 105 and 1040 bricks cost (with an argument, of 10050 too; with two, of
 * 100200), beside the goals of 0.1, 3 and 60 s, in processor time, and the most memory so far; and
 * ten slopes of columns: the tan(phi) of all joints that forces need (proven), that Goodman and
 * Bray ask for, and at which Box2D lets them fall, halved to 1e-3. */

#include "bench_solve.h"
#include "box2d.h"

#include <math.h>
#include <string.h>
#include <sys/resource.h>

enum { TEXT = 8 << 20, MOST_COLUMNS = 40 };

static tp_block_system *solve(const char *text, double *seconds) {
  tp_scene *scene = NULL;
  tp_block_system *system = NULL;
  const tp_solve_options options = tp_solve_options_default();
  expect(tp_scene_read_text(&scene, text, "blocks", &message));
  const double began = bench_computed();
  expect(tp_solve_block_system(&system, scene, &options, &message));
  *seconds = bench_computed() - began;
  tp_scene_free(scene);
  return system;
}

/* ---- walls -------------------------------------------------------------------------------------
 */

/* Bricks 4 by 2, half bricks at the ends of each other course (after Ferris and Tin-Loi 2001). */
static void write_wall(char *text, int courses) {
  char *at = text;
  at +=
      sprintf(at,
              "topple: 1\nlength_unit: m\nfriction_angle_deg: 33\nblock: {unit_weight_kn_m3: 25}\n"
              "tilt: {towards: left, angle_deg: 15}\nblocks:\n"
              "  - {name: ground, ground: true, slab: {width: %d, height: 4}, at: [-4, -4]}\n",
              4 * courses + 8);
  for (int c = 0; c < courses; c++) {
    const int half = c % 2 == 0 ? 2 : 0;
    for (int left = -half; left < 4 * courses; left += 4) {
      const int from = left < 0 ? 0 : left;
      const int to = left + 4 > 4 * courses ? 4 * courses : left + 4;
      at +=
          sprintf(at, "  - {slab: {width: %d, height: 2}, at: [%d, %d]}\n", to - from, from, 2 * c);
    }
  }
}

static double most_mebibytes(void) {
  struct rusage used;
  return getrusage(RUSAGE_SELF, &used) == 0 ? (double)used.ru_maxrss / 1024 : NAN;
}

/* `goal` in seconds. */
static void bench_wall(int courses, double goal) {
  char *text = malloc(TEXT);
  if (text == NULL) exit(BENCH_FAILED);
  write_wall(text, courses);
  double seconds = 0;
  tp_block_system *system = solve(text, &seconds);
  const tp_system_case *own = system->cases;
  printf("%6zu  %7.3f  %6.1f  %6.0f  %10.6f  %8.1e\n", system->block_count - 1, seconds, goal,
         most_mebibytes(), own->fos.value.value, own->fos.value.error);
  tp_block_system_free(system);
  free(text);
}

/* ---- slopes ------------------------------------------------------------------------------------
 */

static const double degree = 3.141592653589793 / 180;

typedef struct slope {
  double dip, width, step, rise, fall;
  int below, above;
} slope;

/* The first is that of Goodman and Bray (1976). */
static const slope slopes[] = {{30, 10, 1, 5, 5, 9, 6},  {30, 4, 1, 2, 2, 9, 6},
                               {25, 10, 1, 5, 5, 9, 6},  {35, 10, 1, 5, 5, 9, 6},
                               {30, 10, 2, 5, 4, 7, 5},  {30, 10, 0.5, 4, 4, 9, 6},
                               {20, 5, 0.5, 4, 3, 9, 8}, {30, 20, 2, 5, 5, 9, 6},
                               {40, 6, 1, 4, 5, 8, 5},   {15, 3, 0.25, 3, 2, 9, 12}};

static int set_heights(double *heights, const slope *s) {
  int count = 0;
  for (int k = 1; k <= s->below + 1; k++) heights[count++] = k * (s->rise - s->step);
  for (int k = 0; k < s->above; k++, count++) {
    heights[count] = heights[count - 1] - s->fall - s->step;
    if (heights[count] <= 0) break;
  }
  return count;
}

#ifdef HAVE_BOX2D
static double by_box2d(const slope *s, double *seconds) {
  static const double width = 1e-3;
  double heights[MOST_COLUMNS];
  const box2d_columns columns = {s->width, s->step, heights, set_heights(heights, s),
                                 s->dip * degree};
  double low = 0, high = 4;
  const double began = bench_computed();
  while (high - low > width) {
    const double middle = (low + high) / 2;
    *(box2d_columns_stand(&columns, middle) ? &high : &low) = middle;
  }
  *seconds = bench_computed() - began;
  return (low + high) / 2;
}
#else
static double by_box2d(const slope *s, double *seconds) {
  (void)s;
  *seconds = NAN;
  return NAN;
}
#endif

static void bench_slope(const slope *s) {
  char text[1000];
  double heights[MOST_COLUMNS];
  const int count = set_heights(heights, s);
  int at = snprintf(text, sizeof text,
                    "topple: 1\nlength_unit: m\nslope: {dip_deg: %g, towards: left}\n"
                    "friction_angle_deg: 40\nblock: {unit_weight_kn_m3: 25}\n"
                    "columns: {width: %g, step: %g, heights: [",
                    s->dip, s->width, s->step);
  for (int k = 0; k < count; k++) {
    at += snprintf(text + at, sizeof text - (size_t)at, "%s%g", k > 0 ? ", " : "", heights[k]);
  }
  snprintf(text + at, sizeof text - (size_t)at, "]}\n");
  const double needed = tan(40 * degree);
  double seconds = 0, engine_seconds = 0;
  tp_block_system *system = solve(text, &seconds);
  const tp_system_case *own = system->cases;
  const double engine = by_box2d(s, &engine_seconds);
  printf("%4g %6g %5g %5g %5g %7d  %9.6f  %9.6f  %8.4f  %7.4f  %7.2f\n", s->dip, s->width, s->step,
         s->rise, s->fall, count, needed / own->fos.value.value, needed / own->goodman_bray.fos,
         engine, seconds, engine_seconds);
  tp_block_system_free(system);
}

int main(int argc, char **argv) {
  (void)argv;
  printf("Walls: both limits and both factors of safety\nblocks  seconds  goal s     MiB      "
         "factor     error\n");
  bench_wall(10, 0.1);
  bench_wall(32, 3);
  if (argc > 1) bench_wall(100, 60);
  if (argc > 2) bench_wall(316, INFINITY); /* as memory says */
  printf("\nSlopes of columns: tan(phi) that holds them\n"
         " dip  width  step  rise  fall columns  forces     Goodman    Box2D     s        s Box2D\n"
         "                                       can hold   and Bray\n");
  for (size_t k = 0; k < sizeof slopes / sizeof slopes[0]; k++) bench_slope(slopes + k);
  return EXIT_SUCCESS;
}
