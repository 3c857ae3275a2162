/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Turning about rounded corners (mechanics section 4; Appendix B).
 *
 * The axis is the tangent point on the edge up-dip of the corner, and the contact begins there. */

#include "stability/evaluation.h"

#include "number/ball.h"

#include <stdlib.h>

static void set_point(arb_t x, arb_t y, const tp_lattice *l, long point) {
  arb_set_fmpz(x, l->x + point);
  arb_set_fmpz(y, l->y + point);
}

/* A point of the contact, or the tangent point of the corner there on one side of it. */
static void contact_end(arb_t x, arb_t y, const tp_evaluation *e, long point, bool right) {
  const tp_problem *problem = e->problem;
  const tp_corner *corner = tp_corners_find(&problem->corners, &problem->lattice, point);
  if (corner == NULL) {
    set_point(x, y, &problem->lattice, point);
    return;
  }
  tp_corner_ball c;
  tp_corner_ball_init(&c);
  tp_corner_evaluate(&c, corner, &problem->lattice, e->rung.bits);
  /* counter-clockwise, the edge after a vertex of the underside lies to its right */
  arb_set(x, right ? c.after.x : c.before.x);
  arb_set(y, right ? c.after.y : c.before.y);
  tp_corner_ball_clear(&c);
}

void tp_evaluation_axis(arb_t x, arb_t y, const tp_evaluation *e, long point,
                        tp_direction towards) {
  contact_end(x, y, e, point, towards == TP_TOWARDS_LEFT);
}

/* Sign of (q - p) . t for the direction t of a facet; 0 where it is not known. */
static int side(const tp_evaluation *e, const tp_facet *facet, arb_srcptr px, arb_srcptr py,
                arb_srcptr qx, arb_srcptr qy) {
  const tp_lattice *l = &e->problem->lattice;
  const long bits = e->rung.bits;
  fmpz_t t;
  arb_t dot, d;
  fmpz_init(t);
  arb_init(dot);
  arb_init(d);
  fmpz_sub(t, l->x + facet->t1, l->x + facet->t0);
  arb_sub(d, qx, px, bits);
  arb_mul_fmpz(dot, d, t, bits);
  fmpz_sub(t, l->y + facet->t1, l->y + facet->t0);
  arb_sub(d, qy, py, bits);
  arb_addmul_fmpz(dot, d, t, bits);
  const int sign = arb_is_positive(dot) ? 1 : arb_is_negative(dot) ? -1 : 0;
  fmpz_clear(t);
  arb_clear(dot);
  arb_clear(d);
  return sign;
}

void tp_evaluation_contact_loss(arb_t along_facets, arb_t along_plane, const tp_evaluation *e) {
  const tp_problem *problem = e->problem;
  tp_corner_ball c;
  arb_t projected;
  tp_corner_ball_init(&c);
  arb_init(projected);
  arb_zero(along_facets);
  arb_zero(along_plane);
  for (long k = 0; k < problem->contact.point_count; k++) {
    const tp_contact_point *p = problem->contact.points + k;
    const tp_corner *corner = tp_corners_find(&problem->corners, &problem->lattice, p->point);
    if (corner == NULL) continue;
    tp_corner_evaluate(&c, corner, &problem->lattice, e->rung.bits);
    for (int right = 0; right < 2; right++) {
      if ((right ? p->right : p->left) < 0) continue;
      arb_sub_fmpz(projected, right ? c.after.x : c.before.x, problem->lattice.x + p->point,
                   e->rung.bits);
      arb_abs(projected, projected);
      arb_add(along_plane, along_plane, projected, e->rung.bits);
      arb_add(along_facets, along_facets, c.length, e->rung.bits);
    }
  }
  tp_corner_ball_clear(&c);
  arb_clear(projected);
}

/* Ends of all facets where rounding leaves them: towards the left those up-dip of them do not
 * matter. */
typedef struct ends {
  arb_ptr x, y;
} ends;

static void ends_init(ends *own, const tp_evaluation *e, tp_direction towards) {
  const tp_contact *contact = &e->problem->contact;
  const bool left = towards == TP_TOWARDS_LEFT;
  own->x = _arb_vec_init(contact->facet_count);
  own->y = _arb_vec_init(contact->facet_count);
  for (long k = 0; k < contact->facet_count; k++) {
    const tp_facet *f = contact->facets + k;
    contact_end(own->x + k, own->y + k, e, left ? f->q0 : f->q1, left);
  }
}

static void ends_clear(ends *own, long count) {
  _arb_vec_clear(own->x, count);
  _arb_vec_clear(own->y, count);
}

/* Does turning about the k-th contact point open every facet? A facet that begins in the axis does;
 * where a sign is not known the evaluation is not certain. */
static bool opens_all(tp_evaluation *e, const ends *own, const tp_contact_point *p,
                      tp_direction towards) {
  const tp_contact *contact = &e->problem->contact;
  const tp_lattice *l = &e->problem->lattice;
  const bool left = towards == TP_TOWARDS_LEFT;
  arb_t x, y;
  arb_init(x);
  arb_init(y);
  tp_evaluation_axis(x, y, e, p->point, towards);
  bool open = true;
  for (long k = 0; k < contact->facet_count && open; k++) {
    const tp_facet *f = contact->facets + k;
    if (tp_facet_same_point(l, left ? f->q0 : f->q1, p->point)) continue;
    const int sign =
        left ? side(e, f, x, y, own->x + k, own->y + k) : side(e, f, own->x + k, own->y + k, x, y);
    if (sign == 0 && tp_corners_find(&e->problem->corners, l, p->point) == NULL &&
        tp_facet_side(l, f, left ? p->point : f->q1, left ? f->q0 : p->point) == 0) {
      continue; /* exactly level with it, sharp corners both */
    }
    if (sign == 0) e->certain = false;
    open = sign > 0;
  }
  arb_clear(x);
  arb_clear(y);
  return open;
}

void tp_evaluate_admissible(tp_evaluation *e, bool *admissible, tp_direction towards) {
  const tp_contact *contact = &e->problem->contact;
  const bool left = towards == TP_TOWARDS_LEFT;
  ends own;
  ends_init(&own, e, towards);
  for (long k = 0; k < contact->point_count; k++) {
    const tp_contact_point *p = contact->points + k;
    const bool presses = (left ? p->left : p->right) >= 0; /* its own facet down */
    admissible[k] = !presses && opens_all(e, &own, p, towards);
  }
  ends_clear(&own, contact->facet_count);
}
