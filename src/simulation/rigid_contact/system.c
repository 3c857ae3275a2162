/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Dimensionless body and drive, and the list of pairs within reach of each other, renewed when the
 * block has moved by half of it. */

#include "rigid_contact/system.h"

#include "common/budget.h"
#include "common/grow.h"

#include <math.h>
#include <stdlib.h>

/* Pairs within this distance of each other are listed, and listed anew after half of it has been
 * moved, so that a step may go as far again. */
static const double listed_reach = 0.2;

/* Of those, the ones that are near are told anew no sooner than it has moved by half of this. */
static const double least_near = 0.005;

static double distance_to_segment(tp_xy p, tp_xy from, tp_xy along, double length) {
  const double x = p.x - from.x, y = p.y - from.y;
  const double foot = fmin(fmax(x * along.x + y * along.y, 0), length);
  const double dx = x - foot * along.x, dy = y - foot * along.y;
  return sqrt(dx * dx + dy * dy); /* all of them are some extents at most */
}

/* Of a hollow face: to the circle it is part of. */
static double distance_to_face(const tp_contact_face *face, tp_xy p) {
  if (!face->hollow) return distance_to_segment(p, face->from, face->along, face->length);
  return fabs(hypot(p.x - face->centre.x, p.y - face->centre.y) - face->radius);
}

static tp_xy seen_from_base(const tp_motion_state *at, tp_xy p) {
  const double c = cos(at->place[2]), s = sin(at->place[2]);
  return (tp_xy){at->place[0] + c * p.x - s * p.y, at->place[1] + s * p.x + c * p.y};
}

static tp_xy seen_from_block(const tp_motion_state *at, tp_xy p) {
  const double c = cos(at->place[2]), s = sin(at->place[2]);
  const double x = p.x - at->place[0], y = p.y - at->place[1];
  return (tp_xy){c * x + s * y, c * y - s * x};
}

static bool add_pair(tp_contact_system *s, tp_pair_kind kind, long block, long base) {
  s->too_many = s->pair_count >= TP_BUDGET_RIGID_PAIRS;
  if (s->too_many) return false;
  tp_gap_pair *grown = tp_grow(s->pairs, s->pair_count, &s->pair_room, sizeof *grown);
  if (grown == NULL) return false;
  s->pairs = grown;
  s->pairs[s->pair_count++] = (tp_gap_pair){.kind = kind, .block = block, .base = base};
  return true;
}

/* Those with one part of the base. */
static bool list_corner(tp_contact_system *s, const tp_motion_state *at, long base) {
  const tp_round_corner *under = s->shapes.base.corners + base;
  const tp_xy p = seen_from_block(at, under->centre);
  if (hypot(p.x, p.y) > 1 + under->radius + listed_reach) return true;
  for (long k = 0; k < s->shapes.block.face_count; k++) {
    const double apart = distance_to_face(s->shapes.block.faces + k, p) - under->radius;
    if (apart < listed_reach && !add_pair(s, TP_FACE_ON_CORNER, k, base)) return false;
  }
  for (long k = 0; k < s->shapes.block.corner_count; k++) {
    const tp_round_corner *own = s->shapes.block.corners + k;
    const double radii = own->radius + under->radius;
    if (radii == 0) continue;
    const double apart = hypot(p.x - own->centre.x, p.y - own->centre.y) - radii;
    if (apart < listed_reach && !add_pair(s, TP_CORNER_ON_CORNER, k, base)) return false;
  }
  return true;
}

static bool list_face(tp_contact_system *s, const tp_motion_state *at, long base) {
  const tp_contact_face *face = s->shapes.base.faces + base;
  const tp_xy centroid = {at->place[0], at->place[1]};
  if (distance_to_face(face, centroid) > 1 + listed_reach) return true;
  for (long k = 0; k < s->shapes.block.corner_count; k++) {
    const tp_round_corner *own = s->shapes.block.corners + k;
    const double apart = distance_to_face(face, seen_from_base(at, own->centre)) - own->radius;
    if (apart < listed_reach && !add_pair(s, TP_CORNER_ON_FACE, k, base)) return false;
  }
  return true;
}

static bool list_all(tp_contact_system *s, const tp_motion_state *at) {
  s->pair_count = 0;
  s->near_count = -1;
  s->listed_at = *at;
  for (long k = 0; k < s->shapes.base.face_count; k++) {
    if (!list_face(s, at, k)) return false;
  }
  for (long k = 0; k < s->shapes.base.corner_count; k++) {
    if (!list_corner(s, at, k)) return false;
  }
  long *near = realloc(s->near, sizeof *near * (size_t)(s->pair_count + 1));
  if (near != NULL) s->near = near;
  return near != NULL;
}

static void take_over(tp_contact_system *s, const tp_gap_pair *old, long old_count) {
  for (long k = 0; k < old_count; k++) {
    if (!old[k].touching) continue;
    for (long j = 0; j < s->pair_count; j++) {
      if (tp_pair_is(s->pairs + j, old + k)) s->pairs[j].touching = true;
    }
  }
}

/* How far any point of the block has moved, at most. */
static double moved_since(const tp_motion_state *at, const tp_motion_state *state) {
  return hypot(state->place[0] - at->place[0], state->place[1] - at->place[1]) +
         fabs(state->place[2] - at->place[2]);
}

bool tp_contact_system_covers(const tp_contact_system *s, const tp_motion_state *state) {
  return moved_since(&s->listed_at, state) < listed_reach;
}

bool tp_contact_system_list(tp_contact_system *s, const tp_motion_state *state) {
  if (moved_since(&s->listed_at, state) < listed_reach / 2) return true;
  tp_gap_pair *old = s->pairs;
  const long old_count = s->pair_count;
  s->pairs = NULL;
  s->pair_room = 0;
  const bool done = list_all(s, state);
  if (done) take_over(s, old, old_count);
  free(old);
  return done;
}

void tp_contact_system_near(tp_contact_system *s, const tp_motion_state *state, double distance) {
  if (s->near_count >= 0 && moved_since(&s->near_at, state) + distance <= s->near_reach) return;
  const tp_turned_block block = tp_turned_block_at(state);
  s->near_at = *state;
  s->near_reach = fmax(1.5 * distance, least_near);
  s->near_count = 0;
  for (long k = 0; k < s->pair_count; k++) {
    const tp_gap_pair *pair = s->pairs + k;
    const bool near = tp_gap_in_reach(&s->shapes, pair, &block, s->near_reach);
    if (near || pair->touching) s->near[s->near_count++] = k;
  }
}

bool tp_contact_system_init(tp_contact_system *s, const tp_rigid_body *body, const tp_drive *drive,
                            const tp_body_state *start) {
  const double extent = body->extent_m;
  *s =
      (tp_contact_system){.body = body,
                          .drive = drive,
                          .time_unit_s = sqrt(extent / TP_GRAVITY_M_S2),
                          .base_left = INFINITY,
                          .base_right = -INFINITY,
                          .inertia = {1, 1, body->inertia_kg_m2 / body->mass_kg / extent / extent}};
  for (long k = 0; k < body->base.count; k++) {
    s->base_left = fmin(s->base_left, body->base.edges[k].from.x / extent);
    s->base_right = fmax(s->base_right, body->base.edges[k].from.x / extent);
  }
  const tp_motion_state at = tp_motion_of(s, start);
  const bool done = tp_contact_shape_init(&s->shapes.block, &body->outline, extent) &&
                    tp_contact_shape_init(&s->shapes.base, &body->base, extent) && list_all(s, &at);
  if (!done) {
    const bool too_many = s->too_many;
    tp_contact_system_clear(s);
    s->too_many = too_many;
  }
  return done;
}

void tp_contact_system_clear(tp_contact_system *s) {
  tp_contact_shape_clear(&s->shapes.block);
  tp_contact_shape_clear(&s->shapes.base);
  free(s->pairs);
  free(s->near);
  *s = (tp_contact_system){0};
}

tp_motion_state tp_motion_of(const tp_contact_system *s, const tp_body_state *state) {
  const double length = s->body->extent_m, time = s->time_unit_s;
  return (tp_motion_state){
      .place = {state->moved.x / length, state->moved.y / length, state->turned},
      .speed = {state->speed.x * time / length, state->speed.y * time / length,
                state->turning * time}};
}

tp_body_state tp_motion_told(const tp_contact_system *s, const tp_motion_state *state) {
  const double length = s->body->extent_m, time = s->time_unit_s;
  return (tp_body_state){
      .moved = {state->place[0] * length, state->place[1] * length},
      .turned = state->place[2],
      .speed = {state->speed[0] * length / time, state->speed[1] * length / time},
      .turning = state->speed[2] / time};
}

void tp_contact_system_free(double own[3], const tp_contact_system *s, double time) {
  const tp_body_force force = tp_drive_force(s->drive, s->body, time * s->time_unit_s);
  const double weight = s->body->mass_kg * TP_GRAVITY_M_S2;
  own[0] = force.x_n / weight;
  own[1] = force.y_n / weight;
  own[2] = force.moment_nm / weight / s->body->extent_m / s->inertia[2];
}

double tp_motion_energy(const tp_contact_system *s, const double speed[3]) {
  return (speed[0] * speed[0] + speed[1] * speed[1] + s->inertia[2] * speed[2] * speed[2]) / 2;
}

/* How far the contact's normal is from that of the edge: half the square of the angle between them,
 * for small ones. */
static double off_normal(const tp_edge *edge, tp_xy normal) {
  if (edge->arc) return 0;
  const double x = edge->to.x - edge->from.x, y = edge->to.y - edge->from.y;
  return 1 - (y * normal.x - x * normal.y) / hypot(x, y);
}

double tp_contact_friction(long *facet, const tp_contact_system *s, const tp_gap *gap) {
  const long before = gap->base_edges[0], behind = gap->base_edges[1];
  const tp_rigid_body *body = s->body;
  const double off = off_normal(body->base.edges + before, gap->normal) -
                     off_normal(body->base.edges + behind, gap->normal);
  const double near = 1e-12;
  const bool rougher = body->friction[before] > body->friction[behind];
  const long own = off > near || (off >= -near && rougher) ? behind : before;
  *facet = body->base.edges[own].number;
  return body->friction[own];
}

/* The least and the largest x of the block. */
static void reach_of(double reach[2], const tp_contact_system *s, const tp_motion_state *state) {
  reach[0] = INFINITY;
  reach[1] = -INFINITY;
  for (long k = 0; k < s->shapes.block.corner_count; k++) {
    const tp_round_corner *own = s->shapes.block.corners + k;
    const tp_xy p = seen_from_base(state, own->centre);
    reach[0] = fmin(reach[0], p.x - own->radius);
    reach[1] = fmax(reach[1], p.x + own->radius);
  }
}

/* Exact where it is nearly not. */
double tp_contact_system_overlap(const tp_contact_system *s, const tp_motion_state *state) {
  const double x = state->place[0];
  double reach[2];
  if (x > s->base_left && x < s->base_right) return fmin(x - s->base_left, s->base_right - x);
  reach_of(reach, s, state);
  return fmin(reach[1] - s->base_left, s->base_right - reach[0]);
}
