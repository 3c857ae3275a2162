/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* One scene, solved for one friction angle phi after another: block E of Alejano et al. towards its
 * peak. It has to climb the flanks of its teeth to slide, and turns about its peak to topple; what
 * comes first as the table is tilted is found from contact forces, and must be the lesser of
 *
 *     sliding    alpha = phi + i,  tan i = c / a                               Eqs. (6), (7)
 *     toppling   tan alpha = (27 a b + 14 a c) / (9 b^2 - 3 c^2)               (A1.4)
 */

#include <math.h>
#include <stdio.h>
#include <topple.h>

static const double radian = 57.295779513082320877; /* in degrees */
static const double a = 30, b = 120, c = 5;

static bool show(const tp_case *one, double friction) {
  const double slides = friction + atan(c / a) * radian;
  const double topples = atan((27 * a * b + 14 * a * c) / (9 * b * b - 3 * c * c)) * radian;
  const double formula = fmin(slides, topples), difference = one->first_angle_deg.value - formula;
  const double bound = one->first_angle_deg.error + 1e-14 * formula; /* and of the formula */
  printf("%4.0f   %-8s  %.8f   %.8f   %.1e\n", friction, tp_mechanism_name(one->first),
         one->first_angle_deg.value, formula, bound);
  return one->has_first_angle && fabs(difference) <= bound &&
         one->first == (slides < topples ? TP_SLIDES : TP_TOPPLES);
}

int main(void) {
  tp_scene *scene = NULL;
  tp_message message;
  const tp_solve_options options = tp_solve_options_default();
  tp_status status = tp_scene_new(&scene, "mm", &message);
  if (status == TP_OK) {
    status = tp_scene_set_teeth(scene, 3, tp_exact_of(a), tp_exact_of(b), tp_exact_of(c),
                                TP_LEFT_END_PEAK, &message);
  }
  if (status == TP_OK) status = tp_scene_set_tilt_towards(scene, true, false, &message);
  bool all = true;
  puts(" phi   first     at degrees    formula       bound");
  for (double friction = 0; friction <= 60 && status == TP_OK; friction += 4) {
    tp_solution *solution = NULL;
    status = tp_scene_set_friction_angle_deg(scene, tp_exact_of(friction), &message);
    if (status == TP_OK) status = tp_solve(&solution, scene, &options, &message);
    if (status == TP_OK) all = show(&solution->cases[0], friction) && all;
    tp_solution_free(solution);
  }
  tp_scene_free(scene);
  if (status != TP_OK) fprintf(stderr, "%s\n", message.text);
  if (status == TP_OK) puts(all ? "The formulas agree." : "The formulas do NOT agree.");
  return status == TP_OK ? !all : tp_status_exit(status);
}
