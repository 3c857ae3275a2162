/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Mechanism, centre of rotation, facet of sliding and contact reactions of a proven limit,
 * converted from the lattice to metres and newtons and mirrored back (docs/mechanics.md section
 * 6). */

#include "static_limit/limit_result.h"

#include "evaluation/loaded.h"
#include "number/ball.h"

#include <math.h>

typedef struct telling {
  tp_limit *result;
  const tp_evaluation *e;
  tp_certainty *certainty;
  const tp_limit_question *question;
  const tp_limit_answer *answer;
  tp_direction towards;
} telling;

tp_mechanism tp_limit_mechanism(tp_face_motion motion) {
  switch (motion) {
  case TP_MOTION_SLIDE:
    return TP_SLIDES;
  case TP_MOTION_TURN_AT_SITE:
    return TP_TOPPLES;
  case TP_MOTION_TURN:
    return TP_SLIDES_AND_TOPPLES;
  }
  return TP_MECHANISM_UNDECIDED;
}

/* A point of the cones' frame in metres of the scene; certain to the digits of the block's size. */
static void set_point(tp_bounded *x_m, tp_bounded *y_m, const telling *t, const arb_t x,
                      const arb_t y) {
  const tp_evaluation *e = t->e;
  arb_t scene_x, scene_y;
  arb_init(scene_x);
  arb_init(scene_y);
  arb_set(scene_x, x);
  arb_set(scene_y, y);
  tp_ball_mirror(scene_x, t->towards);
  if (e->loaded == NULL) {
    tp_loaded_metres(scene_x, scene_y, e);
  } else {
    arb_t origin_x, origin_y;
    arb_init(origin_x);
    arb_init(origin_y);
    tp_loaded_metres(origin_x, origin_y, e);
    arb_add(scene_x, scene_x, origin_x, e->rung.bits);
    arb_add(scene_y, scene_y, origin_y, e->rung.bits);
    arb_clear(origin_x);
    arb_clear(origin_y);
  }
  tp_result_place(x_m, y_m, e, scene_x, scene_y, e->log2_extent, t->certainty);
  arb_clear(scene_x);
  arb_clear(scene_y);
}

/* (-v_y, v_x) / omega, or the contact point. */
static void set_centre(const telling *t) {
  tp_limit *r = t->result;
  const tp_face *face = &t->answer->face;
  const tp_cones *cones = t->question->cones;
  r->has_centre = tp_face_told_motion(face, cones) != TP_MOTION_SLIDE;
  if (!r->has_centre) return;
  if (face->motion == TP_MOTION_TURN_AT_SITE) {
    long own = 0;
    while (cones->points[own].site != face->site) own++;
    const arb_struct x = tp_cones_x(cones, own), y = tp_cones_y(cones, own);
    set_point(&r->centre_x_m, &r->centre_y_m, t, &x, &y);
    return;
  }
  const arb_struct *v = face->twist.of;
  const long bits = t->question->judge.bits;
  arb_t x, y;
  arb_init(x);
  arb_init(y);
  arb_div(x, v + 1, v + 2, bits);
  arb_neg(x, x);
  arb_div(y, v, v + 2, bits);
  set_point(&r->centre_x_m, &r->centre_y_m, t, x, y);
  arb_clear(x);
  arb_clear(y);
}

/* Does the column's force no work in the slide, so that it slides along its facet? */
static bool slides_along(const telling *t, long column) {
  const tp_judge *judge = &t->question->judge;
  const tp_vector *twist = &t->answer->face.twist;
  const tp_cones *cones = t->question->cones;
  const long first = t->answer->face.columns[0];
  if (tp_cones_are_parallel(cones, first, column)) return true;
  if (t->answer->face.motion != TP_MOTION_SLIDE) {
    return tp_cones_slip_unevenly(cones, first, column);
  }
  tp_vector force;
  arb_t power;
  tp_vector_init(&force);
  arb_init(power);
  tp_cones_column(force.of, cones, column, judge->precision);
  arb_zero(force.of + 2); /* its moment does none: a slide does not turn */
  tp_vector_dot(power, twist, &force, judge->precision);
  const int sign = tp_vector_judge(judge, power, twist, &force);
  tp_vector_clear(&force);
  arb_clear(power);
  return sign != 1 && sign != -1;
}

/* Of the facets along which it slides, or under cohesion lifts off without shearing them, the first
 * from the toe that has a length: which two of them the forces were put on is the solver's choice.
 * They are parallel, or at an angle of 2 phi, so that their forces are. -1 where all of them belong
 * to the base that goes on past the block. */
static long facet_of_slide(const telling *t) {
  const tp_cones *cones = t->question->cones;
  const tp_facet *facets = t->e->problem->contact.facets;
  const long *own = t->answer->face.columns;
  long best = cones->points[tp_cones_point_of(cones, own[own[0] < 0 ? 1 : 0])].facet;
  for (long column = 0; column < tp_cones_column_count(cones); column++) {
    if (!tp_cones_is_edge(cones, column) && !tp_cones_is_shear(cones, column)) continue;
    const long facet = cones->points[tp_cones_point_of(cones, column)].facet;
    if (facet < 0 || !slides_along(t, column)) continue;
    if (best < 0) best = facet;
    const bool point = facets[facet].q0 == facets[facet].q1;
    const bool best_point = facets[best].q0 == facets[best].q1;
    const bool nearer = t->towards == TP_TOWARDS_LEFT ? facet < best : facet > best;
    if ((best_point && !point) || (nearer && point == best_point)) best = facet;
  }
  return best;
}

static void set_facet(const telling *t) {
  tp_limit *r = t->result;
  if (tp_face_told_motion(&t->answer->face, t->question->cones) != TP_MOTION_SLIDE) return;
  const long facet = facet_of_slide(t);
  r->has_facet = facet >= 0;
  if (!r->has_facet) return;
  const tp_facet *own = t->e->problem->contact.facets + facet;
  tp_result_point(&r->facet_x0_m, &r->facet_y0_m, t->e, tp_facet_begin(own), t->certainty);
  tp_result_point(&r->facet_x1_m, &r->facet_y1_m, t->e, tp_facet_end(own), t->certainty);
}

/* Of the weight: that of the force of gravity at the tilt, whose direction may come times any
 * factor. */
static void set_weight(arb_t weight, const telling *t) {
  const tp_evaluation *e = t->e;
  const long bits = t->question->judge.bits;
  const tp_wrench *own = e->loaded != NULL ? &e->loaded->items[0].wrench : t->question->load;
  arb_hypot(weight, t->answer->sine, t->answer->cosine, bits);
  arb_mul(weight, weight, own->y.of + TP_COS, bits);
  arb_neg(weight, weight);
}

/* Which end of which facet the column acts at, along which edge of its cone. */
static void set_source(tp_reaction *reaction, const telling *t, long column) {
  const tp_cones *cones = t->question->cones;
  const long point = tp_cones_point_of(cones, column), facet = cones->points[point].facet;
  reaction->of_facet = facet >= 0;
  if (facet < 0) return;
  reaction->facet = (size_t)facet;
  reaction->at_right_end = point > 0 && cones->points[point - 1].facet == facet;
  reaction->against_slip = tp_cones_is_edge(cones, column) && column % 2 == 0;
}

static void set_reactions(const telling *t) {
  tp_limit *r = t->result;
  const tp_cones *cones = t->question->cones;
  const long bits = t->question->judge.bits;
  const bool known = t->question->judge.precision == bits; /* as the face has them */
  tp_vector column;
  arb_t weight;
  tp_vector_init(&column);
  arb_init(weight);
  set_weight(weight, t);
  for (int k = 0; k < 2; k++) {
    const long own = t->answer->face.columns[k], point = tp_cones_point_of(cones, own);
    if (arb_is_zero(t->answer->forces + k)) continue;
    tp_reaction *reaction = r->reactions + r->reaction_count++;
    set_source(reaction, t, own);
    if (!known) tp_cones_column(column.of, cones, own, bits);
    const tp_vector *edge = known ? t->answer->face.edges + k : &column;
    for (int row = 0; row < 2; row++) {
      arb_mul(column.of + row, edge->of + row, t->answer->forces + k, bits);
      arb_div(column.of + row, column.of + row, weight, bits);
    }
    tp_ball_mirror(column.of, t->towards);
    reaction->share_x = tp_result_of(t->e, column.of);
    reaction->share_y = tp_result_of(t->e, column.of + 1);
    const arb_struct x = tp_cones_x(cones, point), y = tp_cones_y(cones, point);
    set_point(&reaction->x_m, &reaction->y_m, t, &x, &y);
  }
  tp_vector_clear(&column);
  arb_clear(weight);
}

void tp_limit_describe(tp_limit *result, const tp_evaluation *e, const tp_limit_question *question,
                       const tp_limit_answer *answer, tp_direction towards,
                       tp_certainty *certainty) {
  const telling t = {result, e, certainty, question, answer, towards};
  result->kind = answer->kind;
  result->mechanism = answer->kind == TP_LIMIT_INTERLOCKED ? TP_INTERLOCKED : TP_SLIDES_AND_TOPPLES;
  if (answer->kind != TP_LIMIT_AT_ANGLE) return;
  result->mechanism = tp_limit_mechanism(tp_face_told_motion(&answer->face, question->cones));
  result->critical_angle_deg = tp_result(e, answer->degrees, certainty);
  result->tie = answer->tie;
  const bool rational =
      question->judge.precision == ARF_PREC_EXACT && tp_cones_are_exact(question->cones);
  result->tie_bits = answer->tie && question->judge.settled && !rational ? question->judge.bits : 0;
  if (answer->tie) {
    result->tied_with = tp_limit_mechanism(tp_face_told_motion(&answer->other, question->cones));
  }
  result->turns_up_dip =
      result->mechanism != TP_SLIDES && arf_sgn(arb_midref(answer->face.twist.of + 2)) < 0;
  set_centre(&t);
  set_facet(&t);
  set_reactions(&t);
}
