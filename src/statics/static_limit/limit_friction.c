/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Fixed point of the limit and of Barton's friction at the limit's stress (docs/mechanics.md
 * section 6), and the closed form phi +- i where the block slides under its weight alone. */

#include "static_limit/limit_friction.h"

#include "evaluation/friction.h"
#include "limit/program.h"
#include "number/ball.h"

/* Where the weight alone acts and the block slides, all force lies along one edge of a cone: the
 * angle is the inclination of n, plus or minus phi, without the roundings of tan(phi): `friction`,
 * but where its facet has its own. */
static void sharpen_slide(tp_limit_answer *answer, const tp_cones *cones, const tp_evaluation *e,
                          const arb_t friction, bool back) {
  answer->adds_friction = false;
  if (e->loaded != NULL || answer->kind != TP_LIMIT_AT_ANGLE || answer->tie ||
      answer->face.motion != TP_MOTION_SLIDE) {
    return;
  }
  const long column = answer->face.columns[0], point = tp_cones_point_of(cones, column);
  answer->adds_friction = !back && column % 2 == 0;
  arb_t x, y, angle;
  arb_init(x);
  arb_init(y);
  arb_init(angle);
  arb_set_fmpz(x, cones->ty + point);
  arb_neg(x, x);
  arb_set_fmpz(y, cones->tx + point);
  tp_ball_atan2_degrees(answer->inclination, x, y, e->rung.bits);
  arb_set(answer->degrees, answer->inclination);
  const long facet = cones->points[point].facet;
  if (tp_friction_own(e->problem, facet) != NULL) {
    tp_friction_of_facet(angle, e, facet, friction);
  } else {
    arb_set(angle, friction);
  }
  if (column % 2 != 0) arb_neg(angle, angle);
  arb_add(answer->degrees, answer->degrees, angle, e->rung.bits);
  if (arf_cmpabs_ui(arb_midref(answer->degrees), 90) >
      0) { /* forces against that edge: the other */
    const int side = arf_sgn(arb_midref(answer->degrees));
    arb_sub_si(answer->degrees, answer->degrees, 180 * side, e->rung.bits);
    answer->adds_friction = false;
  }
  if (back) arb_neg(answer->degrees, answer->degrees);
  arb_clear(x);
  arb_clear(y);
  arb_clear(angle);
}

/* Where the judge would take zeros, first without: what is proven so rests on none. */
static tp_limit_outcome find(tp_limit_asking *a) {
  if (a->question->judge.settled) {
    tp_limit_question strict = *a->question;
    strict.judge.settled = false;
    const tp_limit_outcome outcome = tp_limit_find(a->answer, &strict);
    if (outcome != TP_LIMIT_OPEN) return outcome;
  }
  return tp_limit_find(a->answer, a->question);
}

/* A friction angle to the limit that it gives (tp_friction_limit). */
static bool limit_of(arb_t tilt, void *context, const arb_t degrees, bool estimate) {
  tp_limit_asking *a = context;
  tp_friction_set_tangent(a->cones->friction, a->e, degrees);
  if (estimate) {
    tp_scaled scaled;
    if (!tp_program_scaled(&scaled, a->question)) {
      a->outcome = TP_LIMIT_OUT_OF_MEMORY;
      return false;
    }
    arb_set_d(tilt, tp_program_estimate(&scaled, a->question));
    tp_scaled_clear(&scaled);
    return true;
  }
  a->outcome = find(a);
  if (a->outcome != TP_LIMIT_PROVEN) return false;
  sharpen_slide(a->answer, a->cones, a->e, degrees, a->back);
  arb_set(tilt, a->answer->degrees);
  if (a->answer->kind != TP_LIMIT_AT_ANGLE) {
    arb_set_si(tilt, a->answer->kind == TP_LIMIT_INTERLOCKED ? 90 : -90);
  }
  return true;
}

void tp_limit_meet_friction(tp_limit *result, tp_limit_asking *a) {
  arb_t friction, tilt;
  arb_init(friction);
  arb_init(tilt);
  if (tp_friction_is_load_dependent(a->e)) {
    if (!tp_friction_meet(friction, a->e, limit_of, a, a->back) && a->outcome == TP_LIMIT_PROVEN) {
      a->outcome = TP_LIMIT_OPEN;
    }
  } else {
    tp_friction_at(friction, a->e, tilt);
    (void)limit_of(tilt, a, friction, false);
  }
  result->friction_angle_deg = tp_result_of(a->e, friction);
  arb_clear(friction);
  arb_clear(tilt);
}
