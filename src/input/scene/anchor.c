/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A bolt that dips by b below the horizontal pulls to the right in the direction -b of horizontal
 * and vertical coordinates, to the left in 180 + b. Along a slope x runs at its dip d to the
 * horizontal: at +d where it dips to the left, which takes d from the direction, at -d where it
 * dips to the right. On a table that of the level table counts. In the world's frame x is level,
 * and the side that is up-dip is that of the mean plane, which is found later. A bolt of force F at
 * a spacing s bears F d / s on a block of thickness d. */

#include "scene/anchor.h"

#include "number/ratio.h"

/* To the right: where it is said, or into the slope. */
static bool runs_right(const tp_scene *scene, const tp_anchor_description *a) {
  if (a->side != TP_BOLT_UP_DIP) return a->side == TP_BOLT_RIGHT;
  if (scene->up_dip != TP_BOLT_UP_DIP) return scene->up_dip == TP_BOLT_RIGHT;
  return scene->frame == TP_FRAME_SLOPE ? scene->slope.left : !scene->towards_right;
}

void tp_anchor_direction(fmpq_t degrees, const tp_scene *scene, const tp_anchor_description *a) {
  fmpq_set(degrees, a->direction_deg.value);
  if (!a->dip_deg.given) return;
  fmpq_set(degrees, a->dip_deg.value);
  if (runs_right(scene, a)) {
    fmpq_neg(degrees, degrees);
  } else {
    fmpq_add_si(degrees, degrees, 180);
  }
  if (scene->frame != TP_FRAME_SLOPE) return;
  if (scene->slope.left) {
    fmpq_sub(degrees, degrees, scene->slope.dip_deg.value);
  } else {
    fmpq_add(degrees, degrees, scene->slope.dip_deg.value);
  }
}

/* An upright one has no side. */
bool tp_anchor_waits(const tp_scene *scene, const tp_anchor_description *a) {
  if (scene->frame != TP_FRAME_WORLD || scene->up_dip != TP_BOLT_UP_DIP) return false;
  return a->dip_deg.given && a->side == TP_BOLT_UP_DIP && fmpq_cmp_si(a->dip_deg.value, 90) != 0 &&
         fmpq_cmp_si(a->dip_deg.value, -90) != 0;
}

static tp_status fail_side(const tp_anchor_description *a, tp_message *message) {
  return tp_refuse(message, TP_FAULT_KEY, a->dip_deg.place,
                   "the scene does not say which side is up-dip: say where this bolt goes to, "
                   "'towards: left' or 'towards: right'");
}

tp_status tp_anchors_take_side(tp_scene *turned, const tp_scene *scene, int rises,
                               tp_message *message) {
  const bool one_side = scene->towards_left != scene->towards_right;
  if (rises != 0 || one_side) {
    turned->up_dip =
        rises > 0 || (rises == 0 && scene->towards_left) ? TP_BOLT_RIGHT : TP_BOLT_LEFT;
    return TP_OK;
  }
  for (long k = 0; k < scene->loads.anchor_count; k++) {
    const tp_anchor_description *a = scene->loads.anchors + k;
    if (tp_anchor_waits(scene, a)) return fail_side(a, message);
  }
  return TP_OK;
}

bool tp_anchor_took_side(const tp_scene *scene, const tp_anchor_description *a) {
  return scene->up_dip != TP_BOLT_UP_DIP && a->side == TP_BOLT_UP_DIP && !a->direction_deg.given;
}

long tp_anchor_rows(const tp_anchor_description *a) {
  return a->rows.given ? fmpz_get_si(fmpq_numref(a->rows.value)) : 1;
}

void tp_anchor_point(fmpq_t x, fmpq_t y, const tp_anchor_description *a, long row) {
  fmpq_mul_si(x, a->step_x.value, row);
  fmpq_mul_si(y, a->step_y.value, row);
  fmpq_add(x, x, a->x.value);
  fmpq_add(y, y, a->y.value);
}

const tp_quantity *tp_anchor_bolt_force(const tp_anchor_description *a) {
  return a->force_kn.given ? &a->force_kn : &a->capacity_kn;
}

void tp_anchor_row_force(fmpq_t kn, const tp_scene *scene, const tp_anchor_description *a) {
  fmpq_set(kn, tp_anchor_bolt_force(a)->value);
  if (!a->spacing.given) return;
  fmpq_div(kn, kn, a->spacing.value);
  if (scene->block.thickness.given) {
    fmpq_mul(kn, kn, scene->block.thickness.value);
  } else { /* 1 m */
    fmpq_div(kn, kn, scene->metres_per_unit);
  }
}

bool tp_anchor_is_bolt(const tp_anchor_description *a) {
  return !a->direction_deg.given || a->capacity_kn.given || a->length.given || a->spacing.given ||
         a->rows.given;
}

/* A far end says all. */
static tp_status check_end(const tp_anchor_description *a, tp_message *message) {
  if (!a->dip_deg.given && !a->direction_deg.given && !a->length.given &&
      a->side == TP_BOLT_UP_DIP) {
    return TP_OK;
  }
  return tp_refuse(message, TP_FAULT_KEY, a->place,
                   "'to' is the far end of the bolt, towards which it pulls: leave out 'dip_deg', "
                   "'direction_deg', 'length' and 'towards'");
}

static tp_status check_direction(const tp_scene *scene, const tp_anchor_description *a,
                                 tp_message *message) {
  if (scene->solid.wedge.place.file != NULL) return TP_OK; /* checked where it is read */
  if (a->azimuth_deg.given) {
    return tp_refuse(message, TP_FAULT_KEY, a->azimuth_deg.place,
                     "'azimuth_deg' is of a bolt in a wedge between two joints: leave it out");
  }
  if (a->to_x.given) return check_end(a, message);
  if (a->dip_deg.given == a->direction_deg.given) {
    return tp_refuse(message, TP_FAULT_KEY, a->place,
                     "a bolt has its 'dip_deg' below the horizontal, or an anchor its "
                     "'direction_deg' from x towards y: %s",
                     a->dip_deg.given ? "give one of them" : "'dip_deg: 15', for example");
  }
  if (a->side != TP_BOLT_UP_DIP && !a->dip_deg.given) {
    return tp_refuse(message, TP_FAULT_KEY, a->place,
                     "'towards' goes with 'dip_deg': 'direction_deg' says already where it pulls");
  }
  const bool found_later = scene->frame == TP_FRAME_WORLD && scene->many.count == 0;
  const bool plain =
      scene->frame == TP_FRAME_SLOPE || found_later || scene->towards_left != scene->towards_right;
  if (!a->dip_deg.given || a->side != TP_BOLT_UP_DIP || plain) return TP_OK;
  return fail_side(a, message);
}

static tp_status check_force(const tp_anchor_description *a, tp_message *message) {
  if (!a->force_kn.given && !(a->passive && a->capacity_kn.given)) {
    return tp_refuse(message, TP_FAULT_KEY, a->place,
                     a->capacity_kn.given
                         ? "an active bolt counts with the force that it is locked off at: give "
                           "its 'force_kn', or say 'passive: true', which counts up to the "
                           "capacity; to have the force found give any to begin with, 'force_kn: 1'"
                         : "'force_kn' is missing here: say, for example, 'force_kn: 50'");
  }
  if (!a->force_kn.given || !a->capacity_kn.given ||
      fmpq_cmp(a->force_kn.value, a->capacity_kn.value) <= 0) {
    return TP_OK;
  }
  char force[80], capacity[80];
  tp_ratio_text(force, sizeof force, a->force_kn.value);
  tp_ratio_text(capacity, sizeof capacity, a->capacity_kn.value);
  return tp_refuse(message, TP_FAULT_RANGE, a->force_kn.place,
                   "a force of %s kN is more than the capacity of this bolt, %s kN: lower it, or "
                   "take more or stronger bolts",
                   force, capacity);
}

static tp_status check_forces(const tp_scene *scene, tp_message *message) {
  tp_status status = TP_OK;
  for (long k = 0; k < scene->loads.force_count && status == TP_OK; k++) {
    const tp_anchor_description *force = scene->loads.forces + k;
    status = check_direction(scene, force, message);
    if (status == TP_OK) status = check_force(force, message);
  }
  return status;
}

tp_status tp_anchors_check(const tp_scene *scene, tp_message *message) {
  tp_status status = check_forces(scene, message);
  for (long k = 0; k < scene->loads.anchor_count && status == TP_OK; k++) {
    const tp_anchor_description *a = scene->loads.anchors + k;
    status = check_direction(scene, a, message);
    if (status == TP_OK) status = check_force(a, message);
    if (status == TP_OK && tp_anchor_rows(a) > 1 && !a->step_x.given) {
      status = tp_refuse(message, TP_FAULT_KEY, a->rows.place,
                         "of several rows say how far the next one is: 'row_step: [dx, dy]'");
    }
  }
  return status;
}
