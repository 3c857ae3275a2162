/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A ray p + t d of unit direction d meets the edge a + s e at t = (a - p) x e / (d x e) and s = (a
 * - p) x d / (d x e), in balls. The farthest such t is the way: behind a notch the block goes on.
 * An edge whose ends lie certainly on one side of the ray is not met; one that may be is, which
 * makes the way longer and the bolt shorter, never the reverse. Rock is taken to be where the edge
 * faces the base, or the up-dip side. */

#include "load/bolt_way.h"

#include "scene/anchor.h"

#include <stdio.h>

enum { WAY_BITS = 256 };

/* a x b of two vectors, of which the first is exact. */
static void cross(arb_t product, const fmpq_t ax, const fmpq_t ay, const arb_t bx, const arb_t by,
                  long bits) {
  arb_t x, y;
  arb_init(x);
  arb_init(y);
  arb_set_fmpq(x, ax, bits);
  arb_set_fmpq(y, ay, bits);
  arb_mul(product, x, by, bits);
  arb_submul(product, y, bx, bits);
  arb_clear(x);
  arb_clear(y);
}

typedef struct edge {
  fmpq_t from_x, from_y, to_x, to_y; /* its ends, less the point that the ray begins in */
  fmpq_t moment;                     /* of these two: the product of the vectors */
} edge;

static void edge_set(edge *e, const tp_polyline *ring, long k, const fmpq_t x, const fmpq_t y) {
  const long next = k + 1 == ring->count ? 0 : k + 1;
  fmpq_sub(e->from_x, ring->x + k, x);
  fmpq_sub(e->from_y, ring->y + k, y);
  fmpq_sub(e->to_x, ring->x + next, x);
  fmpq_sub(e->to_y, ring->y + next, y);
  fmpq_mul(e->moment, e->from_x, e->to_y);
  fmpq_submul(e->moment, e->from_y, e->to_x);
}

/* (a - p) x e is the moment of its ends, and d x e the difference of their products with d. */
static bool meets(arb_t way, const edge *e, const arb_t dx, const arb_t dy, long bits) {
  arb_t from, to;
  arb_init(from);
  arb_init(to);
  cross(from, e->from_x, e->from_y, dx, dy, bits);
  cross(to, e->to_x, e->to_y, dx, dy, bits);
  const bool aside = (arb_is_positive(from) && arb_is_positive(to)) ||
                     (arb_is_negative(from) && arb_is_negative(to));
  arb_sub(from, from, to, bits);
  const bool met = !aside && !arb_contains_zero(from);
  if (met) {
    arb_set_fmpq(way, e->moment, bits);
    arb_div(way, way, from, bits);
  }
  arb_clear(from);
  arb_clear(to);
  return met && !arb_is_negative(way);
}

long tp_bolt_way(arb_t way, const tp_polyline *ring, const fmpq_t x, const fmpq_t y,
                 const fmpq_t direction_deg, long bits) {
  edge e;
  arb_t dx, dy, own;
  fmpq *const numbers[] = {e.from_x, e.from_y, e.to_x, e.to_y, e.moment};
  for (int k = 0; k < 5; k++) fmpq_init(numbers[k]);
  arb_init(dx);
  arb_init(dy);
  arb_init(own);
  tp_ball_sin_cos_degrees(dy, dx, direction_deg, bits);
  arb_zero(way);
  long last = -1;
  for (long k = 0; k < ring->count; k++) {
    edge_set(&e, ring, k, x, y);
    if (!meets(own, &e, dx, dy, bits)) continue;
    if (last < 0 || arb_gt(own, way)) last = k;
    arb_max(way, way, own, bits);
  }
  for (int k = 0; k < 5; k++) fmpq_clear(numbers[k]);
  arb_clear(dx);
  arb_clear(dy);
  arb_clear(own);
  return last;
}

/* Does the edge face the base, or up-dip? Under an earthquake up-dip the block moves to that side,
 * in a frame that is level as it lies. */
static bool faces_rock(const tp_scene *scene, const tp_polyline *ring, long k) {
  const long next = k + 1 == ring->count ? 0 : k + 1;
  const bool up_dip = scene->base.beyond_cosine != NULL;
  const int runs = fmpq_cmp(ring->x + next, ring->x + k); /* outwards is (dy, -dx) */
  const int rises = fmpq_cmp(ring->y + next, ring->y + k);
  const bool behind_right = rises > 0 && (up_dip ? scene->towards_right : scene->towards_left);
  const bool behind_left = rises < 0 && (up_dip ? scene->towards_left : scene->towards_right);
  return runs > 0 || behind_right || behind_left;
}

/* Where its side is not said it goes up-dip, and is one that holds the block only if it goes into
 * rock there. */
static tp_status fail_rock(const tp_scene *scene, const tp_anchor_description *a,
                           const char *of_row, tp_message *message) {
  const bool takes = tp_anchor_took_side(scene, a);
  return tp_refuse(message, TP_FAULT_GEOMETRY, a->place,
                   "the bolt%s%s leaves the block where no rock is behind it: from 'at' along its "
                   "pull it must go out through the joint below or the up-dip face; %s",
                   of_row, takes ? ", taken to go up-dip," : "",
                   takes ? "say where it goes to, 'towards: left' or 'towards: right', or change "
                           "its dip"
                         : "change its dip, or 'towards'");
}

static tp_status check_way(const tp_scene *scene, const tp_anchor_description *a, long row,
                           const tp_polyline *ring, const fmpq_t x, const fmpq_t y,
                           tp_message *message) {
  fmpq_t direction;
  arb_t way, length;
  fmpq_init(direction);
  arb_init(way);
  arb_init(length);
  tp_anchor_direction(direction, scene, a);
  const long last = tp_bolt_way(way, ring, x, y, direction, WAY_BITS);
  const bool rock = last >= 0 && faces_rock(scene, ring, last);
  if (a->length.given) arb_set_fmpq(length, a->length.value, WAY_BITS);
  const bool reaches = !a->length.given || arb_gt(length, way);
  const double needed = arf_get_d(arb_midref(way), ARF_RND_UP);
  fmpq_clear(direction);
  arb_clear(way);
  arb_clear(length);
  char of_row[40] = "";
  if (tp_anchor_rows(a) > 1) snprintf(of_row, sizeof of_row, " of row %ld", row + 1);
  if (!rock) return fail_rock(scene, a, of_row, message);
  if (reaches) return TP_OK;
  return tp_refuse(message, TP_FAULT_GEOMETRY, a->length.place,
                   "the bolt%s ends in the block: its way through it to the rock is %.6g %s; give "
                   "a greater length, of which what is beyond that is the bond length",
                   of_row, needed, scene->length_unit);
}

tp_status tp_bolt_check(const tp_scene *scene, const tp_anchor_description *a,
                        const tp_polyline *ring, tp_message *message) {
  const long rows = tp_anchor_rows(a);
  fmpq_t x, y;
  fmpq_init(x);
  fmpq_init(y);
  tp_status status = TP_OK;
  for (long row = 0; row < rows && status == TP_OK; row++) {
    tp_anchor_point(x, y, a, row);
    if (!tp_loads_in_outline(ring, x, y)) {
      status = row == 0
                   ? tp_refuse(message, TP_FAULT_GEOMETRY, a->place,
                               "this anchor does not hold the block: 'at' "
                               "lies outside its outline")
                   : tp_refuse(message, TP_FAULT_GEOMETRY, a->rows.place,
                               "row %ld of these bolts does not hold the block: it lies outside "
                               "its outline; take fewer rows, or a smaller 'row_step'",
                               row + 1);
    } else if (a->length.given || tp_anchor_took_side(scene, a)) {
      status = check_way(scene, a, row, ring, x, y, message);
    }
  }
  fmpq_clear(x);
  fmpq_clear(y);
  return status;
}
