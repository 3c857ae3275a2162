/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A block on a slope under an earthquake that acts up-dip: the frame is level as the block lies,
 * the tilt zero, and the block moves towards its up-dip side (problem/world.h). */

#include "problem/world.h"

#include "base/profile.h"
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

static bool toothed_on(const tp_scene *scene) {
  return scene->block.form == TP_OUTLINE_TEETH && scene->base.mated && goes_on(&scene->base);
}

static bool has_facet_friction(const tp_scene *scene) {
  return scene->friction.facet_count > 0;
}

/* Teeth go on along x past the block: the base that they make, as a profile that can be turned. */
static tp_status set_profile(tp_scene *own, const tp_scene *scene, const tp_section *section,
                             tp_message *message) {
  tp_base base;
  const tp_status status = tp_base_init(&base, scene, section, message);
  if (status != TP_OK) return status;
  own->base.mated = false;
  own->base.profile = (tp_polyline){.file = base.ring.file, .mark = base.ring.mark};
  bool done = true;
  for (long k = 0; k <= base.edge_count && done; k++) {
    done = tp_polyline_append(&own->base.profile, base.ring.x + k, base.ring.y + k,
                              base.ring.marks[k]);
  }
  tp_base_clear(&base);
  if (done) return TP_OK;
  tp_polyline_clear(&own->base.profile);
  return tp_fail_memory(message, "the base");
}

/* Of a block on a slope, checked as given: the ends of its contact, or on a profile its underside.
 */
static tp_status find_on_slope(tp_world *w, const tp_scene *scene, long ends[2],
                               const tp_section *section, tp_message *message) {
  tp_underside u;
  tp_lattice lattice;
  if (toothed_on(scene) && has_facet_friction(scene)) {
    return tp_refuse(message, TP_FAULT_GEOMETRY, scene->block.place,
                     "teeth whose base extends past them where facets have their own friction are "
                     "described along x; give the block as an 'outline', and the base as its "
                     "'profile'");
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
static tp_status turn_ring(tp_world *w, tp_scene *ring, const tp_section *section,
                           tp_message *message) {
  long ends[2] = {0, 0};
  const tp_status status = find_on_slope(w, ring, ends, section, message);
  if (status != TP_OK) return status;
  if (ring->block.form != TP_OUTLINE_VERTICES) ring->block.outline = section->rings[0];
  w->levelled.block.form = ring->block.form = TP_OUTLINE_VERTICES;
  w->levelled.base.mated = ring->base.mated;
  if (section->ellipse != NULL) { /* by the polygon around it */
    w->levelled.block.ellipse.cosine = w->lay.cosine;
    w->levelled.block.ellipse.sine = w->lay.sine;
  }
  return tp_turn_scene(&w->levelled, &w->lay, ring, ring->base.mated, ends[0], ends[1])
             ? TP_OK
             : tp_fail_memory(message, "the turned scene");
}

static tp_status turn_on_slope(tp_world *w, const tp_scene *scene, tp_message *message) {
  tp_section section;
  tp_status status = tp_section_init(&section, &scene->block, message);
  if (status != TP_OK) return status;
  tp_scene ring = *scene; /* shares all with it */
  const bool made = toothed_on(scene) && !has_facet_friction(scene);
  if (made) status = set_profile(&ring, scene, &section, message);
  if (status == TP_OK) {
    status = turn_ring(w, &ring, &section, message);
    if (made) tp_polyline_clear(&ring.base.profile);
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
