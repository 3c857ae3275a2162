/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Faces and uplift that a scene leaves open, water below the joint and above the top, pressures
 * that stay those at the scene's tilt (docs/loads.md, water as a site has it). */

#include "stability/water_cautions.h"

#include "stability/earthquakes.h"

/* What is taken where the scene leaves it open. */
static tp_status note_open(tp_notes *notes, const tp_water_description *water,
                           tp_message *message) {
  const bool in_crack = water->cracked && !water->level.given && water->surface.count == 0;
  tp_status status = TP_OK;
  if (water->faces == TP_WATER_FACES_UNSTATED && !in_crack) {
    status = tp_notes_add(
        notes, message, TP_CAUTION, water->place,
        "the scene does not say which faces the water wets: it is put on those behind the block "
        "alone, where it pushes down-dip, and none in front, which would hold; say 'faces: "
        "behind', "
        "'front' or 'both'");
  }
  if (status != TP_OK || water->shape != TP_WATER_UPLIFT_UNSTATED) return status;
  return tp_notes_add(
      notes, message, TP_CAUTION, water->place,
      "the scene does not say how the water lifts the block: the full pressure of its level is "
      "taken "
      "at both ends of the base joint, as where the toe is blocked; say 'uplift: full', "
      "'triangular' (to nothing at a drained toe) or 'none'");
}

static tp_status note_stand(tp_notes *notes, const tp_wetted *wetted,
                            const tp_water_description *water, tp_message *message) {
  if (wetted->dry) {
    return tp_notes_add(notes, message, TP_NOTE, water->place,
                        "the water stands below the block and its base joint: it does not act");
  }
  if (!wetted->overtops) return TP_OK;
  return tp_notes_add(
      notes, message, TP_NOTE, water->place,
      "the water stands above the top of the block: it presses on the whole face, and down on "
      "the top");
}

tp_status tp_water_cautions(tp_notes *notes, const tp_problem *problem, tp_message *message) {
  const tp_scene *scene = problem->scene;
  const tp_water_description *water = &scene->loads.water;
  const bool way[2] = {scene->towards_left, scene->towards_right};
  tp_status status = note_open(notes, water, message);
  for (int k = 0; k < 2 && status == TP_OK; k++) {
    if (way[k]) status = note_stand(notes, problem->wetted + k, water, message);
  }
  if (status == TP_OK && water->lifts_alone && water->faces != TP_WATER_IN_FRONT) {
    status = tp_earthquake_note_water(notes, water, message);
  }
  if (status != TP_OK) return status;
  const char *at = problem->placement.world != NULL ? "as the block lies"
                   : scene->tilt_angle_deg.given    ? "at the tilt of the scene"
                                                    : "with the base level, as no tilt is given";
  return tp_notes_add(
      notes, message, TP_NOTE, water->place,
      "the pressures of the water are taken %s, and stay the same at other tilts, such "
      "as the critical one; where its level is held, vary the %s of the scene instead",
      at, problem->placement.world != NULL ? "dip" : "tilt");
}
