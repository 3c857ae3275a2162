/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Which edges of an outline water presses on: from the ends of the base joint up to the summit on
 * the sides that it wets, and over the top where it stands above that; the joint from one end to
 * the other; the band of ice (docs/loads.md, water as a site has it). */

#include "load/wetted.h"

#include "load/check.h"
#include "load/water_stand.h"

#include <stdlib.h>

/* A part of the outline, counter-clockwise. */
typedef struct chain {
  tp_polyline drawn, world; /* the latter across and up */
} chain;

/* The outline from the right end of the joint round the outside to its left end, and what wets it.
 */
typedef struct wetting {
  const tp_wetting *of;
  chain chain;
  tp_polyline surface;      /* laid; empty: a level */
  tp_water_stand stand[2];  /* to the left and to the right */
  bool reaches[2];          /* faces of that side, and the end of the joint there */
  long right_top, left_top; /* the first and the last of the highest points */
  fmpq_t unit_kpa;          /* the pressure of a unit of depth */
} wetting;

static void chain_clear(chain *c) {
  tp_polyline_clear(&c->drawn);
  tp_polyline_clear(&c->world);
}

static void wetting_clear(wetting *w) {
  chain_clear(&w->chain);
  tp_polyline_clear(&w->surface);
  fmpq_clear(w->stand[0].level);
  fmpq_clear(w->stand[1].level);
  fmpq_clear(w->unit_kpa);
}

/* ---- the outline ------------------------------------------------------------------------------
 */

/* The edge that a point lies on, counted by its first vertex; 0 where none is found, as of an end
 * of the joint that was moved. */
static long edge_of(const tp_wetting *q, const fmpq *x, const fmpq *y) {
  for (long k = 0; k < q->ring->count; k++) {
    if (tp_loads_on_edge(q->ring, k, x, y)) return k;
  }
  return 0;
}

static bool append(chain *c, const tp_wetting *q, const fmpq *x, const fmpq *y) {
  fmpq_t across, up;
  fmpq_init(across);
  fmpq_init(up);
  tp_lie_of(across, up, &q->block, x, y);
  const tp_mark none = {0, 0};
  const bool done =
      tp_polyline_append(&c->drawn, x, y, none) && tp_polyline_append(&c->world, across, up, none);
  fmpq_clear(across);
  fmpq_clear(up);
  return done;
}

/* A point of the outline. */
typedef struct outline_point {
  const fmpq *x, *y;
  long vertex; /* -1: inside an edge */
} outline_point;

/* From a point counter-clockwise to another one: all round where both lie inside of one edge,
 * unless the way is `short_way`, which is along it. False when memory is exhausted. */
static bool find_part(chain *c, const tp_wetting *q, outline_point from, outline_point to,
                      bool short_way) {
  const long count = q->ring->count;
  const long from_edge = from.vertex >= 0 ? from.vertex : edge_of(q, from.x, from.y);
  const long first = from.vertex >= 0 ? from.vertex : (from_edge + 1) % count;
  const long last = to.vertex >= 0 ? to.vertex : edge_of(q, to.x, to.y);
  bool done = from.vertex >= 0 || append(c, q, from.x, from.y);
  const bool along_edge = short_way && from.vertex < 0 && to.vertex < 0 && from_edge == last;
  for (long k = first; done && !along_edge; k = (k + 1) % count) {
    done = append(c, q, q->ring->x + k, q->ring->y + k);
    if (k == last) break;
  }
  return done && (to.vertex >= 0 || append(c, q, to.x, to.y));
}

static outline_point end_of(const tp_wetting *q, int side) {
  return (outline_point){q->x + side, q->y + side, q->vertex[side]};
}

static outline_point contact_of(const tp_wetting *q, int side) {
  return (outline_point){q->contact_x + side, q->contact_y + side, q->contact_vertex[side]};
}

static bool find_chain(wetting *w) {
  const tp_wetting *q = w->of;
  const bool done = find_part(&w->chain, q, end_of(q, 1), end_of(q, 0), false);
  for (long k = 1; done && k < w->chain.world.count; k++) {
    const int above = fmpq_cmp(w->chain.world.y + k, w->chain.world.y + w->right_top);
    if (above > 0) w->right_top = k;
    if (above >= 0) w->left_top = k;
  }
  return done;
}

/* ---- the water --------------------------------------------------------------------------------
 */

/* Up-dip of the block: its own level, or that of the crack. */
static void set_crack(wetting *w, const fmpq_t heel_up) {
  const tp_wetting *q = w->of;
  const tp_water_description *water = &q->scene->loads.water;
  tp_water_stand *stand = w->stand + q->behind;
  stand->surface = NULL;
  if (water->crack_height.given) {
    fmpq_mul(stand->level, water->crack_height.value, q->face_up);
    if (water->crack_distance.given) {
      fmpq_addmul(stand->level, water->crack_distance.value, q->foot_up);
    }
    fmpq_add(stand->level, stand->level, heel_up);
    return;
  }
  fmpq_set(stand->level, water->crack_level.value);
  if (q->scene->frame != TP_FRAME_WORLD) fmpq_add(stand->level, stand->level, heel_up);
}

static tp_status lay_surface(wetting *w, tp_message *message) {
  const tp_polyline *all = &w->chain.world;
  const fmpq *least = all->x, *greatest = all->x;
  for (long k = 1; k < all->count; k++) {
    if (fmpq_cmp(all->x + k, least) < 0) least = all->x + k;
    if (fmpq_cmp(all->x + k, greatest) > 0) greatest = all->x + k;
  }
  return tp_water_surface_lay(&w->surface, &w->of->scene->loads.water.surface, &w->of->drawn, least,
                              greatest, message);
}

static tp_status find_stands(wetting *w, tp_message *message) {
  const tp_wetting *q = w->of;
  const tp_water_description *water = &q->scene->loads.water;
  fmpq_t across, heel_up;
  fmpq_init(across);
  fmpq_init(heel_up);
  tp_lie_of(across, heel_up, &q->block, q->x + q->behind, q->y + q->behind);
  tp_status status = TP_OK;
  if (water->surface.count > 0) status = lay_surface(w, message);
  for (int side = 0; side < 2 && status == TP_OK; side++) {
    w->stand[side].surface = water->surface.count > 0 ? &w->surface : NULL;
    fmpq_set(w->stand[side].level, water->level.value);
    if (q->scene->frame != TP_FRAME_WORLD) {
      fmpq_add(w->stand[side].level, w->stand[side].level, heel_up);
    }
  }
  if (water->cracked) set_crack(w, heel_up);
  const bool alone = water->cracked && !water->level.given && water->surface.count == 0;
  if (alone) { /* it stands nowhere else, and at the toe as high where that is sealed */
    fmpq_set(w->stand[1 - q->behind].level, w->stand[q->behind].level);
  } else if (water->cracked && water->faces != TP_WATER_ON_BOTH) {
    w->stand[1 - q->behind].surface = NULL;
    fmpq_set(w->stand[1 - q->behind].level, w->stand[q->behind].level);
  }
  w->reaches[q->behind] = water->faces != TP_WATER_IN_FRONT;
  w->reaches[1 - q->behind] = water->faces == TP_WATER_IN_FRONT || water->faces == TP_WATER_ON_BOTH;
  fmpq_mul(w->unit_kpa, water->unit_weight_kn_m3.value, q->scene->metres_per_unit);
  fmpq_clear(across);
  fmpq_clear(heel_up);
  return status;
}

/* ---- what it presses on -----------------------------------------------------------------------
 */

static bool stands_above(const wetting *w, int side) {
  fmpq_t depth;
  fmpq_init(depth);
  const long top = side == 1 ? w->right_top : w->left_top;
  tp_water_stand_depth(depth, w->stand + side, w->chain.world.x + top, w->chain.world.y + top);
  const bool above = fmpq_sgn(depth) > 0;
  fmpq_clear(depth);
  return above;
}

/* Is it no steeper than 45 degrees, as the block lies, and faces up? */
static bool faces_up(const wetting *w, long k) {
  fmpq_t run, rise;
  fmpq_init(run);
  fmpq_init(rise);
  fmpq_sub(run, w->chain.world.x + k, w->chain.world.x + k + 1);
  fmpq_sub(rise, w->chain.world.y + k + 1, w->chain.world.y + k);
  fmpq_abs(rise, rise);
  const bool up = fmpq_sgn(run) > 0 && fmpq_cmp(run, rise) >= 0;
  fmpq_clear(run);
  fmpq_clear(rise);
  return up;
}

/* The edges that the water on one side presses on, from `from` up to `to`: up to the summit, and on
 * over the top where it stands above that and the other side has none of its own. On a level top
 * between two summits it is the water in front that stands: behind a crack may hold another level.
 */
static void find_edges(long *from, long *to, const wetting *w, int side, bool alone) {
  *from = side == 1 ? 0 : w->left_top;
  *to = side == 1 ? w->right_top : w->chain.drawn.count - 1;
  const int front = 1 - w->of->behind;
  const bool takes_top = alone || side == front || !stands_above(w, front);
  if (!stands_above(w, side)) return;
  if (side == 1) {
    if (takes_top) *to = w->left_top;
    while (alone && *to + 1 < w->chain.drawn.count && faces_up(w, *to)) ++*to;
  } else {
    if (takes_top) *from = w->right_top;
    while (alone && *from > 0 && faces_up(w, *from - 1)) --*from;
  }
}

static bool press_on_faces(tp_wetted *wetted, const wetting *w) {
  const tp_wetting *q = w->of;
  const tp_water_description *water = &q->scene->loads.water;
  const int driving = q->up_dip ? 1 - q->behind : q->behind; /* from where a push moves the block */
  const bool iced = !fmpq_is_zero(water->ice_kpa.value);
  bool done = true;
  for (int side = 0; side < 2; side++) {
    if (side == 1) wetted->from_right = wetted->faces.count;
    if (!w->reaches[side] || (q->up_dip && side == q->behind)) continue;
    long from = 0, to = 0;
    find_edges(&from, &to, w, side, !w->reaches[1 - side]);
    wetted->overtops = wetted->overtops || stands_above(w, side);
    for (long k = from; k < to && done; k++) {
      done = tp_water_press(&wetted->faces, w->stand + side, &w->chain.drawn, &w->chain.world, k,
                            w->unit_kpa, NULL);
      if (!done || !iced || side != driving) continue;
      done = tp_water_press(&wetted->ice, w->stand + side, &w->chain.drawn, &w->chain.world, k,
                            water->ice_kpa.value, water->ice_thickness.value);
    }
  }
  return done;
}

/* Is the water that stands on one side in the joint at its full pressure there? */
static bool is_full(const wetting *w, int side) {
  return w->reaches[side] || w->of->scene->loads.water.shape != TP_WATER_UPLIFT_TRIANGULAR;
}

/* The pressure in the joint at its outermost contact on one side. */
static void pressure_at_end(fmpq_t kpa, const wetting *w, int side) {
  const tp_wetting *q = w->of;
  fmpq_t across, up;
  fmpq_init(across);
  fmpq_init(up);
  tp_lie_of(across, up, &q->block, q->contact_x + side, q->contact_y + side);
  if (is_full(w, side)) {
    tp_water_stand_depth(kpa, w->stand + side, across, up);
    fmpq_mul(kpa, kpa, w->unit_kpa);
  }
  fmpq_clear(across);
  fmpq_clear(up);
}

/* In an open gap between an end of the joint and its outermost contact there the water stands as it
 * does outside: its pressure is that of its depth, on the underside as it is. */
static bool press_in_gap(tp_wetted *wetted, const wetting *w, int side) {
  const tp_wetting *q = w->of;
  if (!q->gapes[side] || !is_full(w, side)) return true;
  chain gap = {{0}, {0}};
  const long before = wetted->joint.count;
  bool done = side == 1 ? find_part(&gap, q, contact_of(q, 1), end_of(q, 1), true)
                        : find_part(&gap, q, end_of(q, 0), contact_of(q, 0), true);
  for (long k = 0; k + 1 < gap.drawn.count && done; k++) {
    done = tp_water_press(&wetted->joint, w->stand + side, &gap.drawn, &gap.world, k, w->unit_kpa,
                          NULL);
  }
  wetted->gap_lines += wetted->joint.count - before;
  chain_clear(&gap);
  return done;
}

static bool press_in_joint(tp_wetted *wetted, const wetting *w) {
  const tp_wetting *q = w->of;
  const fmpq *const from[2] = {q->contact_x, q->contact_y};
  const fmpq *const to[2] = {q->contact_x + 1, q->contact_y + 1};
  fmpq_t left, right;
  fmpq_init(left);
  fmpq_init(right);
  pressure_at_end(left, w, 0);
  pressure_at_end(right, w, 1);
  const bool wet = q->scene->loads.water.uplift;
  wetted->dry = wetted->faces.count == 0 && fmpq_sgn(left) <= 0 && fmpq_sgn(right) <= 0;
  bool done = !wet || tp_wet_lines_add(&wetted->joint, from, to, left, right);
  for (int side = 0; side < 2 && wet && done; side++) done = press_in_gap(wetted, w, side);
  wetted->dry = wetted->dry && wetted->gap_lines == 0;
  fmpq_clear(left);
  fmpq_clear(right);
  return done;
}

tp_status tp_wetted_init(tp_wetted *wetted, const tp_wetting *wetting_of, tp_message *message) {
  wetting w = {.of = wetting_of};
  *wetted = (tp_wetted){0};
  fmpq_init(w.stand[0].level);
  fmpq_init(w.stand[1].level);
  fmpq_init(w.unit_kpa);
  tp_status status = find_chain(&w) ? TP_OK : tp_fail_memory(message, "the water");
  if (status == TP_OK) status = find_stands(&w, message);
  if (status == TP_OK && !(press_on_faces(wetted, &w) && press_in_joint(wetted, &w))) {
    status = tp_fail_memory(message, "the water");
  }
  wetting_clear(&w);
  if (status != TP_OK) tp_wetted_clear(wetted);
  return status;
}

void tp_wetted_clear(tp_wetted *wetted) {
  tp_wet_lines_clear(&wetted->faces);
  tp_wet_lines_clear(&wetted->joint);
  tp_wet_lines_clear(&wetted->ice);
}
