/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Critical angles by their directions, and their order: exact where the directions are, so that
 * ties are ties. */

#ifndef TP_EVALUATION_DIRECTION_BALL_H
#define TP_EVALUATION_DIRECTION_BALL_H

#include "evaluation/certainty.h"

/* tan(angle) = sine / cosine, unnormalised. On exact rungs exact. */
typedef struct tp_direction_ball {
  arb_t sine, cosine;
  arb_t degrees;
  bool exact_direction; /* sine and cosine enclose the direction of `degrees` itself */
  const fmpq *adds;     /* `degrees` is this friction angle of the scene and the inclination added;
                           NULL: it is not */
  arb_t inclination;
} tp_direction_ball;

void tp_direction_ball_init(tp_direction_ball *angle);
void tp_direction_ball_clear(tp_direction_ball *angle);

/* How one angle stands to another. */
typedef struct tp_angle_order {
  int sign;      /* of a - b in degrees */
  long tie_bits; /* of a tie: 0 where it is proven, else the bits that do not tell the two apart */
} tp_angle_order;

/* Where the balls overlap and both directions are exact, the sign of the cross product decides,
 * ties included; otherwise the order is left open, or from many bits on a tie. */
tp_angle_order tp_direction_ball_order(const tp_evaluation *evaluation, const tp_direction_ball *a,
                                       const tp_direction_ball *b, tp_certainty *certainty);

/* The sign alone: of a tie that is not proven the certainty tells. */
int tp_direction_ball_compare(const tp_evaluation *evaluation, const tp_direction_ball *a,
                              const tp_direction_ball *b, tp_certainty *certainty);

#endif
