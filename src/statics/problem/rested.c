/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Centroid in rationals, the fall to rest by rest/settle.h, and the scene moved by the pose found;
 * refuses forms that can not be set down and explains why a block finds no rest. */

#include "problem/rested.h"

#include "base/profile.h"
#include "block/moments.h"
#include "common/message.h"
#include "problem/as_given.h"

#include <math.h>
#include <stdlib.h>

static tp_status check_form(const tp_scene *scene, tp_message *message) {
  const tp_block_description *block = &scene->block;
  if (scene->base.mated) {
    return tp_refuse(message, TP_FAULT_GEOMETRY, scene->base.rests_place,
                     "a mated base fits its block already; 'place: rest' is for a base with a "
                     "separate 'profile'");
  }
  if (block->form == TP_OUTLINE_ELLIPSE || block->arc_count > 0 || block->rounded.count > 0) {
    return tp_refuse(message, TP_FAULT_GEOMETRY, scene->base.rests_place,
                     "'place: rest' turns a block about its corners: it is for straight edges, "
                     "without 'arcs', 'rounded' corners and ellipses; 'arc_tolerance' of the block "
                     "makes chords of "
                     "its arcs");
  }
  return TP_OK;
}

/* Of the weight, in scene lengths: x = S_6 / (3 A_2), exactly. */
static void find_centroid(tp_exact_point *centroid, const tp_scene *scene,
                          const tp_section *section, const tp_lattice *lattice) {
  tp_moments moments;
  fmpq_t area, sum;
  tp_moments_init(&moments);
  fmpq_init(area);
  fmpq_init(sum);
  tp_moments_evaluate(&moments, section, lattice, scene->metres_per_unit,
                      (tp_rung){.level = TP_LEVEL_EXACT}, TP_AREA_SUM_COUNT);
  arf_get_fmpq(area, arb_midref(moments.weighted + TP_A2));
  fmpq_mul_si(area, area, 3);
  for (int axis = 0; axis < 2; axis++) {
    fmpq *own = axis == 0 ? &centroid->x : &centroid->y;
    arf_get_fmpq(sum, arb_midref(moments.weighted + (axis == 0 ? TP_X6 : TP_Y6)));
    fmpq_div(own, sum, area);
    fmpq_add_fmpz(own, own, axis == 0 ? lattice->origin_x : lattice->origin_y);
    fmpq_mul(own, own, lattice->step_m);
    fmpq_div(own, own, scene->metres_per_unit);
  }
  tp_moments_clear(&moments);
  fmpq_clear(area);
  fmpq_clear(sum);
}

static double turned_deg(const tp_pose *pose) {
  const double degrees = 57.295779513082323; /* 180/pi */
  return atan2(fmpq_get_d(pose->sine), fmpq_get_d(pose->cosine)) * degrees;
}

/* Why the block comes to no rest, with the pose where it left its base. */
static tp_status fail_to_rest(const tp_settling *s, const tp_scene *scene, tp_message *message) {
  const tp_place place = scene->base.rests_place;
  const char *unit = scene->length_unit;
  const double x = fmpq_get_d(&s->pivot.x), y = fmpq_get_d(&s->pivot.y);
  switch (s->how) {
  case TP_SETTLED_BESIDE:
    return tp_refuse(
        message, TP_FAULT_GEOMETRY, place,
        "set down where its coordinates lie, shifted where 'shift' says so, the block "
        "falls beside its base: no part of it stands over the profile; shift the block, "
        "or let the profile go on");
  case TP_SETTLED_ROLLS_OFF:
    return tp_refuse(
        message, TP_FAULT_GEOMETRY, place,
        "the block rolls off its base: after %ld turn%s, turned by %.6g° in all with its "
        "centroid in (%.9g, %.9g) %s, it goes over (%.9g, %.9g) %s and touches nothing "
        "more; let the profile go on, or shift the block",
        s->turns - 1, s->turns == 2 ? "" : "s", turned_deg(&s->bodies.pose),
        fmpq_get_d(&s->bodies.centroid.x), fmpq_get_d(&s->bodies.centroid.y), unit, x, y, unit);
  case TP_SETTLED_BALANCES:
    return tp_refuse(
        message, TP_FAULT_GEOMETRY, place,
        "the block balances on (%.9g, %.9g) %s, exactly below its centroid: it may fall "
        "either way; shift it to one side",
        x, y, unit);
  case TP_SETTLED_TOO_DEAR:
    return tp_refuse(
        message, TP_FAULT_RANGE, place,
        "the block has turned %ld times and not come to rest, on a profile of %ld points "
        "with %ld vertices of its own, and takes too long to go on: give the profile "
        "fewer points, or let the block lie where its coordinates put it, by 'place: "
        "as_given'",
        s->turns, s->bodies.profile_count, s->bodies.own.count);
  case TP_SETTLED_TOO_BLIND:
    return tp_settle_fail_blind(place, message);
  case TP_SETTLED_GOES_ON:
    return tp_fail(message, TP_UNDECIDED, place,
                   "the block has not come to rest after %ld turns, near (%.9g, %.9g) %s", s->turns,
                   x, y, unit);
  default:
    return tp_fail(message, TP_UNDECIDED, place,
                   "several corners of the block touch at once as it turns about (%.9g, %.9g) %s, "
                   "in a pose whose coordinates are not fractions; shift the block a little",
                   x, y, unit);
  }
}

static void move_with_block(fmpq_t x, fmpq_t y, const void *context) {
  tp_whole_pose_apply(x, y, context, x, y);
}

/* From the weight's line to the outermost contacts. */
static void find_margins(tp_rested *r) {
  const tp_settling *s = &r->settling;
  fmpq_t arm;
  fmpq_init(arm);
  for (long k = 0; k < s->touches.count; k++) {
    fmpq_sub(arm, &s->bodies.centroid.x, tp_touch_x(&s->bodies, s->touches.items + k));
    if (k == 0 || fmpq_cmp(arm, r->left) > 0) fmpq_set(r->left, arm);
    fmpq_neg(arm, arm);
    if (k == 0 || fmpq_cmp(arm, r->right) > 0) fmpq_set(r->right, arm);
  }
  fmpq_clear(arm);
}

static tp_status settle(tp_rested *r, const tp_scene *scene, const tp_section *section,
                        tp_message *message) {
  tp_base base;
  tp_lattice lattice = {0};
  tp_exact_point centroid;
  tp_status status = tp_base_init(&base, scene, section, message);
  if (status != TP_OK) return status;
  tp_exact_point_init(&centroid);
  status = tp_as_given_check(&lattice, scene, section, &base.ring, message);
  if (status == TP_OK) {
    find_centroid(&centroid, scene, section, &lattice);
    status = tp_settle(&r->settling, section->rings, &base.ring, &centroid,
                       scene->base.start_x.value, message);
    tp_lattice_clear(&lattice);
  }
  tp_exact_point_clear(&centroid);
  tp_base_clear(&base);
  if (status == TP_OK) r->settling.asked = scene->base.rests_place;
  if (status == TP_OK && r->settling.how != TP_SETTLED_RESTS) {
    status = fail_to_rest(&r->settling, scene, message);
  }
  return status;
}

static bool move(tp_rested *r, const tp_scene *scene, const tp_section *section) {
  const tp_point_map map = {move_with_block, &r->settling.bodies.whole};
  const tp_point_map stay = {NULL, NULL};
  fmpq_t none;
  fmpq_init(none);
  r->scene.block.form = TP_OUTLINE_VERTICES;
  const bool done = tp_moved_rings(&r->scene, scene, section->rings, section->rings + 1, &map) &&
                    tp_moved_block(&r->scene, scene, none, &map) &&
                    tp_moved_profile(&r->scene, scene, &stay);
  fmpq_clear(none);
  return done;
}

tp_status tp_rested_shift(tp_rested *r, const tp_scene *scene, const fmpq_t shift_x,
                          tp_message *message) {
  tp_section section;
  tp_status status = tp_settle_from(&r->settling, shift_x, message);
  if (status != TP_OK || r->settling.how != TP_SETTLED_RESTS) return status;
  status = tp_section_init(&section, &scene->block, message);
  if (status != TP_OK) return status;
  tp_moved_clear(&r->scene);
  tp_moved_begin(&r->scene, scene);
  if (!move(r, scene, &section)) status = tp_fail_memory(message, "the resting block");
  tp_section_clear(&section);
  find_margins(r);
  return status;
}

void tp_rested_free(tp_rested *r) {
  if (r == NULL) return;
  tp_moved_clear(&r->scene);
  tp_settling_clear(&r->settling);
  fmpq_clear(r->left);
  fmpq_clear(r->right);
  free(r);
}

tp_status tp_rested_init(tp_rested **rested, const tp_scene *scene, tp_message *message) {
  tp_section section;
  tp_status status = check_form(scene, message);
  if (status == TP_OK) status = tp_section_init(&section, &scene->block, message);
  if (status != TP_OK) return status;
  tp_rested *r = calloc(1, sizeof *r);
  if (r == NULL) {
    status = tp_fail_memory(message, "the resting block");
  } else {
    tp_moved_begin(&r->scene, scene);
    fmpq_init(r->left);
    fmpq_init(r->right);
    status = settle(r, scene, &section, message);
    if (status == TP_OK && !move(r, scene, &section)) {
      status = tp_fail_memory(message, "the resting block");
    }
    if (status == TP_OK) find_margins(r);
  }
  tp_section_clear(&section);
  if (status == TP_OK) {
    *rested = r;
  } else {
    tp_rested_free(r);
  }
  return status;
}
