/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Whether a factor of safety is met by many blocks, and whether the proofs left something open. */

#include "block_system/governing_case.h"
#include "common/host.h"
#include "topple_block_system.h"

bool tp_block_system_is_undecided(const tp_block_system *system) {
  if (system == NULL) return true;
  for (size_t k = 0; k < system->case_count; k++) {
    const tp_system_case *c = system->cases + k;
    if (c->verdict == TP_SYSTEM_UNDECIDED) return true;
    if (c->has_static && c->static_verdict == TP_SYSTEM_UNDECIDED) return true;
  }
  return false;
}

static bool falls_short(const tp_goodman_bray *own, double required) {
  return own->applies && (!own->has_fos || (own->fos < required && !own->fos_is_least));
}

/* By the rule for all forms; of columns the factor of the named method is asked for as well. */
tp_design tp_system_case_meets(const tp_system_case *own, double required) {
  TP_GUARD_HOST;
  if (own == NULL) return TP_DESIGN_OPEN;
  if (falls_short(&own->goodman_bray, required)) return TP_DESIGN_NOT_MET;
  const tp_safety safety = tp_system_case_rule(own);
  return tp_safety_meets(&safety, required);
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
