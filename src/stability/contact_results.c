/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The contact: where it begins and ends, its length, its steepest facet, the weight on it. */

#include "base/mean_plane.h"
#include "stability/evaluation.h"

#include "number/ball.h"

#include <float.h>
#include <math.h>

/* Sum of the lengths of the facets in balls, in lattice units. */
static void contact_length_ball(tp_evaluation *e, arb_t length) {
  arb_t dx, dy;
  arb_init(dx);
  arb_init(dy);
  arb_zero(length);
  for (long k = 0; k < e->problem->contact.facet_count; k++) {
    tp_evaluation_facet(dx, dy, e, e->problem->contact.facets + k);
    arb_hypot(dx, dx, dy, e->rung.bits);
    arb_add(length, length, dx, e->rung.bits);
  }
  arb_clear(dx);
  arb_clear(dy);
}

/* The same in double, for exact coordinates: differences (1 rounding each), squares, sum, root make
 * at most 3.1 unit roundoffs for each length; two levels of summation add at most 1024 + n / 1024
 * more to a sum of positive terms. */
static void contact_length_double(tp_evaluation *e, arb_t length) {
  const tp_lattice *l = &e->problem->lattice;
  const long count = e->problem->contact.facet_count;
  double total = 0;
  for (long from = 0; from < count; from += 1024) {
    double part = 0;
    for (long k = from; k < count && k < from + 1024; k++) {
      const tp_facet *f = e->problem->contact.facets + k;
      const double dx = l->u[f->q1] - l->u[f->q0], dy = l->v[f->q1] - l->v[f->q0];
      part += sqrt(dx * dx + dy * dy);
    }
    total += part;
  }
  const long parts = count / 1024;
  const double roundings = 1030 + (double)parts;
  tp_ball_set_bounded(length, total, 1.01 * roundings * DBL_EPSILON / 2 * total);
}

/* Length of the contact along the mean plane: what ends in points of the lattice exactly. */
static void nominal_length(const tp_evaluation *e, arb_t length) {
  const tp_problem *problem = e->problem;
  fmpz_t sum, dx;
  arb_t cut, cut_dx, cut_dy;
  fmpz_init(sum);
  fmpz_init(dx);
  arb_init(cut);
  arb_init(cut_dx);
  arb_init(cut_dy);
  for (long k = 0; k < problem->contact.facet_count; k++) {
    const tp_facet *f = problem->contact.facets + k;
    if (f->cut0 != NULL || f->cut1 != NULL) {
      tp_evaluation_facet(cut_dx, cut_dy, e, f);
      arb_abs(cut_dx, cut_dx);
      arb_add(cut, cut, cut_dx, e->rung.bits);
      continue;
    }
    fmpz_sub(dx, problem->lattice.x + f->q1, problem->lattice.x + f->q0);
    fmpz_abs(dx, dx);
    fmpz_add(sum, sum, dx);
  }
  arb_set_fmpz(length, sum);
  if (problem->corners.count > 0) arb_add(length, length, cut, e->rung.bits);
  fmpz_clear(sum);
  fmpz_clear(dx);
  arb_clear(cut);
  arb_clear(cut_dx);
  arb_clear(cut_dy);
}

/* Weight over length times thickness; a contact in points alone has no area. */
static tp_bounded pressure(arb_t value, tp_evaluation *e, const tp_bounded length_m,
                           const arb_t length, const arb_t newton) {
  if (length_m.value <= 0) {
    arb_indeterminate(value);
    return (tp_bounded){.error = INFINITY};
  }
  const long bits = e->rung.bits;
  fmpq_t width;
  fmpq_init(width);
  tp_problem_thickness(width, e->problem);
  arb_div(value, newton, length, bits);
  arb_div_fmpz(value, value, fmpq_numref(width), bits);
  arb_mul_fmpz(value, value, fmpq_denref(width), bits);
  fmpq_clear(width);
  return tp_evaluation_result(e, value);
}

static tp_bounded length_in_metres(tp_evaluation *e, const tp_quantity *quantity) {
  fmpq_t metres;
  fmpq_init(metres);
  fmpq_mul(metres, quantity->value, e->problem->scene->metres_per_unit);
  const tp_bounded result = tp_evaluation_rational(metres);
  fmpq_clear(metres);
  return result;
}

/* Where the contact begins and ends, how steep it gets and how far up the block it reaches. */
static void contact_ends(tp_evaluation *e, tp_contact_result *result) {
  const tp_problem *problem = e->problem;
  const tp_contact *contact = &problem->contact;
  const tp_lattice *l = &problem->lattice;
  const tp_contact_point *first = contact->points;
  const tp_contact_point *last = first + contact->point_count - 1;
  result->left_end = problem->base.left;
  result->right_end = problem->base.right;
  tp_evaluation_place_metres(&result->left_x_m, &result->left_y_m, e, tp_contact_place(first));
  tp_evaluation_place_metres(&result->right_x_m, &result->right_y_m, e, tp_contact_place(last));
  result->steep = contact->steep;
  if (contact->steepest >= 0) {
    const tp_facet *f = contact->facets + contact->steepest;
    arb_t dx, dy, angle;
    arb_init(dx);
    arb_init(dy);
    arb_init(angle);
    arb_set_fmpz(dx, l->x + f->t1);
    arb_sub_fmpz(dx, dx, l->x + f->t0, ARF_PREC_EXACT);
    arb_set_fmpz(dy, l->y + f->t1);
    arb_sub_fmpz(dy, dy, l->y + f->t0, ARF_PREC_EXACT);
    arb_abs(dy, dy);
    tp_ball_atan2_degrees(angle, dy, dx, e->rung.bits);
    result->steepest_deg = tp_evaluation_result(e, angle);
    arb_clear(dx);
    arb_clear(dy);
    arb_clear(angle);
  }
}

/* The height that the contact spans over the block's. */
static void contact_reach(const tp_problem *problem, tp_contact_result *result) {
  const tp_contact *contact = &problem->contact;
  const tp_lattice *l = &problem->lattice;
  long low = 0, high = 0, from = contact->points[0].point, to = from;
  for (long k = 1; k < l->start[1]; k++) {
    if (fmpz_cmp(l->y + k, l->y + low) < 0) low = k;
    if (fmpz_cmp(l->y + k, l->y + high) > 0) high = k;
  }
  for (long k = 1; k < contact->point_count; k++) {
    const long point = contact->points[k].point;
    if (fmpz_cmp(l->y + point, l->y + from) < 0) from = point;
    if (fmpz_cmp(l->y + point, l->y + to) > 0) to = point;
  }
  fmpq_t share;
  fmpq_init(share);
  fmpz_sub(fmpq_numref(share), l->y + to, l->y + from);
  fmpz_sub(fmpq_denref(share), l->y + high, l->y + low);
  fmpq_canonicalise(share);
  result->reach = tp_evaluation_rational(share);
  fmpq_mul_2exp(share, share, 1);
  result->reaches_far = fmpq_cmp_ui(share, 1) > 0;
  fmpq_clear(share);
}

void tp_evaluate_contact(tp_evaluation *e, tp_solution *solution) {
  const tp_problem *problem = e->problem;
  const tp_base_description *base = &problem->scene->base;
  tp_contact_result *contact = &solution->contact;
  contact->mated = base->mated;
  contact->beyond_stated = !base->mated || base->beyond_left.given;
  contact->beyond_left_m = length_in_metres(e, &base->beyond_left);
  contact->beyond_right_m = length_in_metres(e, &base->beyond_right);
  contact_ends(e, contact);
  contact_reach(problem, contact);
  contact->facets = contact->points = contact->corner_points = 0;
  for (long k = 0; k < problem->contact.facet_count; k++) {
    const tp_facet *f = problem->contact.facets + k;
    if (f->q0 != f->q1) {
      contact->facets++;
    } else {
      contact->points++;
      contact->corner_points += f->t0 == f->t1;
    }
  }
  arb_t length, newton, value;
  arb_init(value);
  arb_init(length);
  arb_init(newton);
  tp_evaluation_weight(newton, e);
  if (e->rung.level == TP_LEVEL_DOUBLE && tp_lattice_is_exact(&problem->lattice) &&
      problem->corners.count == 0) {
    contact_length_double(e, length);
  } else {
    contact_length_ball(e, length);
  }
  contact->length_m = tp_evaluation_metres(e, length, 1);
  if (solution->block.has_weight) {
    contact->weight_per_contact_area_pa = pressure(value, e, contact->length_m, length, newton);
  }
  nominal_length(e, length);
  contact->nominal_length_m = tp_evaluation_metres(e, length, 1);
  if (solution->block.has_weight) {
    contact->weight_per_nominal_area_pa =
        pressure(e->weight_per_area_pa, e, contact->nominal_length_m, length, newton);
  }
  arb_clear(length);
  arb_clear(newton);
  arb_clear(value);
}

static tp_bounded metres(const tp_problem *problem, const fmpq_t length) {
  fmpq_t value;
  fmpq_init(value);
  fmpq_mul(value, length, problem->scene->metres_per_unit);
  const tp_bounded result = tp_evaluation_rational(value);
  fmpq_clear(value);
  return result;
}

/* Is the mean line of the contact inclined to x by more than 1 in 10? */
static void find_inclination(tp_frame_result *frame, const tp_problem *problem) {
  enum { BITS = 256 };
  fmpq_t u, v, ten;
  fmpq_init(u);
  fmpq_init(v);
  fmpq_init(ten);
  if (tp_mean_plane_of_contact(u, v, &problem->contact, &problem->lattice)) {
    fmpq_abs(ten, v);
    fmpq_mul_ui(ten, ten, 10);
    frame->inclined = fmpq_cmp(ten, u) > 0;
    arb_t x, y;
    arb_init(x);
    arb_init(y);
    arb_set_fmpq(x, u, BITS);
    arb_set_fmpq(y, v, BITS);
    tp_ball_atan2_degrees(y, y, x, BITS);
    frame->inclination_deg = tp_ball_bounded(y);
    arb_clear(x);
    arb_clear(y);
  }
  fmpq_clear(u);
  fmpq_clear(v);
  fmpq_clear(ten);
}

void tp_describe_frame(tp_solution *solution, const tp_problem *problem) {
  tp_frame_result *frame = &solution->frame;
  const tp_scene *scene = problem->scene;
  const tp_world *world = problem->world;
  *frame = (tp_frame_result){.stated = scene->frame != TP_FRAME_UNSTATED, .world = world != NULL};
  if (world != NULL) {
    frame->fitted = world->fitted;
    frame->dips = world->turn.rises != 0;
    frame->dips_towards = world->turn.rises > 0 ? TP_TOWARDS_LEFT : TP_TOWARDS_RIGHT;
    frame->dip_deg = tp_evaluation_rational(world->turn.dip_deg);
    frame->about_x_m = metres(problem, world->turn.x);
    frame->about_y_m = metres(problem, world->turn.y);
  }
  if (!frame->stated && scene->block.form == TP_OUTLINE_VERTICES) find_inclination(frame, problem);
}
