/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Interval of tan(tilt) of a mode in doubles with error bounds, from A + B tan(alpha) >= 0 over the
 * planes through pairs of its generators (docs/mechanics.md section 6a). */

#include "motion/mode_filter.h"

#include "number/ball.h"

enum { MOST_GENERATORS = 12, MOST_PLANES = MOST_GENERATORS * (MOST_GENERATORS - 1) / 2 };

/* Exact zeros, which most are, stay so. */
static tp_near near_of(const arb_t ball) {
  return arb_is_zero(ball) ? (tp_near){.error = 0} : tp_ball_near(ball);
}

static bool turns_with_tilt(const tp_trig *f) {
  return arb_is_zero(f->of + TP_ONE) && arb_is_zero(f->of + TP_SEC) && arb_is_zero(f->of + TP_SEC2);
}

void tp_mode_filter_init(tp_mode_filter *f, const tp_motion_question *q) {
  const tp_trig *loads[3] = {&q->load.x, &q->load.y, &q->load.moment};
  *f = (tp_mode_filter){.applies = q->strong == NULL};
  for (int row = 0; row < 3; row++) {
    f->applies = f->applies && turns_with_tilt(loads[row]);
    f->down[row] = near_of(loads[row]->of + TP_COS);
    f->across[row] = near_of(loads[row]->of + TP_SIN);
  }
  f->scale = near_of(q->scale);
  f->x = near_of(q->x);
  f->y = near_of(q->y);
  f->gyration = near_of(q->gyration);
  f->friction = near_of(q->cones->friction);
}

/* M r, as in motion/newton.h. */
static bool set_inertia(tp_near own[3], const tp_mode_filter *f, const tp_ray *ray) {
  tp_near a[3];
  if (!tp_normals_set_near(a, ray->near)) return false;
  tp_near_inertia(own, a, &f->scale, &f->x, &f->y, &f->gyration, ray->axis < 0);
  return true;
}

/* -e: the force n +- t tan(phi) at its point, turned round. */
static void set_force(tp_near own[3], const tp_mode_filter *f, const tp_normals *n, long point,
                      bool against) {
  const tp_near tx = tp_near_whole(tp_normals_tx(n, point)),
                ty = tp_near_whole(tp_normals_ty(n, point));
  const bool has_own = tp_cones_own(n->cones, point) != 0;
  const tp_near friction = has_own ? near_of(tp_cones_friction(n->cones, point)) : f->friction;
  tp_near x, y;
  tp_normals_place_near(&x, &y, n, point);
  x = tp_near_sub(tp_near_mul(x, f->scale), f->x);
  y = tp_near_sub(tp_near_mul(y, f->scale), f->y);
  tp_near_cone_edge(own, &tx, &ty, &friction, against);
  tp_near_moment(own, &x, &y);
  tp_near_reverse(own);
}

/* k^2 M^-1 h of a normal line. */
static bool set_normal(tp_near own[3], const tp_mode_filter *f, const tp_normal *normal) {
  tp_near h[3];
  if (!tp_normals_set_near(h, normal->near)) return false;
  tp_near_response(own, h, &f->scale, &f->x, &f->y, &f->gyration);
  return true;
}

static tp_near work_of(const tp_near h[3], const tp_near load[3]) {
  tp_near sum = {.error = 0};
  for (int row = 0; row < 3; row++) {
    if (!tp_near_is_zero(load[row])) sum = tp_near_add(sum, tp_near_mul(h[row], load[row]));
  }
  return sum;
}

/* A plane, and the tangent of the tilt from which, `lower`, or up to which it lets a mode begin. */
typedef struct plane {
  long first, second, beside;
  bool below;
  tp_source source;
  bool lower;
  tp_near tangent;
} plane;

/* From h with all of the cone on its side; `turned`: on the other. False where open. */
static bool set_tangent(plane *p, const tp_mode_filter *f, const tp_near h[3], bool turned) {
  const tp_near level = work_of(h, f->down), rise = work_of(h, f->across);
  const int sign = tp_near_sign(rise);
  if (sign == 0) return false;
  p->lower = (sign > 0) != turned;
  p->tangent = tp_near_neg(tp_near_div(level, rise));
  return isfinite(p->tangent.error) != 0;
}

/* The last of the lower ends, the first of the upper ones. */
typedef struct ends {
  bool has[2]; /* by `lower` */
  plane of[2];
} ends;

/* False where their order is open. */
static bool tighten(ends *e, const plane *p) {
  plane *own = e->of + p->lower;
  if (!e->has[p->lower]) {
    e->has[p->lower] = true;
    *own = *p;
    return true;
  }
  if (tp_source_is_same(&own->source, &p->source)) return true; /* one tilt */
  const int order = tp_near_sign(tp_near_sub(p->tangent, own->tangent));
  if (order != 0 && (order > 0) == p->lower) *own = *p;
  return order != 0;
}

static tp_mode_tilts between(const ends *e) {
  if (!e->has[0] || !e->has[1]) return TP_TILTS_BETWEEN;
  if (tp_source_is_same(&e->of[0].source, &e->of[1].source)) return TP_TILTS_OPEN;
  const int order = tp_near_sign(tp_near_sub(e->of[0].tangent, e->of[1].tangent));
  return order == 0 ? TP_TILTS_OPEN : order > 0 ? TP_TILTS_BETWEEN : TP_TILTS_NONE;
}

/* Is the plane at the lower end, or at the upper one? */
static bool is_at(const ends *e, const tp_source *source, bool lower) {
  return e->has[lower] && tp_source_is_same(&e->of[lower].source, source);
}

static bool choose(tp_chosen_planes *chosen, const plane *own) {
  const int k = chosen->count;
  if (k == TP_MOST_CHOSEN) return false;
  chosen->first[k] = own->first;
  chosen->second[k] = own->second;
  chosen->lower[k] = own->lower;
  chosen->below[k] = own->below;
  chosen->beside[k] = own->beside;
  chosen->count++;
  return true;
}

/* What is known of a cone. */
typedef struct cone {
  const tp_mode_filter *filter;
  const tp_generators *of;
  long size; /* of the generators */
  tp_near near[MOST_GENERATORS][3];
  long count;
  plane planes[MOST_PLANES];
} cone;

/* Takes the plane of two generators if all others lie on one side of it; false where open. */
static bool try_pair(cone *c, long i, long j) {
  const tp_generators *g = c->of;
  plane *own = c->planes + c->count;
  *own = (plane){.first = i, .second = j};
  own->source = tp_generators_source(g, g->items + i, g->items + j);
  tp_near h[3];
  tp_near_cross(h, c->near[i], c->near[j]);
  bool above = false, below = false;
  for (long k = 0; k < c->size; k++) {
    if (k == i || k == j || tp_generator_is_in_plane(g->items + k, &own->source)) continue;
    const int sign = tp_near_sign(tp_near_dot(h, c->near[k]));
    if (sign == 0) return false;
    above = above || sign > 0;
    below = below || sign < 0;
    own->beside = k;
  }
  own->below = below;
  if (above && below) return true;
  c->count++;
  return (above || below) && set_tangent(own, c->filter, h, below);
}

static bool set_cone(cone *c, const tp_twists *twists) {
  const tp_generators *g = c->of;
  const tp_mode *mode = g->mode;
  if (!c->filter->applies || g->count > MOST_GENERATORS) return false;
  c->size = g->count;
  for (long k = 0; k < c->size; k++) {
    if (k >= mode->ray_count) {
      const tp_cone_edge *edge = mode->edges + (k - mode->ray_count);
      set_force(c->near[k], c->filter, g->n, edge->point, edge->against);
    } else if (!set_inertia(c->near[k], c->filter, twists->rays + mode->rays[k])) {
      return false;
    }
  }
  for (long i = 0; i < c->size; i++) {
    for (long j = i + 1; j < c->size; j++) {
      if (!try_pair(c, i, j)) return false;
    }
  }
  return c->count > 0;
}

tp_mode_tilts tp_mode_filter_pairs(tp_chosen_planes *chosen, const tp_mode_filter *f,
                                   const tp_generators *g, const tp_twists *twists) {
  cone c;
  c.filter = f;
  c.of = g;
  c.size = c.count = 0;
  ends e = {.has = {false, false}};
  chosen->count = 0;
  if (!set_cone(&c, twists)) return TP_TILTS_OPEN;
  for (long k = 0; k < c.count; k++) {
    if (!tighten(&e, c.planes + k)) return TP_TILTS_OPEN;
  }
  const tp_mode_tilts tilts = between(&e);
  for (long k = 0; k < c.count && tilts == TP_TILTS_BETWEEN; k++) {
    const plane *own = c.planes + k;
    if (is_at(&e, &own->source, own->lower) && !choose(chosen, own)) return TP_TILTS_OPEN;
  }
  return tilts;
}

tp_mode_tilts tp_mode_filter_interior(tp_chosen_planes *chosen, const tp_mode_filter *f,
                                      const tp_motion_question *q, const tp_normals *n,
                                      const tp_twists *twists) {
  ends e = {.has = {false, false}};
  chosen->count = 0;
  if (!f->applies) return TP_TILTS_OPEN;
  for (long k = 0; k < twists->face_count; k++) {
    plane own = {.source = tp_generators_normal_source(q, n, NULL, twists->faces[k].normal)};
    tp_near h[3];
    if (!set_normal(h, f, n->items + twists->faces[k].normal) || !set_tangent(&own, f, h, false) ||
        !tighten(&e, &own)) {
      return TP_TILTS_OPEN;
    }
  }
  const tp_mode_tilts tilts = between(&e);
  for (long k = 0; k < twists->face_count && tilts == TP_TILTS_BETWEEN; k++) {
    const tp_source own = tp_generators_normal_source(q, n, NULL, twists->faces[k].normal);
    const bool lower = is_at(&e, &own, true);
    if ((lower || is_at(&e, &own, false)) &&
        !choose(chosen, &(plane){.first = k, .lower = lower})) {
      return TP_TILTS_OPEN;
    }
  }
  return tilts;
}
