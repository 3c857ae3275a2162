/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* One sample of an outline map in doubles with bounds: vertices from their affine functions, the
 * signs that keep the contact, and area, centroid and radius of gyration (docs/mechanics.md section
 * 2). */

#include "case_filter/outline_map.h"

#include "block/ring_sums.h"

static tp_near value_of(const tp_near_affine *f, const tp_near *variables, int count) {
  tp_near sum = f->of[0];
  for (int k = 0; k < count; k++) {
    const bool is_one = f->of[k + 1].value == 1 && f->of[k + 1].error == 0; /* no rounding */
    const tp_near own = is_one ? variables[k] : tp_near_times(f->of[k + 1], variables[k]);
    sum = tp_near_plus(sum, own);
  }
  return sum;
}

void tp_outline_map_first(tp_near *x, tp_near *y, const tp_outline_map *map,
                          const tp_near *variables) {
  *x = value_of(&map->first_x, variables, map->variable_count);
  *y = value_of(&map->first_y, variables, map->variable_count);
}

static tp_near turn(const tp_near_outline *o, int a, int b, int c) {
  const tp_near ux = tp_near_minus(o->x[b], o->x[a]), uy = tp_near_minus(o->y[b], o->y[a]);
  const tp_near vx = tp_near_minus(o->x[c], o->x[a]), vy = tp_near_minus(o->y[c], o->y[a]);
  return tp_near_minus(tp_near_times(ux, vy), tp_near_times(uy, vx));
}

static tp_near along(const tp_near_outline *o, int p, int q, int from, int to) {
  const tp_near dx = tp_near_minus(o->x[q], o->x[p]), dy = tp_near_minus(o->y[q], o->y[p]);
  const tp_near tx = tp_near_minus(o->x[to], o->x[from]), ty = tp_near_minus(o->y[to], o->y[from]);
  return tp_near_plus(tp_near_times(dx, tx), tp_near_times(dy, ty));
}

static tp_near signed_value(const tp_near_outline *o, const tp_map_sign *s) {
  const int a = s->of[0], b = s->of[1];
  const tp_near dx = tp_near_minus(o->x[a], o->x[b]), dy = tp_near_minus(o->y[a], o->y[b]);
  switch (s->kind) {
  case TP_SIGN_X:
    return dx;
  case TP_SIGN_Y:
    return dy;
  case TP_SIGN_SUM:
    return tp_near_plus(dx, dy);
  case TP_SIGN_DIFFERENCE:
    return tp_near_minus(dx, dy);
  case TP_SIGN_TURN:
    return turn(o, a, b, s->of[2]);
  case TP_SIGN_ALONG:
    break;
  }
  return along(o, a, b, s->of[2], s->of[3]);
}

#define NUMBER tp_near
#define COORDINATE tp_near
#define FUNCTION near_sums
#define PARAMETER
#define INIT(r) (void)(r)
#define CLEAR(r) (void)(r)
#define ZERO(r) (*(r) = (tp_near){0, 0})
#define SET_COORDINATE(r, a) (*(r) = *(a))
#define ADD(r, a, b) (*(r) = tp_near_plus(*(a), *(b)))
#define SUBTRACT(r, a, b) (*(r) = tp_near_minus(*(a), *(b)))
#define MULTIPLY(r, a, b) (*(r) = tp_near_times(*(a), *(b)))
#define ADD_PRODUCT(r, a, b) (*(r) = tp_near_plus(*(r), tp_near_times(*(a), *(b))))
#include "block/ring_sums_in.h"

/* The centroid from the first vertex of an outline that runs counter-clockwise, the area, and the
 * square of the radius of gyration about it. */
static bool set_centroid(tp_near *x, tp_near *y, tp_case_shape *shape, const tp_near_outline *o,
                         int count) {
  tp_near sums[TP_XY24];
  near_sums(sums, o->x, o->y, count, TP_XY24);
  if (tp_near_sign(sums[TP_A2]) <= 0) return false;
  const tp_near thrice = tp_near_mul(sums[TP_A2], (tp_near){3, 0});
  shape->area = tp_near_mul(sums[TP_A2], (tp_near){0.5, 0});
  *x = tp_near_div(sums[TP_X6], thrice);
  *y = tp_near_div(sums[TP_Y6], thrice);
  const tp_near polar =
      tp_near_div(tp_near_add(sums[TP_XX12], sums[TP_YY12]), tp_near_mul(thrice, (tp_near){2, 0}));
  shape->gyration = tp_near_sub(polar, tp_near_add(tp_near_mul(*x, *x), tp_near_mul(*y, *y)));
  return tp_near_sign(shape->gyration) > 0;
}

static void set_point(tp_shape_point *p, const tp_mapped_point *own, const tp_near_outline *o,
                      tp_near x, tp_near y, tp_direction towards) {
  static const tp_near zero = {0, 0}, one = {1, 0};
  p->x = tp_near_minus(o->x[own->vertex], x);
  p->y = tp_near_minus(o->y[own->vertex], y);
  p->tx = own->from < 0 ? one : tp_near_minus(o->x[own->to], o->x[own->from]);
  p->ty = own->is_level ? zero : tp_near_minus(o->y[own->to], o->y[own->from]);
  if (towards == TP_TOWARDS_LEFT) return; /* else up-dip is the other way along the facet */
  p->x = tp_near_neg(p->x);
  p->ty = tp_near_neg(p->ty);
}

bool tp_outline_map_shape(tp_case_shape *shape, tp_near_outline *o, const tp_outline_map *map,
                          const tp_contact_plan *plan, const tp_near *variables) {
  for (int k = 0; k < map->point_count; k++) {
    o->x[k] = value_of(map->x + k, variables, map->variable_count);
    o->y[k] = value_of(map->y + k, variables, map->variable_count);
  }
  for (int k = 0; k < map->sign_count; k++) {
    if (tp_near_sign(signed_value(o, map->signs + k)) != map->signs[k].sign) return false;
  }
  tp_near x, y;
  if (!set_centroid(&x, &y, shape, o, map->vertex_count)) return false;
  for (int k = 0; k < plan->point_count; k++) {
    set_point(shape->points + k, map->points + k, o, x, y, map->towards);
  }
  return true;
}
