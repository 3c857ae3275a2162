/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A polygon of points that are held, and the nearest of the lines that motions draw. */

#include "solid_tilt/least_way.h"

#include "solid/azimuth.h"

#include <math.h>
#include <string.h>

enum { FIRST_POINTS = 12, MOST_POINTS = 96 };

/* Held at any t is as good as held up to this one: farther than any that is the least. */
static const double endless = 1e6;

static void set_way(tp_hold_load *way, const tp_level_loads *loads, const tp_hold_frame *frame,
                    const fmpq_t azimuth) {
  if (loads->tilted != NULL) {
    tp_hold_frame_shake(way, frame, loads->tilted, azimuth);
  } else {
    tp_hold_frame_way(way, frame, azimuth);
  }
}

static void set_axis(tp_hold_load *way, const tp_level_loads *loads, const tp_hold_frame *frame,
                     slong azimuth_deg) {
  fmpq_t azimuth;
  fmpq_init(azimuth);
  fmpq_set_si(azimuth, azimuth_deg, 1);
  set_way(way, loads, frame, azimuth);
  fmpq_clear(azimuth);
}

void tp_level_loads_init(tp_level_loads *loads, const tp_hold_frame *frame,
                         const tp_scene *tilted) {
  loads->tilted = tilted;
  tp_hold_load_init(&loads->load);
  tp_hold_load_init(&loads->east);
  tp_hold_load_init(&loads->north);
  if (tilted != NULL) {
    tp_hold_frame_weight(&loads->load, frame, tilted);
  } else {
    tp_hold_frame_axis(&loads->load, frame, 2, true);
  }
  set_axis(&loads->east, loads, frame, 90);
  set_axis(&loads->north, loads, frame, 0);
}

void tp_level_loads_clear(tp_level_loads *loads) {
  tp_hold_load_clear(&loads->load);
  tp_hold_load_clear(&loads->east);
  tp_hold_load_clear(&loads->north);
}

bool tp_level_limit(tp_hold_limit *limit, tp_hold *hold, const tp_level_loads *loads,
                    const tp_hold_frame *frame, double azimuth_deg) {
  tp_hold_load way;
  fmpq_t azimuth;
  fmpq_init(azimuth);
  tp_hold_double(azimuth, azimuth_deg);
  tp_hold_load_init(&way);
  set_way(&way, loads, frame, azimuth);
  const bool done = tp_hold_limit_find(limit, hold, &loads->load, &way);
  tp_hold_load_clear(&way);
  fmpq_clear(azimuth);
  return done;
}

/* ---- the polygon -------------------------------------------------------------------------------
 */

typedef struct corner {
  double azimuth_deg;
  tp_near east, north; /* held */
} corner;

typedef struct polygon {
  tp_hold *hold;
  const tp_level_loads *loads;
  const tp_hold_frame *frame;
  tp_least_way *least;
  long count;
  corner corners[MOST_POINTS];
} polygon;

/* The line of a motion: no t beyond what it gains on the load over what it does on the way. */
static void take_line(polygon *p, const tp_hold_limit *limit) {
  const tp_near own = tp_near_neg(tp_hold_gain(limit->twist, &p->loads->load));
  const tp_near east = tp_hold_gain(limit->twist, &p->loads->east);
  const tp_near north = tp_hold_gain(limit->twist, &p->loads->north);
  const tp_near reach = tp_near_div(own, tp_near_length(east, north));
  tp_least_way *least = p->least;
  if (!(reach.value + reach.error < least->t.value + least->t.error)) return;
  const tp_bounded azimuth = tp_azimuth_of(east, north);
  least->t = reach;
  least->azimuth_deg = azimuth.value;
  least->azimuth_error = azimuth.error;
  memcpy(least->twist, limit->twist, sizeof least->twist);
}

static bool add_corner(polygon *p, double azimuth_deg) {
  tp_hold_limit limit;
  if (!tp_level_limit(&limit, p->hold, p->loads, p->frame, azimuth_deg)) return false;
  p->least->is_known = p->least->is_known && !limit.is_open;
  if (!p->least->is_known) return true;
  tp_near east, north;
  const double held = limit.is_endless ? endless : limit.t.value - limit.t.error;
  tp_azimuth_direction(&east, &north, azimuth_deg);
  long at = p->count++;
  for (; at > 0 && p->corners[at - 1].azimuth_deg > azimuth_deg; at--) {
    p->corners[at] = p->corners[at - 1];
  }
  p->corners[at] = (corner){azimuth_deg, tp_near_times(east, (tp_near){held, 0}),
                            tp_near_times(north, (tp_near){held, 0})};
  if (!limit.is_endless) take_line(p, &limit);
  return true;
}

/* How far the foot lies within the line of a side, and towards which azimuth. */
static tp_near side_distance(double *azimuth_deg, const polygon *p, long from, long to) {
  const corner *a = p->corners + from, *b = p->corners + to;
  const tp_near east = tp_near_sub(b->east, a->east), north = tp_near_sub(b->north, a->north);
  const tp_near area = tp_near_sub(tp_near_mul(a->north, b->east), tp_near_mul(a->east, b->north));
  const tp_near length = tp_near_length(east, north);
  const double end = b->azimuth_deg + (to <= from ? 360 : 0);
  const double share =
      fmax(0.05, fmin(0.95, -(a->east.value * east.value + a->north.value * north.value) /
                                (length.value * length.value)));
  *azimuth_deg = fmod(a->azimuth_deg + share * (end - a->azimuth_deg), 360);
  return tp_near_div(area, length);
}

/* Is the second of three corners within the line of the others? */
static bool is_within(const corner *a, const corner *b, const corner *c) {
  const double east = b->east.value - a->east.value, north = b->north.value - a->north.value;
  return north * (c->east.value - b->east.value) <= east * (c->north.value - b->north.value);
}

/* The convex hull of the corners, which is held as well: limits of azimuths close to each other
 * differ by their bounds, and the line of a side between them could run anywhere. */
static long find_hull(long hull[MOST_POINTS], const polygon *p) {
  long count = p->count, at = 0;
  for (long k = 0; k < count; k++) hull[k] = k;
  for (long convex = 0; convex < count && count > 3;) {
    const long before = hull[(at + count - 1) % count], after = hull[(at + 1) % count];
    if (is_within(p->corners + before, p->corners + hull[at], p->corners + after)) {
      for (long k = at; k + 1 < count; k++) hull[k] = hull[k + 1];
      count--;
      at = (at + count - 1) % count;
      convex = 0;
    } else {
      at = (at + 1) % count;
      convex++;
    }
  }
  return count;
}

/* The least of all sides, at most, and where to look next. */
static double inner_bound(double *azimuth_deg, const polygon *p) {
  double least = INFINITY;
  long hull[MOST_POINTS];
  const long count = find_hull(hull, p);
  for (long k = 0; k < count; k++) {
    double own;
    const tp_near distance = side_distance(&own, p, hull[k], hull[(k + 1) % count]);
    const double low = isfinite(distance.error) ? distance.value - distance.error : 0;
    if (low >= least) continue;
    least = low;
    *azimuth_deg = own;
  }
  return fmax(0, least);
}

bool tp_least_way_find(tp_least_way *least, tp_hold *hold, const tp_level_loads *loads,
                       const tp_hold_frame *frame) {
  static const double close = 1e-9;
  polygon p = {.hold = hold, .loads = loads, .frame = frame, .least = least};
  *least = (tp_least_way){.is_known = true, .t = {INFINITY, 0}};
  for (int k = 0; k < FIRST_POINTS && least->is_known; k++) {
    if (!add_corner(&p, 360.0 * k / FIRST_POINTS)) return false;
  }
  double inner = 0, next = 0;
  while (least->is_known) {
    inner = inner_bound(&next, &p);
    const double outer = least->t.value + least->t.error;
    if (p.count == MOST_POINTS || outer - inner <= close * outer) break;
    if (!add_corner(&p, next)) return false;
  }
  least->is_endless = least->is_known && !isfinite(least->t.value);
  if (!least->is_known || least->is_endless) return true;
  const double outer = least->t.value + least->t.error, middle = inner + (outer - inner) / 2;
  least->t = tp_near_of(middle, (outer - inner) / 2 + outer * DBL_EPSILON);
  return true;
}
