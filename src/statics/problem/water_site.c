/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The vertical in the frame of a problem, by the turn of its world or by its tilt; the ends of the
 * joint in scene lengths. */

#include "problem/water_site.h"

#include "plane/direction.h"

/* What the world turned: the coordinates of the scene about the point that stays. */
static void lie_turned(tp_lie *lie, const tp_turn *turn) {
  fmpq_set(lie->up_x, turn->sine);
  fmpq_set(lie->up_y, turn->cosine);
  fmpq_set(lie->x, turn->x);
  fmpq_set(lie->y, turn->y);
}

/* How the frame of the problem lies, and the one that the scene's coordinates are given in. */
static void find_lies(tp_wetting *q, const tp_water_site *site, bool left) {
  const tp_world *world = site->world;
  const tp_scene *scene = site->scene;
  if (world == NULL) {
    tp_lie_tilt(&q->block, scene->tilt_angle_deg.value, left);
    tp_lie_tilt(&q->drawn, scene->tilt_angle_deg.value, left);
  } else if (world->unturned) { /* a slope */
    const fmpq *dip = world->scene.tilt_angle_deg.value;
    tp_lie_tilt(&q->drawn, dip, world->turn.rises > 0);
    if (!world->level) tp_lie_tilt(&q->block, dip, world->turn.rises > 0);
  } else if (!world->level) {
    lie_turned(&q->block, &world->turn);
    if (fmpq_equal(scene->tilt_angle_deg.value, world->turn.dip_deg) == 0) {
      tp_lie_tilt(&q->block, scene->tilt_angle_deg.value, left); /* tilted by more */
    }
  }
  tp_lie_measure(&q->block);
  tp_lie_measure(&q->drawn);
}

/* The mean plane in the frame of the problem is x, or goes on in a direction of its own. */
static void find_rises(tp_wetting *q, const tp_water_site *site) {
  const tp_base_description *base = &site->scene->base;
  const fmpq *c = base->beyond_cosine, *s = base->beyond_sine;
  if (c == NULL) {
    fmpq_abs(q->foot_up, q->block.up_x);
    fmpq_set(q->face_up, q->block.up_y);
    return;
  }
  fmpq_mul(q->foot_up, q->block.up_x, c);
  fmpq_addmul(q->foot_up, q->block.up_y, s);
  fmpq_abs(q->foot_up, q->foot_up);
  fmpq_mul(q->face_up, q->block.up_y, c);
  fmpq_submul(q->face_up, q->block.up_x, s);
}

static tp_status refuse_shape(const tp_water_site *site, long digits, tp_message *message) {
  const tp_scene *scene = site->scene;
  const tp_place place = scene->loads.water.place;
  if (scene->block.form == TP_OUTLINE_ELLIPSE || scene->block.arc_count > 0) {
    return tp_refuse(
        message, TP_FAULT_GEOMETRY, place,
        "water with a level presses on straight edges: 'arc_tolerance' of the block makes "
        "chords of its arcs; or give the water as 'height'");
  }
  if (digits > TP_WORLD_DIGITS && !fmpq_is_zero(scene->tilt_angle_deg.value)) {
    return tp_refuse(message, TP_FAULT_RANGE, place,
                     "below a level of water numbers are certain to %d digits at most; ask for no "
                     "more, or give the pressures on the edges as 'pressures'",
                     TP_WORLD_DIGITS);
  }
  return TP_OK;
}

static void wetting_init(tp_wetting *q) {
  for (int side = 0; side < 2; side++) {
    fmpq_init(q->x + side);
    fmpq_init(q->y + side);
    fmpq_init(q->contact_x + side);
    fmpq_init(q->contact_y + side);
  }
  fmpq_init(q->foot_up);
  fmpq_init(q->face_up);
  tp_lie_init(&q->block);
  tp_lie_init(&q->drawn);
}

static void wetting_clear(tp_wetting *q) {
  for (int side = 0; side < 2; side++) {
    fmpq_clear(q->x + side);
    fmpq_clear(q->y + side);
    fmpq_clear(q->contact_x + side);
    fmpq_clear(q->contact_y + side);
  }
  fmpq_clear(q->foot_up);
  fmpq_clear(q->face_up);
  tp_lie_clear(&q->block);
  tp_lie_clear(&q->drawn);
}

/* Of a block that goes up-dip nothing pushes from behind, and so no gap there: its joint is taken
 * from end to end, with the pressures of its ends. */
static void find_gap(tp_wetting *q, const tp_base_joint *joint, int side) {
  fmpq_set(q->contact_x + side, q->x + side);
  fmpq_set(q->contact_y + side, q->y + side);
  q->gapes[side] = !q->up_dip && tp_base_joint_gapes(joint, side);
  if (!q->gapes[side]) return;
  fmpq_div(q->contact_x + side, joint->contact_x + side, q->scene->metres_per_unit);
  fmpq_div(q->contact_y + side, joint->contact_y + side, q->scene->metres_per_unit);
  q->contact_vertex[side] = joint->contact_vertex[side];
}

tp_status tp_water_site_find(tp_wetted *wetted, const tp_water_site *site, bool left, long digits,
                             tp_message *message) {
  const tp_scene *scene = site->scene;
  const tp_base_joint *joint = site->joint;
  const bool up_dip = scene->loads.water.lifts_alone;
  tp_wetting q = {.scene = scene,
                  .ring = site->ring,
                  .vertex = {joint->vertex[0], joint->vertex[1]},
                  .contact_vertex = {joint->vertex[0], joint->vertex[1]},
                  .behind = left != up_dip ? 1 : 0,
                  .up_dip = up_dip};
  tp_status status = refuse_shape(site, digits, message);
  if (status != TP_OK) return status;
  wetting_init(&q);
  for (int side = 0; side < 2; side++) {
    fmpq_div(q.x + side, joint->x + side, scene->metres_per_unit);
    fmpq_div(q.y + side, joint->y + side, scene->metres_per_unit);
    find_gap(&q, joint, side);
  }
  find_lies(&q, site, left);
  find_rises(&q, site);
  status = tp_wetted_init(wetted, &q, message);
  wetting_clear(&q);
  return status;
}
