/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Points, edges, rays and modes of one exactly solved case written as a plan: each ray by the
 * points or lines that define it, with its signs at every contact point. */

#include "case_filter/contact_plan.h"

#include "motion/closed.h"
#include "onset/onset_question.h"

/* What is planned, and from what. */
typedef struct planning {
  tp_contact_plan *plan;
  const tp_normals *normals;
  const tp_twists *twists;
  bool fits;
  tp_motion_outcome outcome;
} planning;

static void set_points(planning *p) {
  const tp_normals *n = p->normals;
  for (int k = 0; k < p->plan->point_count; k++) {
    const tp_cone_point *own = n->cones->points + k;
    const tp_contact_family *family = n->families + n->family_of[k];
    p->plan->points[k] = (tp_plan_point){own->site, own->facet, family->axis, family->sense > 0};
  }
}

/* Both edges of each point; of points at one site on parallel facets, of one alone. */
static void set_edges(planning *p) {
  tp_contact_plan *plan = p->plan;
  for (int k = 0; k < plan->point_count; k++) {
    if (p->normals->same[k] != k) continue;
    plan->edges[plan->edge_count++] = (tp_cone_edge){k, false};
    plan->edges[plan->edge_count++] = (tp_cone_edge){k, true};
  }
}

/* ---- rays --------------------------------------------------------------------------------------
 */

/* The first point at the site, or on the axis. */
static long point_of(const planning *p, const tp_ray *ray) {
  for (int k = 0; k < p->plan->point_count; k++) {
    const tp_plan_point *own = p->plan->points + k;
    if (ray->site >= 0 ? own->site == ray->site : own->axis == ray->axis) return k;
  }
  return -1;
}

/* By what it is made of. */
static bool describe(tp_plan_ray *own, const planning *p, const tp_ray *ray) {
  const tp_normals *n = p->normals;
  if (ray->site < 0 && ray->axis < 0 && ray->line_count >= 2) {
    const long *lines = p->twists->lines + ray->first_line;
    own->kind = TP_RAY_LINES;
    own->point = n->order[n->items[lines[0]].first];
    own->other = n->order[n->items[lines[1]].first];
    return ray->line_count == 2; /* more would meet by chance */
  }
  own->kind = ray->site >= 0 ? TP_RAY_TURNS : TP_RAY_SLIDES;
  own->point = point_of(p, ray);
  return (ray->site >= 0 || ray->axis >= 0) && own->point >= 0;
}

/* Of the twist as it is described, without its sense: whether that is the ray or its opposite. */
static bool set_sense(tp_plan_ray *own, const planning *p, const tp_ray *ray) {
  const tp_normals *n = p->normals;
  const long bits = n->judge.bits;
  tp_vector first, second, made;
  arb_t same;
  tp_vector_init(&first);
  tp_vector_init(&second);
  tp_vector_init(&made);
  arb_init(same);
  if (own->kind == TP_RAY_SLIDES) {
    arb_set_fmpz(made.of, tp_normals_tx(n, own->point));
    arb_set_fmpz(made.of + 1, tp_normals_ty(n, own->point));
  } else if (own->kind == TP_RAY_TURNS) {
    arb_one(made.of + 2);
  } else {
    tp_normals_set_h(&first, n, n->normal_of[own->point]);
    tp_normals_set_h(&second, n, n->normal_of[own->other]);
    tp_vector_cross(&made, &first, &second, bits);
  }
  tp_vector_dot(same, &made, &ray->twist, bits);
  own->sense = arb_is_positive(same) ? 1 : -1;
  const bool told = !arb_contains_zero(same);
  tp_vector_clear(&first);
  tp_vector_clear(&second);
  tp_vector_clear(&made);
  arb_clear(same);
  return told;
}

/* Does a point stay on its facet by what the ray is made of? */
static bool stays(const planning *p, const tp_plan_ray *own, long point) {
  const tp_plan_point *points = p->plan->points;
  switch (own->kind) {
  case TP_RAY_SLIDES:
    return points[point].axis == points[own->point].axis;
  case TP_RAY_TURNS:
    return points[point].site == points[own->point].site;
  case TP_RAY_LINES:
    return p->normals->same[point] == p->normals->same[own->point] ||
           p->normals->same[point] == p->normals->same[own->other];
  }
  return false;
}

static bool set_signs(tp_plan_ray *own, const planning *p, const tp_ray *ray) {
  const tp_normals *n = p->normals;
  for (long k = 0; k < p->plan->point_count; k++) {
    const int sign =
        tp_normal_sign(n, n->items + n->normal_of[k], &ray->twist, ray->near, ray->site);
    if (sign == TP_OPEN_SIGN || (sign == 0) != stays(p, own, k)) return false;
    own->opens[k] = (signed char)sign;
    const int slip = sign == 0 ? tp_closed_slip(n, k, ray) : 0;
    if (slip == TP_OPEN_SIGN) return false;
    own->slips[k] = (signed char)slip;
  }
  return true;
}

/* Also those that were added for the modes. */
static void set_rays(planning *p) {
  const tp_twists *t = p->twists;
  p->fits = p->fits && t->ray_count <= TP_PLAN_RAYS;
  for (long k = 0; k < t->ray_count && p->fits; k++) {
    tp_plan_ray *own = p->plan->rays + p->plan->ray_count++;
    p->fits = describe(own, p, t->rays + k) && set_sense(own, p, t->rays + k) &&
              set_signs(own, p, t->rays + k);
  }
}

/* ---- modes -------------------------------------------------------------------------------------
 */

static bool add_edge(tp_plan_mode *mode, long point, bool against) {
  if (mode->edge_count == TP_PLAN_EDGES) return false;
  mode->edges[mode->edge_count++] = (tp_cone_edge){point, against};
  return true;
}

/* Which points of a facet's axis press hardest on which side depends on the friction: all of them
 * are taken, each with the edge against its slip. */
static bool take_sliding(tp_plan_mode *own, const planning *p, const tp_mode *mode) {
  const tp_ray *ray = p->twists->rays + mode->rays[0];
  const tp_normals *n = p->normals;
  for (long k = 0; k < p->plan->point_count; k++) {
    if (p->plan->points[k].axis != ray->axis || n->same[k] != k) continue;
    const int slip = tp_closed_slip(n, k, ray);
    if (slip != 1 && slip != -1) return false;
    if (!add_edge(own, k, slip > 0)) return false;
  }
  return true;
}

static bool take_edges(tp_plan_mode *own, const planning *p, const tp_mode *mode) {
  if (tp_mode_slides(mode, p->twists)) return take_sliding(own, p, mode);
  for (long k = 0; k < mode->edge_count; k++) {
    if (!add_edge(own, mode->edges[k].point, mode->edges[k].against)) return false;
  }
  return true;
}

/* Are three edges in one plane by where they stand, or by where they point? */
static bool are_flat(const tp_contact_plan *plan, const tp_plan_mode *mode, const int of[3]) {
  bool site = true, direction = true;
  const tp_cone_edge *first = mode->edges + of[0] - mode->ray_count;
  for (int k = 1; k < 3; k++) {
    const tp_cone_edge *own = mode->edges + of[k] - mode->ray_count;
    const tp_plan_point *a = plan->points + first->point, *b = plan->points + own->point;
    site = site && a->site == b->site;
    /* where facets of one axis point to either side, one's edge against t is the other's along */
    direction =
        direction && a->axis == b->axis && (a->along == b->along && first->against == own->against);
  }
  return site || direction;
}

bool tp_plan_mode_set_triples(tp_plan_mode *mode, const tp_contact_plan *plan) {
  const int rays = mode->ray_count, count = rays + mode->edge_count;
  for (int i = 0; i < count; i++) {
    for (int j = i + 1; j < count; j++) {
      for (int k = j + 1; k < count; k++) {
        if (i >= rays && are_flat(plan, mode, (int[3]){i, j, k})) continue;
        if (mode->triple_count == TP_PLAN_TRIPLES) return false;
        mode->triples[mode->triple_count++] = (tp_plan_triple){
            {(unsigned char)i, (unsigned char)j, (unsigned char)k}, i == 0 && (rays < 2 || j == 1)};
      }
    }
  }
  return mode->triple_count > 0;
}

static tp_motion_outcome take_mode(void *context, const tp_mode *mode) {
  planning *p = context;
  const tp_normals *n = p->normals;
  tp_contact_plan *plan = p->plan;
  if (mode->ray_count == 0) {
    plan->opens_all = true;
    return TP_MOTION_PROVEN;
  }
  if (!p->fits || plan->mode_count == TP_PLAN_MODES) {
    p->fits = false;
    return TP_MOTION_PROVEN;
  }
  tp_plan_mode *own = plan->modes + plan->mode_count++;
  *own = (tp_plan_mode){.mechanism = mode->mechanism,
                        .ray_count = mode->ray_count,
                        .rays = {mode->rays[0], mode->rays[1]}};
  if (mode->ray_count == 2) own->line = n->order[n->items[mode->normal].first];
  p->fits = take_edges(own, p, mode) && tp_plan_mode_set_triples(own, plan);
  return TP_MOTION_PROVEN;
}

/* ---- all of it ---------------------------------------------------------------------------------
 */

/* Rays of modes are added while these are visited. */
static void plan_motions(planning *p, const tp_normals *normals) {
  tp_twists twists;
  p->normals = normals;
  p->twists = &twists;
  p->outcome = tp_twists_init(&twists, normals, NULL);
  if (p->outcome != TP_MOTION_PROVEN) return;
  p->fits = !twists.everything;
  set_points(p);
  set_edges(p);
  if (p->fits) p->outcome = tp_strata_visit(&twists, normals, false, take_mode, p);
  if (p->outcome == TP_MOTION_PROVEN && p->fits) set_rays(p);
  tp_twists_clear(&twists);
}

tp_status tp_contact_plan_init(tp_contact_plan *plan, bool *fits, const tp_evaluation *e,
                               tp_direction towards, tp_message *message) {
  tp_onset_asked asked;
  *plan = (tp_contact_plan){.point_count = 0};
  *fits = false;
  if (!tp_onset_asked_init(&asked, e, towards, NULL)) return tp_fail_memory(message, "the contact");
  planning p = {.plan = plan, .outcome = TP_MOTION_OPEN};
  if (asked.cones.count >= 2 && asked.cones.count <= TP_PLAN_POINTS) {
    tp_normals normals;
    plan->point_count = (int)asked.cones.count;
    arb_one(asked.cones.friction); /* any but none: the modes are the same */
    p.outcome = tp_normals_init(&normals, &asked.cones, &asked.question.judge);
    if (p.outcome == TP_MOTION_PROVEN) {
      plan_motions(&p, &normals);
      tp_normals_clear(&normals);
    }
  }
  tp_onset_asked_clear(&asked);
  if (p.outcome == TP_MOTION_OUT_OF_MEMORY) return tp_fail_memory(message, "the contact");
  *fits = p.outcome == TP_MOTION_PROVEN && p.fits;
  return TP_OK;
}
