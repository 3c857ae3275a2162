/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The profile of a scene's base: as it is given, or of a mated base the piece of the block's
 * underside that touches it. For Eq. (10) the block is solved: its weight over the contact's area
 * on the mean plane, times the cosine of the tilt, is the normal stress. */

#include "base/profile.h"
#include "base/underside.h"
#include "common/host.h"
#include "common/options.h"
#include "number/ball.h"
#include "roughness/jrc.h"
#include "roughness/profile.h"
#include "scene/rule_jrc.h"
#include "stability/solve.h"
#include "stability/tilts.h"

#include <stdlib.h>

/* The touching piece of a mated base. */
static tp_status find_mated(tp_polyline *chain, const tp_scene *scene, tp_message *message) {
  tp_section section;
  tp_base base;
  tp_status status = tp_section_init(&section, &scene->block, message);
  if (status != TP_OK) return status;
  status = tp_base_init(&base, scene, &section, message);
  if (status == TP_OK && base.none != NULL) {
    status = tp_underside_fail(base.none, scene, message);
  }
  bool room = true;
  chain->file = base.ring.file;
  chain->mark = base.ring.mark;
  for (long k = 0; status == TP_OK && room && k <= base.mated_count; k++) {
    const long at = base.mated_first + k;
    room = tp_polyline_append(chain, base.ring.x + at, base.ring.y + at, base.ring.marks[at]);
  }
  if (!room) status = tp_fail_memory(message, "the base");
  tp_base_clear(&base);
  tp_section_clear(&section);
  return status;
}

/* Of the block on the contact's area on the mean plane; 0 where the scene gives no unit weight. */
static tp_status find_stress(double *kpa, const tp_scene *scene, tp_message *message) {
  tp_solve_options options = tp_solve_options_default();
  options.limit = false;
  tp_scene stands = *scene; /* borrows all that it holds */
  tp_solution *solution = NULL;
  stands.base.all_poses = false;
  const tp_status status = tp_solve_numbers(&solution, &stands, &options, message);
  *kpa = 0;
  if (solution != NULL && solution->block.has_weight) {
    static const double radians = 0.017453292519943295;
    const double tilt = solution->has_tilt_angle ? solution->tilt_angle_deg.value : 0;
    *kpa = solution->contact.weight_per_nominal_area_pa.value * cos(tilt * radians) / 1e3;
  }
  tp_solution_free(solution);
  return status;
}

/* The files that the scene was read from. */
static const char **list_sources(const tp_scene *scene) {
  const size_t count = tp_scene_source_count(scene);
  const char **sources = calloc(count + 1, sizeof *sources);
  for (size_t k = 0; k < count && sources != NULL; k++) sources[k] = tp_scene_source(scene, k);
  return sources;
}

static tp_status measure(tp_profile **profile, const tp_scene *scene,
                         const tp_profile_options *options, tp_message *message) {
  tp_polyline mated = {0};
  const char **sources = list_sources(scene);
  if (sources == NULL) return tp_fail_memory(message, "the profile");
  const tp_profile_subject subject = {.origin = scene->base.mated ? TP_PROFILE_MATED_BASE
                                                                  : TP_PROFILE_BASE,
                                      .chain = scene->base.mated ? &mated : &scene->base.profile,
                                      .title = scene->title,
                                      .length_unit = scene->length_unit,
                                      .metres_per_unit = tp_metres_of_unit(scene->metres_per_unit),
                                      .source_count = tp_scene_source_count(scene),
                                      .sources = sources};
  tp_status status = scene->base.mated ? find_mated(&mated, scene, message) : TP_OK;
  if (status == TP_OK) status = tp_profile_measure(profile, &subject, options, message);
  tp_polyline_clear(&mated);
  free(sources);
  return status;
}

tp_status tp_profile_of_scene(tp_profile **profile, const tp_scene *scene,
                              const tp_profile_options *options, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, profile);
  TP_REFUSE_NULL(message, scene);
  TP_REFUSE_NULL(message, options);
  tp_profile_options taken = tp_profile_options_default();
  TP_TAKE_OPTIONS(message, taken, options);
  const tp_quantity *jcs = &scene->friction.jcs_mpa;
  if (taken.jcs_mpa == 0 && jcs->given) taken.jcs_mpa = fmpq_get_d(jcs->value);
  tp_profile *own = NULL;
  tp_status status = tp_profile_check_options(&taken, message);
  if (status == TP_OK && taken.jcs_mpa > 0 && taken.normal_stress_kpa == 0) {
    status = find_stress(&taken.normal_stress_kpa, scene, message);
  }
  if (status == TP_OK) status = measure(&own, scene, &taken, message);
  if (status == TP_OK) {
    status = tp_profile_rule_notes(&own->notes, &scene->base.rule, scene->metres_per_unit, message);
  }
  if (status == TP_OK) {
    *profile = own;
  } else {
    tp_profile_free(own);
  }
  return status;
}
