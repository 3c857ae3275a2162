/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A mechanism and its proof: a face of the cone of forces that the base can exert.
 *
 * Two columns span it; the twist v is normal to both. If v . column >= 0 for every column, the
 * block can move by v without any contact resisting more than friction allows (v is admissible),
 * and no equilibrium exists where the loads do work on it: v . F > K, K being what cohesion and
 * bonds can hold. At v . F = K the two forces, if none is negative, hold the block: both together
 * prove the limit (duality of linear programs; docs/mechanics.md section 6). */

#ifndef TP_CERTIFICATE_FACE_H
#define TP_CERTIFICATE_FACE_H

#include "linear_program/cones.h"
#include "linear_program/scaled.h"
#include "number/judge.h"
#include "plane/vector.h"

typedef enum tp_face_motion {
  TP_MOTION_SLIDE,
  TP_MOTION_TURN_AT_SITE,
  TP_MOTION_TURN
} tp_face_motion;

typedef struct tp_face {
  long columns[2];            /* -1: none, a twist inside the admissible ones */
  tp_vector edges[2], normal; /* their balls and the cross product of these */
  tp_vector twist;
  tp_face_motion motion;
  long site;        /* of TP_MOTION_TURN_AT_SITE */
  arb_t resistance; /* K */
  bool *full;       /* for each column of an capacity: at its bound; NULL where there is none */
} tp_face;

/* False when memory is exhausted. */
bool tp_face_init(tp_face *face, const tp_cones *cones);
void tp_face_clear(tp_face *face);

/* The face of two columns, its twist such that v . `drive` > 0. TP_NO: they span none. */
tp_answer tp_face_span(tp_face *face, const tp_cones *cones, long first, long second,
                       const tp_vector *drive, const tp_judge *judge);

/* Is the twist admissible? Also settles the motion and K. `scaled` is of the same
 * cones. `*violated` is a column against it. */
tp_answer tp_face_admit(tp_face *face, const tp_cones *cones, const tp_scaled *scaled,
                        const tp_judge *judge, long *violated);

/* Likewise to the friction cones of points from one on, one by one, and neither K nor the centre
 * of a turn as exactly as its site. */
tp_answer tp_face_admit_points(tp_face *face, const tp_cones *cones, long from,
                               const tp_judge *judge);

/* The motion to tell: a turn by which both columns slip along one direction, under frictions that
 * differ, is the slide; it turns only because the flow rule that goes with the cones opens each
 * contact by its own friction as it slips. */
tp_face_motion tp_face_told_motion(const tp_face *face, const tp_cones *cones);

/* K and `full` alone. */
void tp_face_find_resistance(tp_face *face, const tp_cones *cones, const tp_judge *judge);

/* Capacities that do no work may count or not: those that the scaled program has at their bound do.
 */
void tp_face_settle_capacities(tp_face *face, const tp_cones *cones, const bool *at_most,
                               const tp_judge *judge);

/* Add the capacities that are at their bounds to a wrench. */
void tp_face_add_capacities(tp_vector *wrench, const tp_face *face, const tp_cones *cones,
                            const tp_judge *judge);

/* Of a face that is spanned: the factors on both columns with which they balance the wrench
 * together with the capacities at their bounds. The wrench lies in the face. */
void tp_face_forces(arb_ptr factors, const tp_face *face, const tp_cones *cones,
                    const tp_vector *wrench, const tp_judge *judge);

#endif
