/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Comparisons that no number which is not one passes. */

#include "solid_tilt/results_check.h"

#include "common/message.h"
#include "number/near.h"

static bool is_share(tp_bounded share) {
  return share.value + share.error >= 0 && share.value - share.error <= 1;
}

static bool is_tilt(tp_bounded tilt) {
  return tilt.value > 0 && tilt.value - tilt.error < 90;
}

static const char *fault_of_poses(const tp_solid *solid) {
  tp_near sum = {0, 0};
  for (size_t k = 0; k < solid->pose_count; k++) {
    const tp_solid_pose *pose = solid->poses + k;
    if (!is_share(pose->facet_share) || !is_share(pose->share)) {
      return "the share of a pose is not between 0 and 1";
    }
    if (!is_tilt(pose->least.tilt_deg)) return "the tilt of a pose is not between 0 and 90 degrees";
    if (!(pose->height_m.value > 0)) return "a centroid is not above its base";
    if (pose->has_persistence && !(pose->persistence_m.value + pose->persistence_m.error >= 0)) {
      return "the persistence of a pose is below 0";
    }
    sum = tp_near_add(sum, (tp_near){pose->share.value, pose->share.error});
  }
  return fabs(sum.value - 1) <= sum.error + DBL_EPSILON ? NULL : "the sum of all shares is not 1";
}

static const char *fault_of_bands(const tp_solid *solid) {
  for (size_t k = 0; k < solid->band_count; k++) {
    const tp_solid_band *band = solid->bands + k;
    if (!band->stands) continue;
    bool are_tilts = is_tilt(band->least.tilt_deg);
    for (size_t n = 0; n < band->rose_count; n++) {
      are_tilts = are_tilts && is_tilt(band->rose[n].toppling_deg);
    }
    if (!are_tilts) return "a tilt at which it topples is not between 0 and 90 degrees";
  }
  return NULL;
}

tp_status tp_solid_results_check(const tp_solid *solid, tp_message *message) {
  const char *fault = solid->poses != NULL ? fault_of_poses(solid) : NULL;
  if (fault == NULL) fault = fault_of_bands(solid);
  if (fault == NULL) return TP_OK;
  return tp_fail(message, TP_DEPENDENCY_FAILED, (tp_place){solid->file, 0, 0},
                 "results of the solid contradict each other, and none is given: %s; please report "
                 "this together with the mesh",
                 fault);
}
