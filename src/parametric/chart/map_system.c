/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Samples of a scene of many blocks: what they do as they lie, by limit analysis, in the direction
 * that governs. Those that forces can hold are one region: whether a motion begins all the same is
 * not looked for at so many points. */

#include "block_system/governing_case.h"
#include "block_system/system.h"
#include "chart/map.h"

#include <math.h>

static tp_regime regime_of_collapse(const tp_system_case *own) {
  switch (tp_system_case_mechanism(own)) {
  case TP_SLIDES:
    return TP_REGIME_SLIDES;
  case TP_TOPPLES:
    return TP_REGIME_TOPPLES;
  default: /* both, or not known how */
    return TP_REGIME_BOTH;
  }
}

/* The factor is its upper bound, of limit analysis. */
static void take_governing(tp_map_sample *sample, const tp_block_system *system) {
  const tp_system_case *own = tp_system_governing(system);
  const tp_system_verdict verdict = tp_system_case_worst_verdict(own);
  sample->regime = verdict == TP_SYSTEM_COLLAPSES   ? regime_of_collapse(own)
                   : verdict == TP_SYSTEM_UNDECIDED ? TP_REGIME_UNDECIDED
                                                    : TP_REGIME_CAN_HOLD;
  sample->has_limit = own->limit == TP_SYSTEM_LIMIT_NUMBER;
  sample->limit_deg = own->critical_angle_deg;
  sample->limit_deg.digits = NULL;
  sample->has_fos = isfinite(system->governing_fos.at_most) && system->governing_fos.at_most > 0;
  sample->fos = (tp_bounded){.value = system->governing_fos.at_most};
}

tp_map_sample tp_map_take_system(tp_map *map, const double *values) {
  tp_map_sample sample = {.regime = TP_REGIME_NONE};
  tp_scene *scene = NULL;
  tp_block_system *system = NULL;
  for (size_t k = 0; k < map->varied.count; k++) sample.values[k] = values[k];
  tp_status status = tp_varied_scene(&scene, &map->varied, values, &map->why);
  if (status == TP_OK) {
    status =
        tp_block_system_solve(&system, scene, &map->varied.options, TP_MOTIONS_NONE, &map->why);
  }
  if (status == TP_OK) {
    const tp_system_case *own = tp_system_governing(system);
    take_governing(&sample, system);
    map->tilts_differ |= map->has_tilt && own->tilt_angle_deg.value != map->tilt_deg;
    map->has_tilt = true;
    map->tilt_deg = own->tilt_angle_deg.value;
  }
  if (status == TP_OUT_OF_MEMORY || status == TP_SYSTEM_FAILED || status == TP_DEPENDENCY_FAILED) {
    map->status = status;
    *map->message = map->why;
  }
  tp_block_system_free(system);
  tp_scene_free(scene);
  return sample;
}
