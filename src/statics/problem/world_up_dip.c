/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A block on a slope under an earthquake that acts up-dip: the frame is level as the block lies,
 * the tilt zero, and the block moves towards its up-dip side (problem/world.h). */

#include "problem/world.h"

#include "base/underside.h"
#include "problem/as_given.h"

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

static bool goes_on(const tp_base_description *base) {
  return !fmpq_is_zero(base->beyond_left.value) || !fmpq_is_zero(base->beyond_right.value);
}

/* Of a block on a slope, checked as given: the ends of its contact, or on a profile its underside.
 */
static tp_status find_on_slope(tp_world *w, const tp_scene *scene, long ends[2],
                               const tp_section *section, tp_message *message) {
  tp_underside u;
  tp_lattice lattice;
  if (scene->block.form == TP_OUTLINE_ELLIPSE ||
      (scene->block.form == TP_OUTLINE_TEETH && goes_on(&scene->base))) {
    return tp_refuse(message, TP_FAULT_GEOMETRY, scene->block.place,
                     "an ellipse, and teeth whose base extends past them, are described along x; "
                     "give the block as an 'outline', and the base as its 'profile'");
  }
  if (!scene->base.mated) return tp_sole_find(&w->sole, scene, section, message);
  tp_status status = tp_as_given_check(&lattice, scene, section, NULL, message);
  if (status != TP_OK) return status;
  tp_lattice_clear(&lattice);
  status = tp_underside_find(&u, scene, section, message);
  if (status == TP_OK && u.none != NULL) status = tp_underside_fail(u.none, scene, message);
  ends[0] = u.first;
  ends[1] = u.last;
  return status;
}

/* The same turned until the horizontal is level, as a ring of vertices. */
static tp_status turn_on_slope(tp_world *w, const tp_scene *scene, tp_message *message) {
  tp_section section;
  long ends[2] = {0, 0};
  tp_status status = tp_section_init(&section, &scene->block, message);
  if (status != TP_OK) return status;
  status = find_on_slope(w, scene, ends, &section, message);
  if (status == TP_OK) {
    tp_scene ring = *scene; /* shares all with it */
    if (ring.block.form != TP_OUTLINE_VERTICES) ring.block.outline = section.rings[0];
    w->levelled.block.form = ring.block.form = TP_OUTLINE_VERTICES;
    if (!tp_turn_scene(&w->levelled, &w->lay, &ring, scene->base.mated, ends[0], ends[1])) {
      status = tp_fail_memory(message, "the turned scene");
    }
  }
  tp_section_clear(&section);
  return status;
}

tp_status tp_world_level(tp_world *w, const tp_scene **scene, tp_message *message) {
  tp_turn_by(&w->lay, w->scene.tilt_angle_deg.value, &w->turn);
  fmpq_set(w->cosine, w->lay.cosine);
  fmpq_neg(w->sine, w->lay.sine);
  w->level = true;
  w->along = *scene;
  tp_moved_begin(&w->levelled, *scene);
  if (w->unturned && !tp_scene_is_shifted(*scene)) {
    const tp_status status = turn_on_slope(w, *scene, message);
    if (status != TP_OK) return status;
  } else if (!tp_turn_scene(&w->levelled, &w->lay, *scene, false, 0, 0)) {
    return tp_fail_memory(message, "the turned scene");
  }
  go_up_dip(&w->levelled, w);
  fmpq_init(w->levelled.tilt_angle_deg.value); /* zero, which owns nothing */
  *scene = &w->levelled;
  return TP_OK;
}
