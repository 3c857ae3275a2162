/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* How much of the angle at which a block begins to move is chance? One block, set down on ten bases
 * that are equally rough: self-affine, of the same JRC, each by a seed of its own. JRC is put as
 * the Z2 that it has by the regression of Tse and Cruden (1979),
 *
 *     JRC = 32.2 + 32.47 log10 Z2,
 *
 * so that every one of the bases must have, as it is measured, this root of the mean square slope,
 * but for the decimals that its heights are rounded to: a millionth of their RMS. */

#include <math.h>
#include <stdio.h>
#include <topple.h>

static const double jrc = 8;

static tp_status build(tp_scene **scene, tp_message *message) {
  static const double outline[] = {35, 20, 65, 20, 65, 60, 35, 60};
  tp_base_self_affine_options rough = tp_base_self_affine_options_default();
  rough.length = tp_exact_of(100);
  rough.step = tp_exact_of(0.5);
  rough.hurst = tp_exact_text("0.8");
  rough.by = TP_ROUGHNESS_JRC;
  rough.roughness = tp_exact_of(jrc);
  rough.seed = 1;
  tp_status status = tp_scene_new(scene, "mm", message);
  if (status == TP_OK) {
    status = tp_scene_set_outline(*scene, tp_coordinates_of(outline, 4), message);
  }
  if (status == TP_OK) {
    status = tp_scene_set_friction_angle_deg(*scene, tp_exact_of(35), message);
  }
  if (status == TP_OK) status = tp_scene_set_base_self_affine(*scene, &rough, message);
  if (status == TP_OK) status = tp_scene_set_base_rest(*scene, true, message);
  return status == TP_OK ? tp_scene_set_tilt_towards(*scene, true, false, message) : status;
}

/* Has the base the Z2 that was asked for? */
static bool show(int seed, const tp_solution *solution, const tp_profile *profile) {
  const tp_case *one = &solution->cases[0];
  const double wanted = pow(10, (jrc - 32.2) / 32.47), bound = profile->z2.error + 1e-5 * wanted;
  printf("%3d   %7.3f     %7.3f      %-20s %.8f  %.8f  %.1e\n", seed,
         solution->rest.turned_deg.value, one->first_angle_deg.value, tp_mechanism_name(one->first),
         profile->z2.value, wanted, bound);
  return fabs(profile->z2.value - wanted) <= bound;
}

static tp_status solve_one(bool *agrees, const tp_scene *scene, int seed, tp_message *message) {
  const tp_solve_options options = tp_solve_options_default();
  const tp_profile_options sampling = tp_profile_options_default();
  tp_scene *varied = NULL;
  tp_solution *solution = NULL;
  tp_profile *profile = NULL;
  tp_status status =
      tp_scene_with(&varied, scene, "base.profile.self_affine.seed", tp_exact_of(seed), message);
  if (status == TP_OK) status = tp_solve(&solution, varied, &options, message);
  if (status == TP_OK) status = tp_profile_of_scene(&profile, varied, &sampling, message);
  if (status == TP_OK) *agrees = show(seed, solution, profile);
  tp_profile_free(profile);
  tp_solution_free(solution);
  tp_scene_free(varied);
  return status;
}

int main(void) {
  tp_scene *scene = NULL;
  tp_message message;
  tp_status status = build(&scene, &message);
  bool all = true;
  puts("seed  turned by   moves from   first                Z2          wanted      bound");
  for (int seed = 1; seed <= 10 && status == TP_OK; seed++) {
    bool agrees = false;
    status = solve_one(&agrees, scene, seed, &message);
    all = all && agrees;
  }
  tp_scene_free(scene);
  if (status != TP_OK) fprintf(stderr, "%s\n", message.text);
  if (status == TP_OK) puts(all ? "The formulas agree." : "The formulas do NOT agree.");
  return status == TP_OK ? !all : tp_status_exit(status);
}
