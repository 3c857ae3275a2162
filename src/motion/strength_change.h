/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* By how much may all strength of the contact, tan(phi), cohesion and bonds alike, change, more or
 * less, until it changes whether a motion can begin at one tilt?
 *
 * More strength does not always hold a block better: it may let a toe stick about which the block
 * then turns. So both ways count, and the nearer change, as a ratio, is the answer. It is searched
 * over all modes (motion/mode_shares.h), and proven at both ends of its bound, by doubles where
 * these tell, else by the modes in balls (motion/motion.h). That none lies nearer is as the search
 * in doubles has it. */

#ifndef TP_STRENGTH_CHANGE_H
#define TP_STRENGTH_CHANGE_H

#include "motion/motion.h"

/* Does a change of strength move an end of a window of motion? As far inside it as this, a change
 * of strength by this, as a logarithm, then ends what can begin. */
#define TP_BESIDE_END_DEG 1e-6
#define TP_LITTLE_STRENGTH 1e-3

/* What is asked: the motions at the strength as given, with all modes kept, and a tilt. */
typedef struct tp_strength_asked {
  const tp_motion_question *question;
  tp_cones *cones, *strong; /* those of the question, scaled and left as they were; or NULL */
  const tp_motions *motions;
  arb_srcptr degrees;
  bool can_begin;    /* a motion, with all of the strength */
  bool all_is_lost;  /* no forces hold the block with any strength */
  bool is_held;      /* some do however small it is */
  arb_srcptr held;   /* else the share with which some just do: below it something moves */
  tp_mechanism lost; /* by this mechanism */
  int digits;
} tp_strength_asked;

typedef struct tp_strength_change {
  bool found; /* false: no change of strength changes it */
  arb_t share;
  bool raised; /* the share is above 1 */
  tp_mechanism mechanism;
} tp_strength_change;

void tp_strength_change_init(tp_strength_change *change);
void tp_strength_change_clear(tp_strength_change *change);

TP_MUST_USE tp_motion_outcome tp_strength_change_find(tp_strength_change *change,
                                                      const tp_strength_asked *asked);

/* The share nearest to 1 at which the modes alone change it, as the search in doubles has it; 0
 * where there is none. */
TP_MUST_USE tp_motion_outcome tp_strength_change_of_modes(double *share,
                                                          const tp_strength_asked *asked);

#endif
