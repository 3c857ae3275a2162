/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The factor of safety by strength reduction: by how much tan(phi), cohesion and bond may be
 * divided until no forces hold the block at a given tilt any more.
 *
 * What the base bears shrinks with its strength, so a factor at which some forces are proven to
 * hold the block and one at which none do enclose it. */

#ifndef TP_STRENGTH_REDUCTION_REDUCTION_H
#define TP_STRENGTH_REDUCTION_REDUCTION_H

#include "limit/limit.h"

typedef enum tp_reduction_kind {
  TP_REDUCTION_FACTOR,
  TP_REDUCTION_UNBOUNDED, /* it stands at the tilt without any strength */
  TP_REDUCTION_NONE       /* no strength would hold it there */
} tp_reduction_kind;

/* A factor, and how the block moves at the tilt at a strength divided by it: at the upper end of
 * the factor's bound, by the twist that proves it lost there, or, where that was proven by the
 * limit, at the limit that it has at the lower end. */
typedef struct tp_reduction {
  tp_reduction_kind kind;
  arb_t factor;
  bool has_motion; /* false: there it would still hold at every tilt */
  tp_face_motion motion;
} tp_reduction;

void tp_reduction_init(tp_reduction *reduction);
void tp_reduction_clear(tp_reduction *reduction);

/* The question's cones are scaled for it and left as they were. `degrees` is the tilt; the factor
 * is known to 10^-digits of its size. */
tp_limit_outcome tp_reduction_find(tp_reduction *reduction, const tp_limit_question *question,
                                   tp_cones *cones, const arb_t degrees, int digits);

#endif
