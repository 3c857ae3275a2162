/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Every twist that two normal lines can bound is tried: a slide along a facet, a turn about a
 * point, and what the lines of two points on facets of different directions have in common, either
 * way. It is a ray where each other point opens, h . r > 0 for certain; where one does not for
 * certain, it is none. A turn about a point of one line alone cuts the face on that line, on either
 * side of which the point slips in another sense (motion/strata.h).
 *
 * All facets run up-dip, so that lifting opens all points: K has an interior. On the line of a face
 * stand its two ends, and between them at most the turn about the line's point. */

#include "case_filter/near_plan.h"

typedef struct planning {
  tp_contact_plan *plan;
  tp_case_shape *shape;
  int same[TP_PLAN_POINTS]; /* the first at the same site on a parallel facet */
} planning;

/* ---- rays --------------------------------------------------------------------------------------
 */

static bool is_on_line(const planning *p, int k, long point) {
  return p->same[k] == p->same[point];
}

/* Does a point stay on its facet by what the ray is made of? */
static bool stays(const planning *p, const tp_plan_ray *ray, int k) {
  const tp_plan_point *points = p->plan->points;
  switch (ray->kind) {
  case TP_RAY_SLIDES:
    return points[k].axis == points[ray->point].axis;
  case TP_RAY_TURNS:
    return points[k].site == points[ray->point].site;
  case TP_RAY_LINES:
    return is_on_line(p, k, ray->point) || is_on_line(p, k, ray->other);
  }
  return false;
}

/* In which sense all other points open, for certain: 1 or -1; 0: in none; 2: open. */
static int sense_of(const planning *p, const tp_near twist[3], const tp_plan_ray *ray) {
  int sense = 0;
  bool open = false;
  for (int k = 0; k < p->plan->point_count; k++) {
    if (stays(p, ray, k)) continue;
    const int sign = tp_near_sign(tp_near_dot(twist, p->shape->points[k].normal));
    if (sign != 0 && sense == -sign) return 0;
    if (sign != 0) sense = sign;
    open = open || sign == 0;
  }
  return open ? 2 : sense;
}

static bool add_ray(planning *p, tp_plan_ray ray, const tp_near twist[3], int sense) {
  tp_contact_plan *plan = p->plan;
  if (plan->ray_count == TP_PLAN_RAYS) return false;
  tp_near own[3] = {twist[0], twist[1], twist[2]};
  if (sense < 0) tp_sparse_reverse(own);
  ray.sense = sense;
  for (int k = 0; k < plan->point_count; k++) {
    const bool closed = stays(p, &ray, k), sticks = closed && ray.kind == TP_RAY_TURNS;
    ray.opens[k] = (signed char)!closed;
    ray.slips[k] = 0;
    if (!closed || sticks) continue;
    ray.slips[k] = (signed char)tp_near_sign(tp_sparse_dot(own, p->shape->points[k].slip));
    if (ray.slips[k] == 0) return false;
  }
  tp_shape_set_inertia(p->shape, plan->ray_count, own);
  plan->rays[plan->ray_count++] = ray;
  return true;
}

/* Either sense, or both where nothing opens: along the one direction of all facets. */
static bool try_ray(planning *p, tp_plan_ray ray) {
  tp_near twist[3];
  ray.sense = 1;
  tp_shape_ray(twist, p->shape, &ray);
  const int sense = sense_of(p, twist, &ray);
  if (sense == 2) return false;
  if (sense != 0) return add_ray(p, ray, twist, sense);
  bool alone = true;
  for (int k = 0; k < p->plan->point_count; k++) alone = alone && stays(p, &ray, k);
  return !alone || (add_ray(p, ray, twist, 1) && add_ray(p, ray, twist, -1));
}

/* The first point with the same site, or the same axis? */
static bool is_first(const planning *p, int k, bool of_axis) {
  const tp_plan_point *points = p->plan->points;
  for (int before = 0; before < k; before++) {
    if (of_axis ? points[before].axis == points[k].axis : points[before].site == points[k].site) {
      return false;
    }
  }
  return true;
}

static bool try_pairs(planning *p, int k) {
  const tp_plan_point *points = p->plan->points;
  bool done = p->same[k] == k;
  for (int other = 0; other < k && done; other++) {
    if (p->same[other] != other || points[other].site == points[k].site ||
        points[other].axis == points[k].axis) {
      continue;
    }
    done = try_ray(p, (tp_plan_ray){.kind = TP_RAY_LINES, .point = other, .other = k});
  }
  return done || p->same[k] != k;
}

/* As two points that follow one another in a ring have it. */
static bool add_shared(planning *p, int one, int other) {
  const tp_plan_point *points = p->plan->points;
  const int count = p->plan->ray_count, low = one < other ? one : other;
  tp_plan_ray ray = {.kind = TP_RAY_LINES, .point = low, .other = one + other - low};
  if (points[one].axis == points[other].axis) {
    ray = (tp_plan_ray){.kind = TP_RAY_SLIDES, .point = low};
  } else if (points[one].site == points[other].site) {
    ray = (tp_plan_ray){.kind = TP_RAY_TURNS, .point = low};
  }
  return try_ray(p, ray) && p->plan->ray_count == count + 1;
}

/* The cone of motions of normals that all point up has no line in it, and its rays are a closed
 * ring. Beside them turns about the ends of the contact, where one facet ends alone. */
static bool find_rays_of_ring(planning *p, const int *ring, int ring_count, long last_site) {
  bool done = ring_count >= 3;
  for (int k = 0; k < ring_count && done; k++) {
    done = add_shared(p, ring[k], ring[(k + 1) % ring_count]);
  }
  for (int k = 0; k < p->plan->point_count && done; k++) {
    const long site = p->plan->points[k].site;
    if (site != 0 && site != last_site) continue;
    done = try_ray(p, (tp_plan_ray){.kind = TP_RAY_TURNS, .point = k});
  }
  return done;
}

static bool find_rays(planning *p) {
  bool done = true;
  for (int k = 0; k < p->plan->point_count && done; k++) {
    if (is_first(p, k, true)) done = try_ray(p, (tp_plan_ray){.kind = TP_RAY_SLIDES, .point = k});
    if (done && is_first(p, k, false)) {
      done = try_ray(p, (tp_plan_ray){.kind = TP_RAY_TURNS, .point = k});
    }
    done = done && try_pairs(p, k);
  }
  return done;
}

/* ---- modes -------------------------------------------------------------------------------------
 */

static tp_plan_mode *add_mode(planning *p, tp_mechanism mechanism, int ray_count) {
  tp_contact_plan *plan = p->plan;
  if (plan->mode_count == TP_PLAN_MODES) return NULL;
  tp_plan_mode *own = plan->modes + plan->mode_count++;
  own->mechanism = mechanism;
  own->ray_count = ray_count;
  own->edge_count = own->triple_count = 0;
  return own;
}

/* Friction acts against the slip; where it sticks, either way. */
static bool add_edges(tp_plan_mode *mode, long point, int slip) {
  for (int against = 0; against < 2; against++) {
    if (against != 0 ? slip < 0 : slip > 0) continue;
    if (mode->edge_count == TP_PLAN_EDGES) return false;
    mode->edges[mode->edge_count++] = (tp_cone_edge){point, against != 0};
  }
  return true;
}

/* Of one ray: all points that stay. */
static bool add_ray_mode(planning *p, int k) {
  static const tp_mechanism of[] = {[TP_RAY_SLIDES] = TP_SLIDES,
                                    [TP_RAY_TURNS] = TP_TOPPLES,
                                    [TP_RAY_LINES] = TP_SLIDES_AND_TOPPLES};
  const tp_plan_ray *ray = p->plan->rays + k;
  tp_plan_mode *mode = add_mode(p, of[ray->kind], 1);
  if (mode == NULL) return false;
  mode->rays[0] = mode->rays[1] = k;
  mode->line = 0;
  for (int point = 0; point < p->plan->point_count; point++) {
    if (ray->opens[point] != 0 || p->same[point] != point) continue;
    if (!add_edges(mode, point, ray->slips[point])) return false;
  }
  return tp_plan_mode_set_triples(mode, p->plan);
}

/* Between two rays on the line of a point. */
static bool add_sector(planning *p, int point, int from, int to) {
  const tp_plan_ray *rays = p->plan->rays;
  const int slip = rays[from].slips[point] != 0 ? rays[from].slips[point] : rays[to].slips[point];
  tp_plan_mode *mode = slip == 0 ? NULL : add_mode(p, TP_SLIDES_AND_TOPPLES, 2);
  if (mode == NULL) return false;
  mode->rays[0] = from;
  mode->rays[1] = to;
  mode->line = point;
  return add_edges(mode, point, slip) && tp_plan_mode_set_triples(mode, p->plan);
}

/* Has the site of a point one line alone? */
static bool is_of_one_line(const planning *p, int point) {
  for (int k = 0; k < p->plan->point_count; k++) {
    if (p->plan->points[k].site == p->plan->points[point].site && p->same[k] != point) return false;
  }
  return true;
}

/* The face on the line of a point, if there is one. */
static bool add_face(planning *p, int point) {
  const tp_contact_plan *plan = p->plan;
  int ends[2], count = 0, middle = -1;
  for (int k = 0; k < plan->ray_count; k++) {
    const tp_plan_ray *ray = plan->rays + k;
    if (ray->opens[point] != 0) continue;
    const bool turns = ray->kind == TP_RAY_TURNS && is_of_one_line(p, point);
    if (turns ? middle >= 0 : count == 2) return false;
    if (turns) middle = k;
    if (!turns) ends[count++] = k;
  }
  const bool line = count == 2 && plan->rays[ends[0]].kind == TP_RAY_SLIDES &&
                    plan->rays[ends[1]].kind == TP_RAY_SLIDES; /* there and back */
  if (count < 2 || (line && middle < 0)) return middle < 0;
  if (middle < 0) return add_sector(p, point, ends[0], ends[1]);
  return add_sector(p, point, ends[0], middle) && add_sector(p, point, middle, ends[1]);
}

/* ---- all of it ---------------------------------------------------------------------------------
 */

static void find_same(planning *p) {
  const tp_plan_point *points = p->plan->points;
  for (int k = 0; k < p->plan->point_count; k++) {
    p->same[k] = k;
    for (int before = k - 1; before >= 0; before--) {
      const bool parallel = points[before].axis == points[k].axis;
      if (parallel && points[before].site == points[k].site) p->same[k] = p->same[before];
    }
  }
}

/* Two points of parallel facets at different sites share a line where they lie across from each
 * other: that is told for no contact that a filter takes. */
static bool lines_differ(const planning *p) {
  const tp_plan_point *points = p->plan->points;
  for (int k = 0; k < p->plan->point_count; k++) {
    for (int before = 0; before < k; before++) {
      if (points[before].axis != points[k].axis || p->same[before] == p->same[k]) continue;
      const tp_shape_point *a = p->shape->points + before, *b = p->shape->points + k;
      const tp_near apart = tp_near_plus(tp_near_times(tp_near_minus(b->x, a->x), b->tx),
                                         tp_near_times(tp_near_minus(b->y, a->y), b->ty));
      if (tp_near_sign(apart) == 0) return false;
    }
  }
  return true;
}

static bool begin(planning *p, tp_contact_plan *plan, tp_case_shape *shape) {
  *p = (planning){.plan = plan, .shape = shape};
  plan->ray_count = plan->mode_count = plan->edge_count = 0;
  plan->opens_all = true;
  find_same(p);
  return lines_differ(p);
}

/* Edges and modes, when the rays are known. */
static bool find_modes(planning *p) {
  tp_contact_plan *plan = p->plan;
  for (int k = 0; k < plan->point_count; k++) {
    if (p->same[k] != k) continue;
    plan->edges[plan->edge_count++] = (tp_cone_edge){k, false};
    plan->edges[plan->edge_count++] = (tp_cone_edge){k, true};
  }
  bool done = true;
  for (int k = 0; k < plan->ray_count && done; k++) done = add_ray_mode(p, k);
  for (int k = 0; k < plan->point_count && done; k++) {
    if (p->same[k] == k) done = add_face(p, k);
  }
  return done;
}

bool tp_near_plan_find(tp_contact_plan *plan, tp_case_shape *shape) {
  planning p;
  return begin(&p, plan, shape) && find_rays(&p) && find_modes(&p);
}

bool tp_near_plan_find_ring(tp_contact_plan *plan, tp_case_shape *shape, const int *ring,
                            int ring_count, long last_site) {
  planning p;
  return begin(&p, plan, shape) && find_rays_of_ring(&p, ring, ring_count, last_site) &&
         find_modes(&p);
}
