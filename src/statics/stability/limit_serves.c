/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Test that the two forces of a limit remain on the other base and that its twist is admissible to
 * the contact points added there, in balls without taking any value for zero. */

#include "stability/limit_serves.h"

#include "stability/friction.h"
#include "stability/limit_cones.h"

static bool is_clear(const tp_evaluation *e, const tp_limit_question *q,
                     const tp_limit_answer *answer) {
  return !tp_friction_is_load_dependent(e) && tp_question_is_linear(q) &&
         answer->kind == TP_LIMIT_AT_ANGLE && !answer->tie && !answer->bracketed &&
         arb_is_positive(answer->forces) && arb_is_positive(answer->forces + 1);
}

/* Nor is what turns known to turn about a contact point by a force that is gone. */
static bool keeps_forces(const tp_evaluation *e, tp_direction towards, const tp_cones *cones,
                         const tp_face *face) {
  long site = -1;
  if (face->motion == TP_MOTION_TURN_AT_SITE &&
      !(tp_cones_meet(&site, cones, face->columns[0], face->columns[1]) && site == face->site)) {
    return false;
  }
  for (int k = 0; k < 2; k++) {
    const long facet = cones->points[tp_cones_point_of(cones, face->columns[k])].facet;
    if (!tp_limit_keeps_facet(e->problem, towards, facet)) return false;
  }
  return true;
}

/* The face among cones whose first two points are those of its columns. */
static bool admits_added(const tp_cones *cones, tp_face *face, const tp_judge *judge) {
  enum { MOST_ADDED = 64 }; /* points that are looked at one by one */
  const tp_face_motion motion = face->motion;
  const long columns[2] = {face->columns[0], face->columns[1]};
  tp_judge strict = *judge;
  strict.settled = false;
  if (cones->count > MOST_ADDED) return false;
  for (int k = 0; k < 2; k++) face->columns[k] = 2L * k + columns[k] % 2;
  const bool admits =
      tp_face_admit_points(face, cones, 2, &strict) == TP_YES && face->motion == motion;
  for (int k = 0; k < 2; k++) face->columns[k] = columns[k];
  face->motion = motion;
  return admits;
}

bool tp_limit_serves(bool *serves, const tp_evaluation *e, tp_direction towards,
                     const tp_limit_question *q, tp_limit_answer *answer) {
  tp_face *face = &answer->face;
  *serves = false;
  if (!is_clear(e, q, answer)) return true;
  if (tp_limit_base_beyond_toe(e->problem, towards)) {
    *serves = keeps_forces(e, towards, q->cones, face);
    return true;
  }
  const long points[2] = {tp_cones_point_of(q->cones, face->columns[0]),
                          tp_cones_point_of(q->cones, face->columns[1])};
  tp_cones added;
  if (!tp_limit_cones_added(&added, e, towards, q->cones, points)) return false;
  *serves = admits_added(&added, face, &q->judge);
  tp_cones_clear(&added);
  return true;
}
