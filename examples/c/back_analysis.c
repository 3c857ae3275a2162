/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Which rounding of its toe explains the tilt alpha at which a block went over in the laboratory?
 * For their blocks A, B and E towards the peak Alejano et al. answer it by a formula: with tan i =
 * c/a the axis of toppling lies r up-dip of the sharp corner, and r belongs to a radius r_c,
 *
 *     r = (27 a b + 14 a c - (9 b^2 - 3 c^2) tan alpha)
 *           / ((18 b + 9 c) (cos i + sin i tan alpha))                         (A2.4)
 *     r_c = r tan(45 deg + i / 2)                                              (A2.5)
 *
 * tp_find knows no formula: it varies the radius in the scene until the block topples at alpha, and
 * proves that it does, within the bound. */

#include <math.h>
#include <stdio.h>
#include <topple.h>

typedef struct test {
  char block;
  double a, b, c, angle_deg, table_4;
} test;

static double radius_of(double a, double b, double c, double angle_deg) {
  const double i = atan(c / a), quarter = atan(1), tangent = tan(angle_deg / 45 * quarter);
  const double r = (27 * a * b + 14 * a * c - (9 * b * b - 3 * c * c) * tangent) /
                   ((18 * b + 9 * c) * (cos(i) + sin(i) * tangent));
  return r * tan(quarter + i / 2);
}

static bool agrees(const test *t, tp_bounded radius) {
  const double formula = radius_of(t->a, t->b, t->c, t->angle_deg);
  const double bound = radius.error + 1e-12; /* mm, and of doubles in the formula */
  printf("%c      %4.1f deg    %.8f   %.8f   %.1e  %.2f\n", t->block, t->angle_deg, radius.value,
         formula, bound, t->table_4);
  return fabs(radius.value - formula) <= bound;
}

static tp_status make(tp_scene **scene, double a, double b, double c, tp_message *message) {
  tp_status status = tp_scene_new(scene, "mm", message);
  if (status == TP_OK) {
    status = tp_scene_set_teeth(*scene, 3, tp_exact_of(a), tp_exact_of(b), tp_exact_of(c),
                                TP_LEFT_END_PEAK, message);
  }
  if (status == TP_OK) {
    status = tp_scene_add_rounded_end(*scene, TP_UNDERSIDE_LEFT_END, tp_exact_of(1), message);
  }
  if (status == TP_OK) status = tp_scene_set_rounding_keeps_mass(*scene, true, message);
  if (status == TP_OK) status = tp_scene_set_tilt_towards(*scene, true, false, message);
  return status;
}

int main(void) {
  static const test tests[] = {
      {'A', 15, 94, 5, 23.5, 3.36}, {'B', 14, 135, 5, 15, 4.49}, {'E', 30, 120, 5, 37.4, 0.13}};
  tp_find_options options = tp_find_options_default();
  options.key = "block.rounded.corners.1.radius";
  options.target = TP_FIND_CRITICAL_ANGLE;
  tp_message message;
  tp_status status = TP_OK;
  bool all = true;
  puts("block  went over   r_c found    formula      bound    Table 4, mm");
  for (const test *t = tests; t < tests + 3 && status == TP_OK; t++) {
    tp_scene *scene = NULL;
    tp_found *found = NULL;
    options.value = t->angle_deg;
    status = make(&scene, t->a, t->b, t->c, &message);
    if (status == TP_OK) status = tp_find(&found, scene, &options, &message);
    all = status == TP_OK && found->count == 1 && agrees(t, found->solutions[0]) && all;
    tp_found_free(found);
    tp_scene_free(scene);
  }
  if (status != TP_OK) fprintf(stderr, "%s\n", message.text);
  if (status == TP_OK) puts(all ? "The formulas agree." : "The formulas do NOT agree.");
  return status == TP_OK ? !all : tp_status_exit(status);
}
