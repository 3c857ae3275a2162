/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What a rounded toe does beyond its critical angle (docs/mechanics.md section 4).
 *
 * The block rolls on the arc, on the plane of its facet. With n the facet's normal and q = G - C,
 * from the centre of curvature to the centroid, both in the world, the weight's arm about the
 * contact is q_x + r n_x. Turned by t it is |q| cos(p + t) + r n_x, p the direction of q; it grows
 * with t where the centroid lies below the centre: then the block rolls to a new rest, at t =
 * -acos(-r n_x / |q|) - p, unless the arc, of pi - theta, ends before, or the plane does, which is
 * as long as the base goes straight on past the tangent point, or there is no such t. Otherwise it
 * goes over. */

#include "evaluation/stages.h"

#include "number/ball.h"

/* The centre of curvature C and the centroid G, x mirrored towards the right, and the normal of the
 * facet up-dip of the corner. */
typedef struct roller {
  arb_t qx, qy; /* G - C in the block's frame */
  arb_t nx, ny;
  arb_t radius, arc; /* of the corner, lattice units; pi - theta, or where the plane ends before */
} roller;

/* What the block rolls on: an arc that begins in the toe, and the rock that goes straight on below
 * it.
 */
typedef struct rolling {
  const tp_corner *corner;
  tp_outline_point toe;
  long end; /* of the rock's straight piece, a point of the lattice */
  bool left;
} rolling;

/* The corner whose arc begins in a contact point, down-dip; NULL where there is none. Its tangent
 * point may be a vertex of the outline or of the profile. */
static const tp_corner *corner_at(const tp_problem *problem, const tp_contact_point *toe,
                                  bool left) {
  const tp_outline_point end = tp_contact_end_on_outline(toe, left);
  if (end.cut != NULL) return end.after == left ? end.cut : NULL;
  const long count = problem->lattice.start[1], facet = left ? toe->right : toe->left;
  long vertex = -1;
  if (facet >= 0) {
    const tp_facet *f = problem->contact.facets + facet;
    vertex = left ? f->t0 : f->t1;
  }
  const tp_corner *corner = vertex >= 0 ? tp_corners_at(&problem->corners, vertex) : NULL;
  if (corner == NULL && toe->point < count) { /* nothing is left of the edge before it */
    corner = tp_corners_at(&problem->corners, (toe->point + (left ? count - 1 : 1)) % count);
  }
  if (corner == NULL) return NULL;
  const long edge_end = left ? corner->after : corner->before;
  const bool on_edge = tp_lattice_cross(&problem->lattice, corner->vertex, edge_end, corner->vertex,
                                        toe->point) == 0;
  return on_edge && tp_tangent_compare(corner, left, &problem->lattice, toe->point) == 0 ? corner
                                                                                         : NULL;
}

/* Find the edge of the profile on the line of the corner's edge that goes on past the toe, and
 * where those straight on from it end; false where the rock does not go on. */
static bool find_plane(rolling *r, const tp_problem *problem) {
  const tp_lattice *l = &problem->lattice;
  const long ring = l->start[problem->section.ring_count], last = ring + problem->base.edge_count;
  const long t0 = r->left ? r->corner->vertex : r->corner->before;
  const long t1 = r->left ? r->corner->after : r->corner->vertex;
  for (long from = ring; from < last; from++) {
    if (tp_lattice_cross(l, t0, t1, t0, from) != 0 ||
        tp_lattice_cross(l, t0, t1, t0, from + 1) != 0) {
      continue;
    }
    const tp_outline_point begin = {.point = from}, end = {.point = from + 1};
    const int before = tp_outline_point_along(l, r->toe, begin, t0, t1);
    const int after = tp_outline_point_along(l, r->toe, end, t0, t1);
    if (r->left ? before >= 0 || after < 0 : after <= 0 || before > 0) continue;
    const long step = r->left ? -1 : 1, stop = r->left ? ring : last;
    r->end = r->left ? from : from + 1;
    while (r->end != stop && tp_lattice_cross(l, r->end - 1, r->end, r->end, r->end + 1) == 0) {
      r->end += step;
    }
    return true;
  }
  return false;
}

/* By how much it may turn before the plane ends: its length over the radius. */
static void set_plane(arb_t turns, const tp_evaluation *e, const rolling *on) {
  const tp_lattice *l = &e->problem->lattice;
  const long bits = e->rung.bits;
  arb_t x, y, radius;
  arb_init(x);
  arb_init(y);
  arb_init(radius);
  tp_evaluation_point(x, y, e, on->toe);
  arb_sub_fmpz(x, x, l->x + on->end, bits);
  arb_sub_fmpz(y, y, l->y + on->end, bits);
  arb_hypot(turns, x, y, bits);
  arb_set_fmpq(radius, on->corner->radius, bits);
  arb_div(turns, turns, radius, bits);
  arb_clear(x);
  arb_clear(y);
  arb_clear(radius);
}

static void roller_init(roller *r, const tp_evaluation *e, const rolling *on) {
  const tp_corner *corner = on->corner;
  const bool left = on->left;
  const long bits = e->rung.bits;
  const arb_struct *sums = e->moments.weighted;
  tp_corner_ball c;
  tp_corner_ball_init(&c);
  tp_corner_evaluate(&c, corner, &e->problem->lattice, bits);
  arb_struct *const all[] = {r->qx, r->qy, r->nx, r->ny, r->radius, r->arc};
  for (size_t k = 0; k < sizeof all / sizeof all[0]; k++) arb_init(all[k]);
  arb_div(r->qx, sums + TP_X6, sums + TP_A2, bits);
  arb_div_ui(r->qx, r->qx, 3, bits);
  arb_sub(r->qx, r->qx, c.centre.x, bits);
  arb_div(r->qy, sums + TP_Y6, sums + TP_A2, bits);
  arb_div_ui(r->qy, r->qy, 3, bits);
  arb_sub(r->qy, r->qy, c.centre.y, bits);
  /* from the tangent point to the centre */
  const tp_ball_point *tangent = left ? &c.after : &c.before;
  arb_sub(r->nx, c.centre.x, tangent->x, bits);
  arb_sub(r->ny, c.centre.y, tangent->y, bits);
  arb_div(r->nx, r->nx, c.radius, bits);
  arb_div(r->ny, r->ny, c.radius, bits);
  if (!left) {
    arb_neg(r->qx, r->qx);
    arb_neg(r->nx, r->nx);
  }
  arb_set(r->radius, c.radius);
  arb_inv(r->arc, c.half_tangent, bits);
  arb_atan(r->arc, r->arc, bits);
  arb_mul_2exp_si(r->arc, r->arc, 1);
  arb_t plane;
  arb_init(plane);
  set_plane(plane, e, on);
  arb_min(r->arc, r->arc, plane, bits);
  arb_clear(plane);
  tp_corner_ball_clear(&c);
}

static void roller_clear(roller *r) {
  arb_struct *const all[] = {r->qx, r->qy, r->nx, r->ny, r->radius, r->arc};
  for (size_t k = 0; k < sizeof all / sizeof all[0]; k++) arb_clear(all[k]);
}

/* (x, y) turned by the tilt. */
static void turn(arb_t x, arb_t y, const arb_t sine, const arb_t cosine, long bits) {
  arb_t held;
  arb_init(held);
  arb_mul(held, x, cosine, bits);
  arb_submul(held, y, sine, bits);
  arb_mul(y, y, cosine, bits);
  arb_addmul(y, x, sine, bits);
  arb_swap(x, held);
  arb_clear(held);
}

/* Does it roll to a rest at the tilt; turned by how much (radians)? */
static bool find_rest(arb_t turned, roller *r, const tp_evaluation *e, const arb_t sine,
                      const arb_t cosine, tp_certainty *certainty) {
  const long bits = e->rung.bits;
  arb_t size, share, direction, one;
  arb_init(size);
  arb_init(share);
  arb_init(direction);
  arb_init(one);
  arb_one(one);
  turn(r->qx, r->qy, sine, cosine, bits);
  turn(r->nx, r->ny, sine, cosine, bits);
  arb_hypot(size, r->qx, r->qy, bits);
  arb_mul(share, r->nx, r->radius, bits);
  arb_neg(share, share);
  arb_div(share, share, size, bits);
  bool rests = arb_is_negative(r->qy) && arb_lt(share, one);
  if (rests) {
    arb_acos(turned, share, bits);
    arb_atan2(direction, r->qy, r->qx, bits);
    arb_add(turned, turned, direction, bits);
    arb_neg(turned, turned);
    rests = arb_le(turned, r->arc);
    if (!rests && !arb_gt(turned, r->arc)) certainty->open = true;
  } else if (arb_contains_zero(r->qy) || !(arb_is_positive(r->qy) || arb_gt(share, one))) {
    certainty->open = true;
  }
  arb_clear(size);
  arb_clear(share);
  arb_clear(direction);
  arb_clear(one);
  return rests;
}

/* At the scene's tilt, where it lies beyond the critical angle. */
static void rest_at_tilt(const tp_evaluation *e, tp_case *result, const rolling *on,
                         tp_certainty *certainty) {
  const tp_quantity *tilt = &e->problem->scene->tilt_angle_deg;
  const long bits = e->rung.bits;
  roller r;
  arb_t sine, cosine, turned, pi;
  arb_init(sine);
  arb_init(cosine);
  arb_init(turned);
  arb_init(pi);
  roller_init(&r, e, on);
  tp_ball_sin_cos_degrees(sine, cosine, tilt->value, bits);
  result->rests = find_rest(turned, &r, e, sine, cosine, certainty);
  result->rolls = result->rests ? TP_ROLLS_BACK : TP_ROLLS_OVER;
  if (result->rests) {
    arb_const_pi(pi, bits);
    arb_div(turned, turned, pi, bits);
    arb_mul_ui(turned, turned, 180, bits);
    result->rest_turn_deg = tp_result(e, turned, certainty);
  }
  roller_clear(&r);
  arb_clear(sine);
  arb_clear(cosine);
  arb_clear(turned);
  arb_clear(pi);
}

/* At the critical angle itself, whose direction is that of the lever arms: back if the centroid
 * lies below the centre. */
static void roll_from_limit(const tp_evaluation *e, tp_case *result, const rolling *on,
                            const tp_direction_ball *toppling, tp_certainty *certainty) {
  roller r;
  roller_init(&r, e, on);
  turn(r.qx, r.qy, toppling->sine, toppling->cosine, e->rung.bits);
  result->rolls = arb_is_negative(r.qy) ? TP_ROLLS_BACK : TP_ROLLS_OVER;
  if (arb_contains_zero(r.qy)) certainty->open = true;
  roller_clear(&r);
}

void tp_evaluate_rolling(const tp_evaluation *e, tp_case *result, const tp_direction_ball *toppling,
                         tp_certainty *certainty) {
  const tp_problem *problem = e->problem;
  const tp_quantity *tilt = &problem->scene->tilt_angle_deg;
  result->rolls = TP_ROLLS_NOT;
  result->rests = false;
  if (!result->has_toppling_pivot || e->loaded != NULL) return;
  const bool left = result->towards == TP_TOWARDS_LEFT;
  const tp_contact_point *toe =
      problem->contact.points + result->pivots[result->toppling_pivot].index;
  rolling on = {.corner = corner_at(problem, toe, left), .left = left};
  on.toe = tp_contact_on_outline(toe);
  if (on.corner == NULL || !find_plane(&on, problem)) return;
  arb_t angle;
  arb_init(angle);
  arb_set_fmpq(angle, tilt->value, e->rung.bits);
  if (tilt->given && arb_gt(angle, toppling->degrees)) {
    rest_at_tilt(e, result, &on, certainty);
  } else {
    roll_from_limit(e, result, &on, toppling, certainty);
  }
  arb_clear(angle);
}
