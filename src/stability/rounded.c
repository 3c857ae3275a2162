/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Points of a rounded outline in balls (docs/mechanics.md section 4; Appendix B).
 *
 * The contact ends at the tangent points (base/facets_cut.c), and a block turns about them: the
 * axis at a rounded toe is the tangent point on the facet up-dip of it. */

#include "stability/evaluation.h"

#include <math.h>

void tp_evaluation_place(arb_t x, arb_t y, const tp_evaluation *e, tp_outline_point at) {
  const tp_lattice *l = &e->problem->lattice;
  if (at.cut == NULL) {
    arb_set_fmpz(x, l->x + at.point);
    arb_set_fmpz(y, l->y + at.point);
    return;
  }
  tp_corner_ball c;
  tp_corner_ball_init(&c);
  tp_corner_evaluate(&c, at.cut, l, e->rung.bits);
  arb_set(x, at.after ? c.after.x : c.before.x);
  arb_set(y, at.after ? c.after.y : c.before.y);
  tp_corner_ball_clear(&c);
}

void tp_evaluation_axis(arb_t x, arb_t y, const tp_evaluation *e, long k) {
  tp_evaluation_place(x, y, e, tp_contact_place(e->problem->contact.points + k));
}

void tp_evaluation_place_metres(tp_bounded *x_m, tp_bounded *y_m, tp_evaluation *e,
                                tp_outline_point at) {
  const tp_lattice *l = &e->problem->lattice;
  if (at.cut == NULL) {
    *x_m = tp_evaluation_x(e->problem, at.point);
    *y_m = tp_evaluation_y(e->problem, at.point);
    return;
  }
  arb_t x, y, step;
  arb_init(x);
  arb_init(y);
  arb_init(step);
  tp_evaluation_place(x, y, e, at);
  arb_set_fmpq(step, l->step_m, e->rung.bits);
  arb_add_fmpz(x, x, l->origin_x, e->rung.bits);
  arb_add_fmpz(y, y, l->origin_y, e->rung.bits);
  arb_mul(x, x, step, e->rung.bits);
  arb_mul(y, y, step, e->rung.bits);
  const double log2_size = (double)l->bits + log2(fmpq_get_d(l->step_m));
  *x_m = tp_evaluation_result_scaled(e, x, log2_size);
  *y_m = tp_evaluation_result_scaled(e, y, log2_size);
  arb_clear(x);
  arb_clear(y);
  arb_clear(step);
}

void tp_evaluation_facet(arb_t dx, arb_t dy, const tp_evaluation *e, const tp_facet *facet) {
  arb_t x, y;
  arb_init(x);
  arb_init(y);
  tp_evaluation_place(x, y, e, tp_facet_begin(facet));
  tp_evaluation_place(dx, dy, e, tp_facet_end(facet));
  arb_sub(dx, dx, x, e->rung.bits);
  arb_sub(dy, dy, y, e->rung.bits);
  arb_clear(x);
  arb_clear(y);
}
