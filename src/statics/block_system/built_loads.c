/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Loads of a scene of many blocks, seen from both sides; what they need, and what was taken where
 * the scene leaves something open. */

#include "block_system/built_system.h"
#include "block_system/resultant.h"
#include "common/notes.h"

/* Forces are held against weights in kN. */
static tp_status check_weighed(const tp_built_system *s, tp_message *message) {
  const tp_scene *scene = s->scene;
  const bool loaded = tp_block_loads_are_called_for(scene);
  const bool asks = scene->many.support.place.file != NULL;
  for (long k = 0; k < s->count && (s->is_measured || asks); k++) {
    const tp_listed_block *own = scene->many.blocks + k;
    if (own->fixed || tp_listed_block_unit_weight(scene, own)->given) continue;
    return tp_refuse(message, TP_FAULT_KEY, own->place,
                     "%s weighed against the blocks: give 'block: {unit_weight_kn_m3: 25}' or that "
                     "of each",
                     s->has_cohesion ? "cohesion is"
                     : loaded        ? "loads are"
                                     : "a support is");
  }
  return TP_OK;
}

static bool is_wet(const tp_block_loads *loads) {
  for (long k = 0; k < loads->count; k++) {
    if (tp_block_load_is_water(loads->items + k)) return true;
  }
  return false;
}

static tp_status note_faces(tp_built_system *s, tp_message *message) {
  const tp_water_description *water = &s->scene->loads.water;
  if (water->faces != TP_WATER_FACES_UNSTATED) return TP_OK;
  if (!s->loads[0].omits && !s->loads[1].omits) return TP_OK;
  return tp_notes_add(&s->notes, message, TP_CAUTION, water->place,
                      "whether water stands before faces from where it would hold blocks is not "
                      "said: it is left out there, which is cautious; say 'faces: both' where it "
                      "does, and 'faces: behind' where not");
}

static tp_status note_water(tp_built_system *s, tp_message *message) {
  const tp_water_description *water = &s->scene->loads.water;
  if (!water->given) return TP_OK;
  if (!is_wet(s->loads) && !is_wet(s->loads + 1)) {
    return tp_notes_add(&s->notes, message, TP_CAUTION, water->place,
                        "the water lies below all joints and faces of the blocks that it may press "
                        "on: it acts nowhere");
  }
  const tp_status status = note_faces(s, message);
  if (status != TP_OK || water->shape != TP_WATER_UPLIFT_UNSTATED) return status;
  return tp_notes_add(&s->notes, message, TP_CAUTION, water->place,
                      "whether water fills the joints is not said: it does, in all below it and "
                      "with the pressure of its depth, which is cautious; say 'uplift: full' where "
                      "that is so, and 'uplift: none' where joints are drained");
}

tp_status tp_built_system_set_loads(tp_built_system *s, tp_message *message) {
  const tp_placed_blocks blocks = {
      .scene = s->scene, .assemblage = &s->assemblage, .sections = s->sections};
  s->is_measured = s->has_cohesion || tp_block_loads_are_called_for(s->scene);
  tp_status status = check_weighed(s, message);
  for (int left = 0; left < 2 && status == TP_OK; left++) {
    if (!tp_scene_needs_side(s->scene, left == 1)) continue;
    status = tp_block_loads_init(s->loads + left, &blocks, left == 1, message);
  }
  return status == TP_OK ? note_water(s, message) : status;
}
