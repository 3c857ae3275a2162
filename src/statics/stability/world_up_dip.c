/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A block on a slope under an earthquake that acts up-dip: the frame is level as the block lies,
 * the tilt zero, and the block moves towards its up-dip side (stability/world.h). */

#include "stability/world.h"

/* Under an earthquake up-dip the block turns and slides against the dip: in a frame that is level
 * as the block lies, tilted by nothing towards the side up-dip. */
static void go_up_dip(tp_scene *own, const tp_world *w) {
  tp_water_description *water = &own->loads.water;
  own->base.beyond_cosine = w->cosine;
  own->base.beyond_sine = w->sine;
  own->towards_left = w->turn.rises < 0;
  own->towards_right = w->turn.rises > 0;
  water->lifts_alone = water->given;
}

/* The underside of a block on a profile, as seen along its mean plane. */
static tp_status find_sole(tp_world *w, const tp_scene *scene, tp_message *message) {
  tp_section section;
  tp_scene along;
  tp_moved_begin(&along, scene);
  tp_status status = tp_turn_scene(&along, &w->turn, scene, false, 0, 0)
                         ? tp_section_init(&section, &along.block, message)
                         : tp_fail_memory(message, "the turned scene");
  if (status == TP_OK) {
    status = tp_sole_find(&w->sole, &along, &section, message);
    tp_section_clear(&section);
  }
  tp_moved_clear(&along);
  return status;
}

tp_status tp_world_lay_up_dip(tp_world *w, const tp_scene *scene, tp_message *message) {
  w->level = true;
  tp_turn_by(&w->lay, scene->tilt_angle_deg.value, &w->turn);
  tp_turn_direction(w->cosine, w->sine, &w->turn, &w->lay);
  go_up_dip(&w->scene, w);
  fmpq_zero(w->scene.tilt_angle_deg.value);
  return scene->base.mated ? TP_OK : find_sole(w, scene, message);
}

tp_status tp_world_level(tp_world *w, const tp_scene **scene, tp_message *message) {
  tp_turn_by(&w->lay, w->scene.tilt_angle_deg.value, &w->turn);
  fmpq_set(w->cosine, w->lay.cosine);
  fmpq_neg(w->sine, w->lay.sine);
  w->level = true;
  w->along = *scene;
  tp_moved_begin(&w->levelled, *scene);
  if (!tp_turn_scene(&w->levelled, &w->lay, *scene, false, 0, 0)) {
    return tp_fail_memory(message, "the turned scene");
  }
  go_up_dip(&w->levelled, w);
  fmpq_init(w->levelled.tilt_angle_deg.value); /* zero, which owns nothing */
  *scene = &w->levelled;
  return TP_OK;
}
