/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Friction forces of the contacts that a ray or a sector of twists keeps closed; of parallel
 * contacts that slip only the two extreme moments are kept. */

#include "motion/closed.h"

#include "common/grow.h"
#include "number/ball.h"

#include <stdlib.h>
#include <string.h>

void tp_closed_clear(tp_closed *closed) {
  free(closed->edges);
  memset(closed, 0, sizeof *closed);
}

static bool add_edge(tp_closed *closed, long point, bool against) {
  tp_cone_edge *more = tp_grow(closed->edges, closed->edge_count, &closed->edge_room, sizeof *more);
  if (more == NULL) return false;
  closed->edges = more;
  closed->edges[closed->edge_count++] = (tp_cone_edge){point, against};
  return true;
}

/* Friction acts against the slip; without friction both edges are one. */
static tp_motion_outcome add_contact(tp_closed *closed, const tp_normals *n, long point, int slip) {
  if (slip == TP_OPEN_SIGN) return TP_MOTION_OPEN;
  if (!tp_cones_bears(n->cones, point, slip)) return TP_MOTION_PROVEN;
  const bool rough = !arb_is_zero(tp_cones_friction(n->cones, point));
  if (slip == 0) closed->sticks = true;
  bool done = true;
  if (slip <= 0 || !rough) done = add_edge(closed, point, false);
  if (slip >= 0 && rough) done = done && add_edge(closed, point, true);
  return done ? TP_MOTION_PROVEN : TP_MOTION_OUT_OF_MEMORY;
}

int tp_closed_slip(const tp_normals *n, long point, const tp_ray *ray) {
  if (ray->site >= 0 && ray->site == n->cones->points[point].site) return 0;
  return tp_normals_slip(n, point, &ray->twist, ray->near);
}

/* x f_y - y f_x of the force f = n +- t tan(phi) at a point. */
static void edge_moment(arb_t moment, const tp_normals *n, long point, bool against) {
  tp_vector force;
  tp_vector_init(&force);
  tp_normals_edge(&force, n, point, against);
  const arb_struct x = tp_cones_x(n->cones, point), y = tp_cones_y(n->cones, point);
  tp_ball_moment(force.of, &x, &y, n->judge.bits);
  arb_swap(moment, force.of + 2);
  tp_vector_clear(&force);
}

static tp_near near_moment(const tp_normals *n, long point, bool against) {
  const tp_cones *cones = n->cones;
  const tp_near tx = tp_near_whole(tp_normals_tx(n, point)),
                ty = tp_near_whole(tp_normals_ty(n, point));
  const tp_near friction = tp_ball_near(tp_cones_friction(cones, point));
  tp_near x, y;
  tp_normals_place_near(&x, &y, n, point);
  tp_near force[3];
  tp_near_cone_edge(force, &tx, &ty, &friction, against);
  tp_near_moment(force, &x, &y);
  return force[2];
}

/* Of the forces at two points of a family that slips, the sign of the first one's moment less the
 * other's, by doubles where they tell. */
static int compare_moments(const tp_normals *n, long point, long other, bool against) {
  const int told =
      tp_near_sign(tp_near_sub(near_moment(n, point, against), near_moment(n, other, against)));
  if (told != 0) return told;
  arb_t gap, most;
  arb_init(gap);
  arb_init(most);
  edge_moment(gap, n, point, against);
  edge_moment(most, n, other, against);
  arb_sub(gap, gap, most, n->judge.bits);
  const int sign = tp_judge_sign(&n->judge, gap, tp_ball_log2_above(most));
  arb_clear(gap);
  arb_clear(most);
  return sign;
}

/* Of points of one friction those with the least and the largest moment; first -1: none as yet. */
typedef struct moment_ends {
  long of[2];
} moment_ends;

static bool slips_against(const tp_normals *n, long point, int slip) {
  return slip > 0 && !arb_is_zero(tp_cones_friction(n->cones, point));
}

static tp_motion_outcome widen(moment_ends *ends, const tp_normals *n, long point, bool against) {
  if (ends->of[0] < 0) ends->of[0] = ends->of[1] = point;
  for (int e = 0; e < 2; e++) { /* 0: the least, 1: the largest */
    if (n->cones->points[point].site == n->cones->points[ends->of[e]].site) continue;
    const int sign = compare_moments(n, point, ends->of[e], against);
    if (sign == TP_OPEN_SIGN) return TP_MOTION_OPEN;
    if (sign == (e == 0 ? -1 : 1)) ends->of[e] = point;
  }
  return TP_MOTION_PROVEN;
}

/* Those of a friction; those beside facets, which lie elsewhere, by themselves: which of both kinds
 * has the largest moment may change with the strength of all. */
static moment_ends *ends_of(moment_ends *ends, const tp_cones *cones, long point) {
  const bool is_beside = point >= cones->count - cones->beside_count;
  return ends + tp_cones_own(cones, point) + (is_beside ? cones->own_count + 1 : 0);
}

/* Of a family that slips, all forces of one friction have one direction: the two with the least and
 * the largest moment. `ends`: for each friction, and for each beside facets. */
static tp_motion_outcome add_ends(tp_closed *closed, const tp_normals *n,
                                  const tp_contact_family *family, int slip, moment_ends *ends) {
  const tp_normal *last = n->items + family->first + family->count - 1;
  const long frictions = n->cones->own_count + 1;
  const long kinds = n->cones->beside_count > 0 ? 2 * frictions : frictions;
  for (long own = 0; own < kinds; own++) ends[own].of[0] = -1;
  for (long k = n->items[family->first].first; k < last->first + last->count; k++) {
    const long point = n->order[k];
    if (n->same[point] != point || !tp_cones_bears(n->cones, point, slip)) continue;
    const tp_motion_outcome done =
        widen(ends_of(ends, n->cones, point), n, point, slips_against(n, point, slip));
    if (done != TP_MOTION_PROVEN) return done;
  }
  for (long own = 0; own < kinds; own++) {
    const long *of = ends[own].of;
    if (of[0] < 0) continue;
    const bool against = slips_against(n, of[0], slip);
    if (!add_edge(closed, of[0], against) ||
        (of[0] != of[1] && !add_edge(closed, of[1], against))) {
      return TP_MOTION_OUT_OF_MEMORY;
    }
  }
  return TP_MOTION_PROVEN;
}

static tp_motion_outcome add_sliding(tp_closed *closed, const tp_normals *n,
                                     const tp_contact_family *family, int slip) {
  moment_ends one;
  if (n->cones->own_count == 0) return add_ends(closed, n, family, slip, &one);
  moment_ends *ends = calloc(2 * ((size_t)n->cones->own_count + 1), sizeof *ends);
  if (ends == NULL) return TP_MOTION_OUT_OF_MEMORY;
  const tp_motion_outcome done = add_ends(closed, n, family, slip, ends);
  free(ends);
  return done;
}

/* Those of one normal line, each point once. */
static tp_motion_outcome add_line(tp_closed *closed, const tp_normals *n, const tp_normal *line,
                                  const tp_ray *ray) {
  for (long k = line->first; k < line->first + line->count; k++) {
    const long point = n->order[k];
    if (n->same[point] != point) continue;
    const tp_motion_outcome done = add_contact(closed, n, point, tp_closed_slip(n, point, ray));
    if (done != TP_MOTION_PROVEN) return done;
  }
  return TP_MOTION_PROVEN;
}

static tp_motion_outcome add_family(tp_closed *closed, const tp_normals *n,
                                    const tp_contact_family *family, const tp_ray *ray) {
  if (ray->axis >= 0) {
    if (ray->axis != family->axis) return TP_MOTION_PROVEN;
    const int slip =
        tp_normals_slip(n, n->order[n->items[family->first].first], &ray->twist, ray->near);
    return slip == TP_OPEN_SIGN ? TP_MOTION_OPEN : add_sliding(closed, n, family, slip);
  }
  for (long k = 0; k < (family->count > 1 ? 2 : 1); k++) {
    const tp_normal *line = n->items + family->first + (k == 0 ? 0 : family->count - 1);
    const int sign = tp_normal_sign(n, line, &ray->twist, ray->near, ray->site);
    if (sign == TP_OPEN_SIGN) return TP_MOTION_OPEN;
    if (sign != 0) continue;
    const tp_motion_outcome done = add_line(closed, n, line, ray);
    if (done != TP_MOTION_PROVEN) return done;
  }
  return TP_MOTION_PROVEN;
}

/* Along an axis all lines of its families stay closed: those of t and of -t stand together. */
static tp_motion_outcome add_axis(tp_closed *closed, const tp_normals *n, long line,
                                  const tp_ray *ray) {
  long family = n->items[line].family;
  while (family > 0 && n->families[family - 1].axis == ray->axis) family--;
  tp_motion_outcome done = TP_MOTION_PROVEN;
  for (; family < n->family_count && done == TP_MOTION_PROVEN; family++) {
    if (n->families[family].axis != ray->axis) break;
    done = add_family(closed, n, n->families + family, ray);
  }
  return done;
}

tp_motion_outcome tp_closed_of_ray(tp_closed *closed, const tp_twists *twists, long ray,
                                   const tp_normals *n) {
  const tp_ray *own = twists->rays + ray;
  closed->edge_count = 0;
  closed->sticks = false;
  if (own->line_count > 0 && own->axis >= 0) {
    return add_axis(closed, n, twists->lines[own->first_line], own);
  }
  tp_motion_outcome done = TP_MOTION_PROVEN;
  for (long k = 0; k < own->line_count && done == TP_MOTION_PROVEN; k++) {
    done = add_line(closed, n, n->items + twists->lines[own->first_line + k], own);
  }
  for (long k = 0; k < n->family_count && done == TP_MOTION_PROVEN && own->line_count == 0; k++) {
    done = add_family(closed, n, n->families + k, own);
  }
  return done;
}

tp_mechanism tp_closed_mechanism(const tp_closed *closed, const tp_ray *ray) {
  if (ray->axis >= 0) return TP_SLIDES;
  return closed->sticks ? TP_TOPPLES : TP_SLIDES_AND_TOPPLES;
}

static int slip_between(const tp_normals *n, long point, const tp_ray *from, const tp_ray *to) {
  const int slip = tp_closed_slip(n, point, from);
  return slip != 0 ? slip : tp_closed_slip(n, point, to);
}

static tp_motion_outcome add_line_between(tp_closed *closed, const tp_normals *n, long line,
                                          const tp_ray *from, const tp_ray *to) {
  const tp_normal *own = n->items + line;
  for (long k = own->first; k < own->first + own->count; k++) {
    const long point = n->order[k];
    if (n->same[point] != point) continue;
    const tp_motion_outcome done = add_contact(closed, n, point, slip_between(n, point, from, to));
    if (done != TP_MOTION_PROVEN) return done;
  }
  return TP_MOTION_PROVEN;
}

/* On a face both rays lie on its line, and on one of the family with -t where K is flat. */
tp_motion_outcome tp_closed_of_sector(tp_closed *closed, const tp_ray *from, const tp_ray *to,
                                      long normal, const tp_normals *n) {
  closed->edge_count = 0;
  closed->sticks = false;
  tp_motion_outcome done = add_line_between(closed, n, normal, from, to);
  const long family = n->items[normal].family;
  for (long other = family - 1; other <= family + 1 && done == TP_MOTION_PROVEN; other += 2) {
    if (other < 0 || other >= n->family_count) continue;
    const tp_contact_family *own = n->families + other;
    if (own->axis != n->families[family].axis) continue;
    for (long k = own->first; k<own->first + own->count; k += own->count> 1 ? own->count - 1 : 1) {
      const tp_normal *line = n->items + k;
      const int a = tp_normal_sign(n, line, &from->twist, from->near, from->site);
      const int b = tp_normal_sign(n, line, &to->twist, to->near, to->site);
      if (a == TP_OPEN_SIGN || b == TP_OPEN_SIGN) return TP_MOTION_OPEN;
      if (a == 0 && b == 0) done = add_line_between(closed, n, k, from, to);
    }
  }
  return done;
}

int tp_closed_slip_in(const tp_normals *n, const tp_twists *twists, const tp_mode *mode,
                      long point) {
  int slip = 0;
  for (int k = 0; k < mode->ray_count && slip == 0; k++) {
    slip = tp_closed_slip(n, point, twists->rays + mode->rays[k]);
  }
  return slip;
}
