/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* By the proof of any number of blocks; where that finds nothing, of few by a program in all
 * entries, which knows other ties as well, and in rationals. */

#include "block_system/frictionless_blocks.h"

#include "assemblage/exact_bracket.h"
#include "assemblage/frictionless.h"
#include "block_system/blocks_at.h"
#include "block_system/state_limits.h"
#include "contact_modes/exclusion.h"

#include <math.h>
#include <stdlib.h>

enum { FEW = 100 }; /* free ones */

static tp_status try_few(bool *stand, const tp_resting *resting, const tp_resultant *resultant,
                         tp_message *message) {
  tp_blocks_at at;
  long work = 0;
  tp_status status = tp_fail_memory(message, "the motions");
  if (tp_blocks_at_init(&at, resting)) {
    status = tp_blocks_at_rest(&at, resting, resultant, message);
  }
  if (status == TP_OK) {
    const tp_modes_question q = {.resting = resting, .loads = {at.loads}, .load_count = 1};
    status = tp_exclusion_frictionless(stand, &work, &q, message);
  }
  tp_blocks_at_clear(&at);
  return status;
}

/* The limit without any strength. */
static tp_status find_limit(tp_load_bracket *b, const tp_assemblage *a,
                            const tp_contact_strength *none, const tp_weight_loads *loads,
                            tp_message *message) {
  static const tp_bracket_aim limit_itself = {.share = TP_LIMIT_SHARE, .enough = INFINITY};
  tp_force_program program;
  tp_status status = tp_force_program_init(&program, a, none, loads, message);
  if (status != TP_OK) return status;
  status = tp_load_bracket_find(b, &program, &limit_itself, message);
  if (status == TP_OK) status = tp_exact_bracket_narrow(b, &program, none, loads, message);
  tp_force_program_clear(&program);
  return status;
}

static tp_status try_exactly(bool *stand, const tp_assemblage *a, const tp_weight_loads *loads,
                             tp_near live, tp_message *message) {
  const tp_system_state to_side = {*loads, 1}, to_other = tp_state_reversed(&to_side);
  tp_limits limits = {.side = {.forces = NULL}};
  tp_contact_strength *none = calloc((size_t)a->contact_count + 1, sizeof *none);
  tp_status status = none != NULL ? TP_OK : tp_fail_memory(message, "a proof");
  if (status == TP_OK) status = find_limit(&limits.side, a, none, &to_side.loads, message);
  if (status == TP_OK) status = find_limit(&limits.other, a, none, &to_other.loads, message);
  *stand = status == TP_OK && tp_limits_hold(&limits, live);
  tp_limits_clear(&limits);
  free(none);
  return status;
}

tp_status tp_frictionless_blocks(bool *stand, const tp_resting *resting,
                                 const tp_resultant *resultant, tp_message *message) {
  *stand = false;
  if (resultant->beyond) return TP_OK;
  const tp_weight_loads *loads = &resultant->loads;
  const tp_near live = resultant->target;
  bool slides = false;
  const long count = resting->rows / 3;
  tp_status status =
      tp_frictionless_hold(stand, &slides, resting->assemblage, loads, live, message);
  if (status != TP_OK || *stand || slides || count > FEW) return status;
  status = try_few(stand, resting, resultant, message);
  if (status != TP_OK || *stand || !tp_exact_bracket_is_quick(resting->assemblage)) return status;
  return try_exactly(stand, resting->assemblage, loads, live, message);
}
