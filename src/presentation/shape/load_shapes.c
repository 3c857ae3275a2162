/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Points of loads rounded and put among those of the blocks; a level of water as a line far past
 * them. */

#include "shape/load_shapes.h"

#include "block_system/resultant.h"
#include "common/message.h"
#include "scene/anchor.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

typedef struct placing {
  tp_load_shapes *loads;
  const tp_block_shapes *blocks;
  const tp_scene *scene;
} placing;

static double metres_of(const placing *p, const fmpq_t length) {
  return fmpq_get_d(length) * fmpq_get_d(p->scene->metres_per_unit);
}

static tp_spot spot_at(const placing *p, double x_m, double y_m) {
  const tp_block_shapes *b = p->blocks;
  return (tp_spot){(x_m - b->origin_m.x) / b->unit_m, (y_m - b->origin_m.y) / b->unit_m};
}

static tp_spot spot_of(const placing *p, const fmpq_t x, const fmpq_t y) {
  return spot_at(p, metres_of(p, x), metres_of(p, y));
}

/* ---- loads -------------------------------------------------------------------------------------
 */

static void add_lines(const placing *p, const tp_line_load *lines, long count,
                      tp_load_shape_kind kind) {
  for (long k = 0; k < count; k++) {
    const tp_line_load *line = lines + k;
    p->loads->items[p->loads->count++] =
        (tp_load_shape){.kind = kind,
                        .at = spot_of(p, line->x0.value, line->y0.value),
                        .to = spot_of(p, line->x1.value, line->y1.value),
                        .first = fmpq_get_d(line->first_kpa.value),
                        .last = fmpq_get_d(line->last_kpa.value)};
  }
}

static tp_spot direction_of(const placing *p, const tp_anchor_description *anchor) {
  const double radian = atan(1) / 45;
  if (anchor->to_x.given) {
    const tp_spot from = spot_of(p, anchor->x.value, anchor->y.value);
    const tp_spot to = spot_of(p, anchor->to_x.value, anchor->to_y.value);
    const double length = hypot(to.x - from.x, to.y - from.y);
    return (tp_spot){(to.x - from.x) / length, (to.y - from.y) / length};
  }
  fmpq_t degrees;
  fmpq_init(degrees);
  tp_anchor_direction(degrees, p->scene, anchor);
  const double angle = fmpq_get_d(degrees) * radian;
  fmpq_clear(degrees);
  return (tp_spot){cos(angle), sin(angle)};
}

static double length_of(const placing *p, const tp_anchor_description *anchor) {
  if (!anchor->to_x.given) return metres_of(p, anchor->length.value) / p->blocks->unit_m;
  const tp_spot from = spot_of(p, anchor->x.value, anchor->y.value);
  const tp_spot to = spot_of(p, anchor->to_x.value, anchor->to_y.value);
  return hypot(to.x - from.x, to.y - from.y);
}

static void add_rows(const placing *p, const tp_anchor_description *anchor,
                     tp_load_shape_kind kind) {
  const tp_spot along = direction_of(p, anchor);
  const double length = length_of(p, anchor);
  fmpq_t x, y;
  fmpq_init(x);
  fmpq_init(y);
  for (long row = 0; row < tp_anchor_rows(anchor); row++) {
    tp_anchor_point(x, y, anchor, row);
    const tp_spot at = spot_of(p, x, y);
    p->loads->items[p->loads->count++] =
        (tp_load_shape){.kind = kind,
                        .at = at,
                        .to = {at.x + length * along.x, at.y + length * along.y},
                        .ends = length > 0,
                        .along = along};
  }
  fmpq_clear(x);
  fmpq_clear(y);
}

static size_t count_of(const tp_loads_description *d) {
  long count = d->pressure_count + d->surcharge_count + d->support_count + d->force_count;
  for (long k = 0; k < d->anchor_count; k++) count += tp_anchor_rows(d->anchors + k);
  return (size_t)count;
}

static bool add_all(const placing *p) {
  const tp_loads_description *d = &p->scene->loads;
  p->loads->items = calloc(count_of(d) + 1, sizeof *p->loads->items);
  if (p->loads->items == NULL) return false;
  add_lines(p, d->pressures, d->pressure_count, TP_LOAD_PRESSES);
  add_lines(p, d->supports, d->support_count, TP_LOAD_PRESSES);
  add_lines(p, d->surcharges, d->surcharge_count, TP_LOAD_WEIGHS);
  for (long k = 0; k < d->anchor_count; k++) add_rows(p, d->anchors + k, TP_LOAD_PULLS);
  for (long k = 0; k < d->force_count; k++) add_rows(p, d->forces + k, TP_LOAD_PUSHES);
  return true;
}

/* ---- water -------------------------------------------------------------------------------------
 */

static bool add_surface(const placing *p) {
  const tp_polyline *surface = &p->scene->loads.water.surface;
  bool done = true;
  for (long k = 0; k < surface->count && done; k++) {
    done = tp_chain_add(&p->loads->water, k == 0 ? TP_STEP_JUMP : TP_STEP_LINE,
                        spot_of(p, surface->x + k, surface->y + k));
  }
  return done;
}

/* Level where all is tilted to a side, at a height over the origin. */
static bool add_level(const placing *p, bool left) {
  static const double past = 3; /* units */
  const double radian = atan(1) / 45, level = metres_of(p, p->scene->loads.water.level.value);
  fmpq_t degrees;
  fmpq_init(degrees);
  tp_scene_side_tilt(degrees, p->scene, left);
  const double angle = (left ? 1 : -1) * fmpq_get_d(degrees) * radian;
  fmpq_clear(degrees);
  const tp_spot up = {sin(angle), cos(angle)};
  const tp_spot on = spot_at(p, level * up.x, level * up.y);
  const tp_box *box = &p->blocks->box;
  const double middle =
      ((box->x0 + box->x1) / 2 - on.x) * up.y - ((box->y0 + box->y1) / 2 - on.y) * up.x;
  const double from = middle - past, to = middle + past;
  return tp_chain_add(&p->loads->water, TP_STEP_JUMP,
                      (tp_spot){on.x + from * up.y, on.y - from * up.x}) &&
         tp_chain_add(&p->loads->water, TP_STEP_LINE,
                      (tp_spot){on.x + to * up.y, on.y - to * up.x});
}

tp_status tp_load_shapes_init(tp_load_shapes *loads, const tp_block_shapes *blocks,
                              const tp_scene *scene, bool left, tp_message *message) {
  memset(loads, 0, sizeof *loads);
  const placing p = {loads, blocks, scene};
  const tp_water_description *water = &scene->loads.water;
  bool done = add_all(&p);
  if (done && water->surface.count > 0) {
    done = add_surface(&p);
  } else if (done && water->given) {
    done = add_level(&p, left);
  }
  if (done) return TP_OK;
  tp_load_shapes_clear(loads);
  return tp_fail_memory(message, "the figure");
}

void tp_load_shapes_clear(tp_load_shapes *loads) {
  free(loads->items);
  tp_chain_clear(&loads->water);
  memset(loads, 0, sizeof *loads);
}
