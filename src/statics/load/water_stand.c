/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Depths below a level or a surface along an edge, in rationals: the edge is cut where the surface
 * bends above it, and where it leaves the water; between, the depth is linear. */

#include "load/water_stand.h"

#include "number/between.h"

void tp_water_stand_at(fmpq_t up, const tp_water_stand *stand, const fmpq_t across) {
  const tp_polyline *s = stand->surface;
  if (s == NULL) {
    fmpq_set(up, stand->level);
    return;
  }
  long low = 0, high = s->count - 1; /* it lies over both */
  while (high - low > 1) {
    const long middle = low + (high - low) / 2;
    if (fmpq_cmp(s->x + middle, across) <= 0) {
      low = middle;
    } else {
      high = middle;
    }
  }
  fmpq_t share, run;
  fmpq_init(share);
  fmpq_init(run);
  fmpq_sub(share, across, s->x + low);
  fmpq_sub(run, s->x + high, s->x + low);
  fmpq_div(share, share, run);
  fmpq_sub(run, s->y + high, s->y + low);
  fmpq_mul(share, share, run);
  fmpq_add(up, s->y + low, share);
  fmpq_clear(share);
  fmpq_clear(run);
}

void tp_water_stand_depth(fmpq_t depth, const tp_water_stand *stand, const fmpq_t across,
                          const fmpq_t up) {
  fmpq_t level;
  fmpq_init(level);
  tp_water_stand_at(level, stand, across);
  fmpq_sub(depth, level, up);
  fmpq_clear(level);
}

tp_status tp_water_surface_lay(tp_polyline *laid, const tp_polyline *surface, const tp_lie *drawn,
                               const fmpq_t least, const fmpq_t greatest, tp_message *message) {
  *laid = (tp_polyline){0};
  if (!tp_polyline_copy(laid, surface)) return tp_fail_memory(message, "the surface of the water");
  tp_status status = TP_OK;
  for (long k = 0; k < laid->count && status == TP_OK; k++) {
    tp_lie_of(laid->x + k, laid->y + k, drawn, surface->x + k, surface->y + k);
    if (k == 0 || fmpq_cmp(laid->x + k - 1, laid->x + k) < 0) continue;
    status =
        tp_refuse(message, TP_FAULT_GEOMETRY, tp_polyline_place(surface, k),
                  "the surface of the water goes back here, or stands upright: it would cross "
                  "itself or lie twice over one place; list its points from left to right, each "
                  "farther right than the last as the block lies");
  }
  const bool from_left = status != TP_OK || fmpq_cmp(laid->x, least) <= 0;
  const bool to_right = status != TP_OK || fmpq_cmp(laid->x + laid->count - 1, greatest) >= 0;
  if (!from_left || !to_right) {
    status = tp_refuse(message, TP_FAULT_GEOMETRY,
                       tp_polyline_place(surface, from_left ? surface->count - 1 : 0),
                       "the surface of the water ends here, above the block or before it: let it "
                       "reach past the %s side of the block, as the block lies",
                       from_left ? "right" : "left");
  }
  if (status != TP_OK) tp_polyline_clear(laid);
  return status;
}

/* ---- lines -------------------------------------------------------------------------------------
 */

/* A stretch of an edge: shares of it, and the depths there. */
typedef struct stretch {
  fmpq_t from, to, first, last;
} stretch;

static void stretch_init(stretch *s) {
  fmpq *const all[] = {s->from, s->to, s->first, s->last};
  for (int k = 0; k < 4; k++) fmpq_init(all[k]);
}

static void stretch_clear(stretch *s) {
  fmpq *const all[] = {s->from, s->to, s->first, s->last};
  for (int k = 0; k < 4; k++) fmpq_clear(all[k]);
}

/* Cut off what lies on one side of a depth: `side` 1 keeps the deeper part, -1 the other. False:
 * nothing of a length is left. */
static bool cut(stretch *s, const fmpq_t depth, int side) {
  const bool first = side * fmpq_cmp(s->first, depth) >= 0;
  const bool last = side * fmpq_cmp(s->last, depth) >= 0;
  if (first && last) return true;
  if (!first && !last) return false;
  fmpq_t share, whole;
  fmpq_init(share);
  fmpq_init(whole);
  fmpq_sub(share, depth, s->first);
  fmpq_sub(whole, s->last, s->first);
  fmpq_div(share, share, whole);
  tp_ratio_between(first ? s->to : s->from, s->from, s->to, share);
  fmpq_set(first ? s->last : s->first, depth);
  fmpq_clear(share);
  fmpq_clear(whole);
  return fmpq_cmp(s->from, s->to) < 0;
}

static bool add(tp_wet_lines *lines, const fmpq *const from[2], const fmpq *const to[2],
                const stretch *s, const fmpq_t first_kpa, const fmpq_t last_kpa) {
  tp_line_load *line = tp_wet_lines_next(lines);
  if (line == NULL) return false;
  tp_ratio_between(line->x0.value, from[0], to[0], s->from);
  tp_ratio_between(line->y0.value, from[1], to[1], s->from);
  tp_ratio_between(line->x1.value, from[0], to[0], s->to);
  tp_ratio_between(line->y1.value, from[1], to[1], s->to);
  fmpq_set(line->first_kpa.value, first_kpa);
  fmpq_set(line->last_kpa.value, last_kpa);
  return true;
}

bool tp_wet_lines_add(tp_wet_lines *lines, const fmpq *const from[2], const fmpq *const to[2],
                      const fmpq_t first, const fmpq_t last) {
  stretch s;
  fmpq_t zero;
  stretch_init(&s);
  fmpq_init(zero);
  fmpq_one(s.to);
  fmpq_set(s.first, first);
  fmpq_set(s.last, last);
  const bool presses = fmpq_sgn(first) > 0 || fmpq_sgn(last) > 0;
  const bool done = !presses || !cut(&s, zero, 1) || add(lines, from, to, &s, s.first, s.last);
  fmpq_clear(zero);
  stretch_clear(&s);
  return done;
}

/* One stretch, over which the depth is linear. */
static bool press(tp_wet_lines *lines, stretch *s, const fmpq *const from[2],
                  const fmpq *const to[2], const fmpq_t unit_kpa, const fmpq *thickness) {
  fmpq_t zero;
  fmpq_init(zero);
  const bool wet = (fmpq_sgn(s->first) > 0 || fmpq_sgn(s->last) > 0) && cut(s, zero, 1);
  fmpq_clear(zero);
  if (!wet) return true;
  if (thickness != NULL) {
    return !cut(s, thickness, -1) || add(lines, from, to, s, unit_kpa, unit_kpa);
  }
  fmpq_mul(s->first, s->first, unit_kpa);
  fmpq_mul(s->last, s->last, unit_kpa);
  return add(lines, from, to, s, s->first, s->last);
}

/* The share of an edge that lies below a bend of the surface. */
static void share_below(fmpq_t share, const fmpq *bend, const fmpq *from, const fmpq *to) {
  fmpq_t whole;
  fmpq_init(whole);
  fmpq_sub(share, bend, from);
  fmpq_sub(whole, to, from);
  fmpq_div(share, share, whole);
  fmpq_clear(whole);
}

/* The depth of an edge's point at a share of it. */
static void set_depth(fmpq_t depth, const tp_water_stand *stand, const tp_polyline *world, long k,
                      const fmpq_t share) {
  fmpq_t across, up;
  fmpq_init(across);
  fmpq_init(up);
  tp_ratio_between(across, world->x + k, world->x + k + 1, share);
  tp_ratio_between(up, world->y + k, world->y + k + 1, share);
  tp_water_stand_depth(depth, stand, across, up);
  fmpq_clear(across);
  fmpq_clear(up);
}

bool tp_water_press(tp_wet_lines *lines, const tp_water_stand *stand, const tp_polyline *chain,
                    const tp_polyline *world, long k, const fmpq_t unit_kpa,
                    const fmpq *thickness) {
  const fmpq *const from[2] = {chain->x + k, chain->y + k};
  const fmpq *const to[2] = {chain->x + k + 1, chain->y + k + 1};
  const int way = fmpq_cmp(world->x + k + 1, world->x + k);
  const long bends = stand->surface == NULL || way == 0 ? 0 : stand->surface->count;
  stretch s;
  fmpq_t reached;
  stretch_init(&s);
  fmpq_init(reached);
  bool done = true;
  for (long b = 0; b <= bends && done; b++) { /* the last stretch ends with the edge */
    fmpq_set(s.from, reached);
    fmpq_one(s.to);
    if (b < bends) {
      share_below(s.to, stand->surface->x + (way > 0 ? b : bends - 1 - b), world->x + k,
                  world->x + k + 1);
      if (fmpq_cmp(s.to, reached) <= 0 || fmpq_cmp_si(s.to, 1) >= 0) continue;
    }
    fmpq_set(reached, s.to);
    set_depth(s.first, stand, world, k, s.from);
    set_depth(s.last, stand, world, k, s.to);
    done = press(lines, &s, from, to, unit_kpa, thickness);
  }
  fmpq_clear(reached);
  stretch_clear(&s);
  return done;
}
