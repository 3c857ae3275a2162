/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Whether a factor of safety is met by many blocks, and whether the proofs left something open. */

#include "common/host.h"
#include "topple_block_system.h"

bool tp_block_system_is_undecided(const tp_block_system *system) {
  if (system == NULL) return true;
  for (size_t k = 0; k < system->case_count; k++) {
    if (system->cases[k].verdict == TP_SYSTEM_UNDECIDED) return true;
  }
  return false;
}

static bool falls_short(const tp_goodman_bray *own, double required) {
  return own->applies && (!own->has_fos || (own->fos < required && !own->fos_is_least));
}

static bool drives_too_much(const tp_system_case *own, double required) {
  const tp_fos *fos = &own->fos_driving;
  const bool is_number = fos->state == TP_FOS_NUMBER && !own->fos_driving_is_least;
  return fos->state == TP_FOS_UNDEFINED ||
         (is_number && fos->value.value + fos->value.error < required) ||
         (own->has_moving_fos_driving && own->moving_fos_driving <= required);
}

static bool stands_driven(const tp_system_case *own, double required) {
  return own->fos_driving.state == TP_FOS_NO_OVERTURNING ||
         (own->has_standing_fos_driving && own->standing_fos_driving >= required);
}

/* A factor of limit analysis is above the true one where friction does not dilate, and so is a
 * divisor at which a motion can begin: what these do not reach is certainly not met. Of columns the
 * factor of the named method is asked for as well. */
tp_design tp_system_case_meets(const tp_system_case *own, double required) {
  TP_GUARD_HOST;
  if (own == NULL) return TP_DESIGN_OPEN;
  if (own->verdict == TP_SYSTEM_COLLAPSES) return TP_DESIGN_NOT_MET;
  if (falls_short(&own->goodman_bray, required)) return TP_DESIGN_NOT_MET;
  if (drives_too_much(own, required)) return TP_DESIGN_NOT_MET;
  if (own->has_moving_fos && own->moving_fos <= required) return TP_DESIGN_NOT_MET;
  if (own->fos.state == TP_FOS_NUMBER && !own->fos_is_least &&
      own->fos.value.value + own->fos.value.error < required) {
    return TP_DESIGN_NOT_MET;
  }
  const bool stands = own->verdict == TP_SYSTEM_STANDS && own->has_standing_fos;
  return stands && own->standing_fos >= required && stands_driven(own, required) ? TP_DESIGN_MET
                                                                                 : TP_DESIGN_OPEN;
}

tp_design tp_block_system_meets(const tp_block_system *system, double required) {
  TP_GUARD_HOST;
  if (system == NULL) return TP_DESIGN_OPEN;
  tp_design worst = TP_DESIGN_MET;
  for (size_t k = 0; k < system->case_count && worst != TP_DESIGN_NOT_MET; k++) {
    const tp_design own = tp_system_case_meets(system->cases + k, required);
    if (own != TP_DESIGN_MET) worst = own;
  }
  return worst;
}
