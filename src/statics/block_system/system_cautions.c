/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Cautions of many blocks: a factor of strength alone, an earthquake to one side, one that holds.
 */

#include "block_system/system_cautions.h"

#include "common/notes.h"
#include "stability/earthquakes.h"

/* Strength alone says nothing of columns that topple. */
static tp_status note_undriven(tp_block_system *own, const tp_scene *scene, tp_message *message) {
  bool undriven = false;
  for (size_t k = 0; k < own->case_count; k++) {
    undriven = undriven || (own->cases[k].fos_driving.state == TP_FOS_NO_OVERTURNING &&
                            own->cases[k].limit != TP_SYSTEM_INTERLOCKED);
  }
  if (!undriven || !own->has_required_fos) return TP_OK;
  return tp_notes_add(&own->notes, message, TP_CAUTION, scene->required_fos.place,
                      "no load drives the blocks to a side along x: the factor is of strength "
                      "alone, and how near they are to toppling is told by the greatest tilt and "
                      "the critical acceleration; say 'slope: {dip_deg: ...}' and draw x along it "
                      "where they stand on one");
}

/* An earthquake shakes both ways, and one direction of tilt looks at one of them. */
static tp_status note_one_side(tp_block_system *own, const tp_scene *scene, tp_message *message) {
  if (!tp_earthquake_is_one_sided(scene)) return TP_OK;
  return tp_notes_add(&own->notes, message, TP_CAUTION, scene->loads.seismic_place,
                      "the earthquake is considered towards one side only, but it shakes both "
                      "ways: say 'slope: {dip_deg: …}' or 'frame: world' for blocks at their "
                      "place, 'tilt: {towards: both}', or 'direction: down_dip' where this is "
                      "meant");
}

/* It shakes for a while alone. */
static tp_status note_held(tp_block_system *own, const tp_scene *scene, tp_message *message) {
  return tp_notes_add(&own->notes, message, TP_CAUTION, scene->loads.seismic_place,
                      "the earthquake holds the blocks: without it no forces do, so they collapse "
                      "before it shakes them to this side");
}

tp_status tp_system_add_cautions(tp_block_system *system, const tp_scene *scene, bool falls_at_rest,
                                 tp_message *message) {
  tp_status status = note_undriven(system, scene, message);
  if (status == TP_OK) status = note_one_side(system, scene, message);
  return status == TP_OK && falls_at_rest ? note_held(system, scene, message) : status;
}
