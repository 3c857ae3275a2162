/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Gap, normal, rows and their rates for every combination of corner, straight face, arc and
 * hollow. */

#include "rigid_contact/gap.h"

#include "plane/contact_rows.h"

#include <math.h>

typedef tp_turned_block turned;

static tp_xy turn(const turned *block, tp_xy a) {
  return (tp_xy){block->cosine * a.x - block->sine * a.y, block->sine * a.x + block->cosine * a.y};
}

/* By how much a normal lies between those of a corner, which has turned by an angle. */
static void meet(tp_gap *gap, const tp_round_corner *corner, tp_xy normal, double turned_by) {
  const double direction = atan2(normal.y, normal.x) - turned_by;
  double *margin = corner->radius == 0 ? &gap->cone_margin : &gap->arc_margin;
  *margin = fmin(*margin, tp_normal_range_margin(corner->range, direction));
}

static void set_rows(tp_gap *gap, const turned *block) {
  const tp_xy arm = tp_xy_plus(gap->at, -1, block->centroid);
  gap->tangent = (tp_xy){gap->normal.y, -gap->normal.x};
  tp_double_normal_row(gap->across, &arm.x, &arm.y, &gap->tangent.x, &gap->tangent.y);
  tp_double_slip_row(gap->along, &arm.x, &arm.y, &gap->tangent.x, &gap->tangent.y);
}

static double within(const tp_contact_face *face, tp_xy foot) {
  const double from = tp_xy_dot(tp_xy_plus(foot, -1, face->from), face->along);
  return fmin(from, face->length - from);
}

static void corner_on_straight(tp_gap *gap, const tp_round_corner *corner,
                               const tp_contact_face *face, const turned *block) {
  const tp_xy n = face->normal;
  const tp_xy d = turn(block, corner->centre), c = tp_xy_plus(block->centroid, 1, d);
  gap->normal = n;
  gap->width = tp_xy_dot(tp_xy_plus(c, -1, face->from), n) - corner->radius;
  gap->at = tp_xy_plus(c, -corner->radius, n);
  gap->margin = within(face, gap->at);
  set_rows(gap, block);
  gap->across_rate = -block->turning * block->turning * tp_xy_dot(d, n);
  gap->along_rate = -block->turning * block->turning * tp_xy_dot(d, gap->tangent);
}

static void straight_on_corner(tp_gap *gap, const tp_contact_face *face,
                               const tp_round_corner *corner, const turned *block) {
  const tp_xy out = turn(block, face->normal), n = {-out.x, -out.y};
  const tp_xy d = tp_xy_plus(corner->centre, -1, block->centroid);
  const tp_xy from_face = tp_xy_plus(d, -1, turn(block, face->from));
  const double w = block->turning;
  gap->normal = n;
  gap->width = tp_xy_dot(from_face, out) - corner->radius;
  gap->at = tp_xy_plus(corner->centre, corner->radius, n);
  const double foot = tp_xy_dot(from_face, turn(block, face->along));
  gap->margin = fmin(foot, face->length - foot);
  set_rows(gap, block);
  gap->across_rate = 2 * w * tp_xy_cross(n, block->velocity) + w * w * tp_xy_dot(d, n);
  gap->along_rate =
      2 * w * tp_xy_cross(gap->tangent, block->velocity) + w * w * tp_xy_dot(d, gap->tangent);
}

/* Centres and radii of two arcs; `inside`: one is hollow, of the block or of the base. */
typedef struct arcs {
  tp_xy block, base;
  double block_radius, base_radius;
  bool hollow_block, hollow_base;
} arcs;

static void arc_on_arc(tp_gap *gap, const arcs *a, const turned *block) {
  const bool inside = a->hollow_block || a->hollow_base;
  const double sign = inside ? -1 : 1;
  const tp_xy d = turn(block, a->block), c = tp_xy_plus(block->centroid, 1, d);
  const tp_xy apart = tp_xy_plus(c, -1, a->base);
  const double length = hypot(apart.x, apart.y);
  const tp_xy e = {apart.x / length, apart.y / length};
  const double w = block->turning;
  const double sum =
      inside ? fabs(a->base_radius - a->block_radius) : a->base_radius + a->block_radius;
  gap->width = sign * (length - sum);
  gap->normal = (tp_xy){sign * e.x, sign * e.y};
  gap->at = tp_xy_plus(c, a->hollow_block ? a->block_radius : -a->block_radius, gap->normal);
  set_rows(gap, block);
  const tp_xy u = {block->velocity.x - w * d.y, block->velocity.y + w * d.x};
  const double apart_speed = tp_xy_dot(e, u);
  gap->across_rate = sign * (tp_xy_dot(u, u) - apart_speed * apart_speed) / length -
                     w * w * tp_xy_dot(d, gap->normal);
  gap->along_rate =
      tp_xy_cross(e, u) / length * tp_xy_dot(gap->normal, u) - w * w * tp_xy_dot(d, gap->tangent);
}

static void corner_on_hollow(tp_gap *gap, const tp_round_corner *corner,
                             const tp_contact_face *face, const turned *block) {
  const tp_xy c = tp_xy_plus(block->centroid, 1, turn(block, corner->centre));
  const tp_xy out = tp_xy_plus(c, -1, face->centre);
  const double direction = atan2(out.y, out.x);
  gap->margin = tp_normal_range_margin(face->range, direction) * face->radius;
  const arcs a = {.block = corner->centre,
                  .base = face->centre,
                  .block_radius = corner->radius,
                  .base_radius = face->radius,
                  .hollow_base = true};
  arc_on_arc(gap, &a, block);
}

static void hollow_on_corner(tp_gap *gap, const tp_contact_face *face,
                             const tp_round_corner *corner, const turned *block) {
  const tp_xy c = tp_xy_plus(block->centroid, 1, turn(block, face->centre));
  const tp_xy out = tp_xy_plus(corner->centre, -1, c);
  const double direction = atan2(out.y, out.x);
  gap->margin = tp_normal_range_margin(face->range, direction - block->angle) * face->radius;
  const arcs a = {.block = face->centre,
                  .base = corner->centre,
                  .block_radius = face->radius,
                  .base_radius = corner->radius,
                  .hollow_block = true};
  arc_on_arc(gap, &a, block);
}

static void corner_on_corner(tp_gap *gap, const tp_round_corner *corner,
                             const tp_round_corner *base, const turned *block) {
  const arcs a = {.block = corner->centre,
                  .base = base->centre,
                  .block_radius = corner->radius,
                  .base_radius = base->radius};
  arc_on_arc(gap, &a, block);
}

/* The parts of a pair: of two that are NULL the block, or the base, has a face in it. */
typedef struct parts {
  const tp_round_corner *corner, *under;
  const tp_contact_face *on;
} parts;

static parts parts_of(const tp_contact_shapes *shapes, const tp_gap_pair *pair) {
  const bool own_face = pair->kind == TP_FACE_ON_CORNER, face = pair->kind == TP_CORNER_ON_FACE;
  return (parts){.corner = own_face ? NULL : shapes->block.corners + pair->block,
                 .under = face ? NULL : shapes->base.corners + pair->base,
                 .on = own_face ? shapes->block.faces + pair->block
                       : face   ? shapes->base.faces + pair->base
                                : NULL};
}

tp_turned_block tp_turned_block_at(const tp_motion_state *state) {
  const double angle = state->place[2];
  return (tp_turned_block){.sine = sin(angle),
                           .cosine = cos(angle),
                           .angle = angle,
                           .centroid = {state->place[0], state->place[1]},
                           .velocity = {state->speed[0], state->speed[1]},
                           .turning = state->speed[2]};
}

tp_gap tp_gap_moving(const tp_contact_shapes *shapes, const tp_gap_pair *pair,
                     const tp_turned_block *block) {
  const parts p = parts_of(shapes, pair);
  tp_gap gap = {.margin = INFINITY, .cone_margin = INFINITY, .arc_margin = INFINITY};
  if (p.corner == NULL) {
    (p.on->hollow ? hollow_on_corner : straight_on_corner)(&gap, p.on, p.under, block);
  } else if (p.under == NULL) {
    (p.on->hollow ? corner_on_hollow : corner_on_straight)(&gap, p.corner, p.on, block);
  } else {
    corner_on_corner(&gap, p.corner, p.under, block);
  }
  gap.base_edges[0] = p.under == NULL ? p.on->edge : p.under->before;
  gap.base_edges[1] = p.under == NULL ? p.on->edge : p.under->behind;
  return gap;
}

tp_gap tp_gap_at(const tp_contact_shapes *shapes, const tp_gap_pair *pair,
                 const tp_motion_state *state) {
  const tp_turned_block block = tp_turned_block_at(state);
  const parts p = parts_of(shapes, pair);
  tp_gap gap = tp_gap_moving(shapes, pair, &block);
  const tp_xy n = gap.normal;
  if (p.under != NULL) meet(&gap, p.under, n, 0);
  if (p.corner != NULL) meet(&gap, p.corner, (tp_xy){-n.x, -n.y}, block.angle);
  return gap;
}

/* Where they touch, a corner lies on a face: no farther from it than the reach before. */
bool tp_gap_in_reach(const tp_contact_shapes *shapes, const tp_gap_pair *pair,
                     const tp_turned_block *block, double reach) {
  const parts p = parts_of(shapes, pair);
  if (p.on == NULL || p.on->hollow) return true;
  const tp_round_corner *corner = p.corner != NULL ? p.corner : p.under;
  tp_xy apart = corner->centre; /* from the face's begin, as the face sees it */
  if (p.corner != NULL) {
    apart = tp_xy_plus(tp_xy_plus(block->centroid, 1, turn(block, apart)), -1, p.on->from);
  } else {
    const tp_xy d = tp_xy_plus(apart, -1, block->centroid);
    apart = (tp_xy){block->cosine * d.x + block->sine * d.y - p.on->from.x,
                    block->cosine * d.y - block->sine * d.x - p.on->from.y};
  }
  const double width = tp_xy_dot(apart, p.on->normal) - corner->radius;
  if (width > reach) return false;
  if (corner->radius > 0) return true;
  const double foot = tp_xy_dot(apart, p.on->along);
  return width >= -reach && foot >= -reach && foot <= p.on->length + reach;
}

bool tp_gap_faces(const tp_gap *gap) {
  const double within = fmin(gap->margin, gap->arc_margin);
  return within >= -TP_FACE_SLACK && (within > TP_FACE_SLACK || gap->cone_margin >= -TP_FACE_SLACK);
}

bool tp_pair_is(const tp_gap_pair *a, const tp_gap_pair *b) {
  return a->kind == b->kind && a->block == b->block && a->base == b->base;
}

double tp_gap_speed(const double row[3], const double speed[3]) {
  return tp_double_dot(row, speed);
}
