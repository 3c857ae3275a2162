/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A mechanism and its proof: a face of the cone of forces that the base can exert.
 *
 * Two columns span it; the twist v is normal to both. If v . column >= 0 for every column, the
 * block can move by v without any contact resisting more than friction allows (v is admissible),
 * and no equilibrium exists where the loads do work on it: v . F > K, K being what cohesion and
 * bonds can hold. At v . F = K the two forces, if none is negative, hold the block: both together
 * prove the limit (duality of linear programs; docs/mechanics.md section 6). */

#ifndef TP_FACE_H
#define TP_FACE_H

#include "limit/cones.h"
#include "limit/sketch.h"
#include "limit/vector.h"

typedef enum tp_answer { TP_NO, TP_YES, TP_OPEN } tp_answer;

typedef enum tp_face_motion {
  TP_MOTION_SLIDE,
  TP_MOTION_TURN_AT_SITE,
  TP_MOTION_TURN
} tp_face_motion;

typedef struct tp_face {
  long columns[2]; /* -1: none, a twist inside the admissible ones */
  tp_vector twist;
  tp_face_motion motion;
  long site;  /* of TP_MOTION_TURN_AT_SITE */
  arb_t held; /* K */
  bool *full; /* for each column of an allowance: at its bound; NULL where there is none */
} tp_face;

/* How balls about zero are judged: one narrower than half the precision, relative to what it is
 * made of, is zero if `settled`; otherwise it is open. */
typedef struct tp_judge {
  long bits;      /* of roundings */
  long precision; /* of the data: bits, or more where they are exact */
  bool settled;
} tp_judge;

/* False when memory is exhausted. */
bool tp_face_init(tp_face *face, const tp_cones *cones);
void tp_face_clear(tp_face *face);

/* The face of two columns, its twist such that v . `drive` > 0. TP_NO: they span none. */
tp_answer tp_face_span(tp_face *face, const tp_cones *cones, long first, long second,
                       const tp_vector *drive, const tp_judge *judge);

/* Is the twist admissible? Also settles the motion and K. `sketch` is of the same
 * cones. `*violated` is a column against it. */
tp_answer tp_face_admit(tp_face *face, const tp_cones *cones, const tp_sketch *sketch,
                        const tp_judge *judge, long *violated);

/* K and `full` alone. */
void tp_face_find_held(tp_face *face, const tp_cones *cones, const tp_judge *judge);

/* Allowances that do no work may count or not: those that the sketch has at their bound do. */
void tp_face_take_idle(tp_face *face, const tp_cones *cones, const bool *at_most,
                       const tp_judge *judge);

/* The factors on both columns with which they balance the wrench together with the allowances at
 * their bounds. The wrench lies in the face. */
void tp_face_forces(arb_ptr factors, const tp_face *face, const tp_cones *cones,
                    const tp_vector *wrench, const tp_judge *judge);

/* Sign of a ball by the judge: 1, -1, 0, or 2 where open. `log2_scale` is that of its terms. */
int tp_judge_sign(const tp_judge *judge, const arb_t ball, double log2_scale);

#endif
