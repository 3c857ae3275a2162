/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What loads cost a solve, in microseconds of computing time, medians of ROUNDS: a block on a
 * valley under its weight alone, with loads that turn with the tilt, with an anchor, with cohesion,
 * with a bond. To be read: the ratio to the weight alone beside its goal, at most twice for loads,
 * three times for a bond. */

#include "bench_solve.h"

#include <string.h>

enum { ROUNDS = 9, TEXT = 1000 };

typedef struct variant {
  const char *name, *loads;
  double goal;
} variant;

static const variant variants[] = {
    {"weight alone", "", 1},
    {"earthquake, water, uplift",
     "loads: {seismic: {horizontal: 0.04}, water: {height: 0.8, uplift: true}}\n", 2},
    {"an anchor", "loads: {anchors: [{at: [2.6, 2], direction_deg: -20, force_kn: 100}]}\n", 2},
    {"cohesion", "loads: {cohesion_kpa: 20}\n", 2},
    {"a bond", "loads: {bond_kpa: 20}\n", 3},
};

static double measure(const char *loads) {
  tp_scene *scene = NULL;
  char text[TEXT];
  snprintf(text, sizeof text,
           "topple: 1\nlength_unit: m\nblock:\n"
           "  outline: [[0, 0], [1.42, -0.03], [2.6, 0], [2.6, 3.1], [1.2, 5], [-0.1, 2.4]]\n"
           "  unit_weight_kn_m3: 26\n"
           "base: {mated: true, between: [[0, 0], [2.6, 0]], beyond: {left: 1, right: 1}}\n"
           "%sfriction_angle_deg: 36\ntilt: {towards: left, angle_deg: 18}\n",
           loads);
  expect(tp_scene_read_text(&scene, text, "scene.yaml", &message));
  return bench_solve(scene, ROUNDS);
}

int main(void) {
  double alone = 0;
  for (size_t k = 0; k < sizeof variants / sizeof variants[0]; k++) {
    const double own = measure(variants[k].loads);
    if (k == 0) alone = own;
    printf("%-28s %8.1f us, %5.2f times the weight alone (goal %.0f)\n", variants[k].name, own,
           own / alone, variants[k].goal);
  }
  return 0;
}
