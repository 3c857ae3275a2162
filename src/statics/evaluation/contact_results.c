/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The contact: where it begins and ends, its length, its steepest facet, the weight on it. */

#include "base/mean_plane.h"
#include "evaluation/contact_length.h"
#include "evaluation/stages.h"

#include "number/ball.h"
#include "problem/drawn.h"

#include <math.h>

/* Weight over length times thickness; a contact in points alone has no area. */
static tp_bounded pressure(const tp_evaluation *e, tp_bounded length_m, const arb_t length,
                           tp_certainty *certainty) {
  if (length_m.value <= 0) return (tp_bounded){.error = INFINITY};
  arb_t value;
  arb_init(value);
  tp_weight_per_area(value, e, length);
  const tp_bounded result = tp_result(e, value, certainty);
  arb_clear(value);
  return result;
}

static tp_bounded length_in_metres(const tp_evaluation *e, const tp_quantity *quantity) {
  fmpq_t metres;
  fmpq_init(metres);
  fmpq_mul(metres, quantity->value, e->problem->scene->metres_per_unit);
  const tp_bounded result = tp_result_rational(metres);
  fmpq_clear(metres);
  return result;
}

/* Where the contact begins and ends, how steep it gets and how far up the block it reaches. */
static void contact_ends(const tp_evaluation *e, tp_contact_result *result,
                         tp_certainty *certainty) {
  const tp_problem *problem = e->problem;
  const tp_contact *contact = &problem->contact;
  const tp_lattice *l = &problem->lattice;
  const tp_contact_point *first = contact->points;
  const tp_contact_point *last = first + contact->point_count - 1;
  result->left_end = problem->base.left;
  result->right_end = problem->base.right;
  tp_result_point(&result->left_end_x_m, &result->left_end_y_m, e, tp_contact_on_outline(first),
                  certainty);
  tp_result_point(&result->right_end_x_m, &result->right_end_y_m, e, tp_contact_on_outline(last),
                  certainty);
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
    result->steepest_deg = tp_result(e, angle, certainty);
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
  result->share_of_height = tp_result_rational(share);
  fmpq_mul_2exp(share, share, 1);
  result->reaches_far = fmpq_cmp_ui(share, 1) > 0;
  fmpq_clear(share);
}

/* Its lengths, and the weight on them where that is known. */
static void contact_lengths(const tp_evaluation *e, tp_contact_result *contact,
                            tp_certainty *certainty) {
  const bool has_weight = e->problem->scene->block.unit_weight_kn_m3.given;
  arb_t length;
  arb_init(length);
  tp_contact_length(length, e);
  contact->length_m = tp_result_metres(e, length, 1, certainty);
  if (has_weight) {
    contact->weight_per_contact_area_pa = pressure(e, contact->length_m, length, certainty);
  }
  tp_contact_nominal_length(length, e);
  contact->nominal_length_m = tp_result_metres(e, length, 1, certainty);
  if (has_weight) {
    contact->weight_per_nominal_area_pa = pressure(e, contact->nominal_length_m, length, certainty);
  }
  contact->has_contact_ratio = tp_contact_ratio(length, e);
  if (contact->has_contact_ratio) contact->contact_ratio = tp_result(e, length, certainty);
  arb_clear(length);
}

void tp_evaluate_contact(const tp_evaluation *e, tp_contact_result *contact,
                         tp_certainty *certainty) {
  const tp_problem *problem = e->problem;
  const tp_base_description *base = &problem->scene->base;
  contact->mated = base->mated;
  contact->shifted = problem->placement.jointed != NULL;
  contact->beyond_stated = (!base->mated && !contact->shifted) || base->beyond_left.given;
  contact->beyond_left_m = length_in_metres(e, &base->beyond_left);
  contact->beyond_right_m = length_in_metres(e, &base->beyond_right);
  contact_ends(e, contact, certainty);
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
  contact_lengths(e, contact, certainty);
}

static tp_bounded metres(const tp_problem *problem, const fmpq_t length) {
  fmpq_t value;
  fmpq_init(value);
  fmpq_mul(value, length, problem->scene->metres_per_unit);
  const tp_bounded result = tp_result_rational(value);
  fmpq_clear(value);
  return result;
}

static tp_bounded turned_degrees(const tp_problem *problem) {
  arb_t degrees;
  arb_init(degrees);
  tp_drawn_axis_degrees(degrees, problem);
  const tp_bounded result = tp_ball_bounded(degrees);
  arb_clear(degrees);
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

/* The dip lies 90 degrees clockwise of the strike, by the rule of the right hand. */
static void find_dip_direction(tp_frame_result *frame, const tp_slope_description *slope) {
  const bool strikes = slope->strike_deg.given;
  frame->has_dip_direction = strikes || slope->dip_direction_deg.given;
  if (!frame->has_dip_direction) return;
  fmpq_t azimuth;
  fmpq_init(azimuth);
  fmpq_set(azimuth, strikes ? slope->strike_deg.value : slope->dip_direction_deg.value);
  if (strikes) fmpq_add_si(azimuth, azimuth, 90);
  if (fmpq_cmp_si(azimuth, 360) > 0) fmpq_sub_si(azimuth, azimuth, 360);
  frame->dip_direction_deg = tp_result_rational(azimuth);
  fmpq_clear(azimuth);
}

void tp_describe_frame(tp_solution *solution, const tp_problem *problem) {
  tp_frame_result *frame = &solution->frame;
  const tp_scene *scene = problem->scene;
  const tp_world *world = problem->placement.world;
  *frame = (tp_frame_result){.stated = scene->frame != TP_FRAME_UNSTATED, .world = world != NULL};
  if (world != NULL) {
    frame->slope = world->unturned;
    frame->level = world->level;
    frame->fitted = world->fitted;
    frame->dips = world->turn.rises != 0;
    frame->dips_towards = world->turn.rises > 0 ? TP_TOWARDS_LEFT : TP_TOWARDS_RIGHT;
    frame->dip_deg = tp_result_rational(world->turn.dip_deg);
    frame->turned_about_x_m = metres(problem, world->turn.x);
    frame->turned_about_y_m = metres(problem, world->turn.y);
    frame->turned_deg = turned_degrees(problem);
    find_dip_direction(frame, &scene->slope);
  }
  if (!frame->stated && scene->block.form == TP_OUTLINE_VERTICES) {
    find_inclination(frame, problem);
  }
}
