/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* By the proof of any number of blocks; where that finds nothing, of few by a program in all
 * entries, which knows other ties as well. */

#include "block_system/frictionless_blocks.h"

#include "assemblage/frictionless.h"
#include "block_system/blocks_at.h"
#include "contact_modes/exclusion.h"

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

tp_status tp_frictionless_blocks(bool *stand, const tp_resting *resting,
                                 const tp_resultant *resultant, tp_message *message) {
  *stand = false;
  if (resultant->beyond) return TP_OK;
  tp_weight_loads loads;
  const tp_near live = tp_blocks_loads(&loads, resultant);
  bool slides = false;
  const tp_status status =
      tp_frictionless_hold(stand, &slides, resting->assemblage, &loads, live, message);
  if (status != TP_OK || *stand || slides || resting->rows / 3 > FEW) return status;
  return try_few(stand, resting, resultant, message);
}
