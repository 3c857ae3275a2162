/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A feature of the block, where that is now, and a feature of the base. */

#ifndef TP_CONTACT_SPRINGS_MEETING_H
#define TP_CONTACT_SPRINGS_MEETING_H

#include "contact_springs/features.h"

/* Where the block is: a point p of it (as at the start) is at moved + R p. */
typedef struct tp_placing {
  tp_xy moved;
  double cosine, sine;
} tp_placing;

tp_placing tp_placing_of(const tp_body_state *state);

static inline tp_xy tp_placing_turn(const tp_placing *p, tp_xy v) {
  return (tp_xy){p->cosine * v.x - p->sine * v.y, p->sine * v.x + p->cosine * v.y};
}

static inline tp_xy tp_placing_turn_back(const tp_placing *p, tp_xy v) {
  return (tp_xy){p->cosine * v.x + p->sine * v.y, p->cosine * v.y - p->sine * v.x};
}

typedef struct tp_meeting {
  double gap;   /* below zero: they overlap */
  tp_xy normal; /* unit, from the base into the block */
  tp_xy at;     /* on the base */
} tp_meeting;

/* Do the two kinds meet at all? Straight pieces do by the discs at their ends alone. */
bool tp_features_can_meet(const tp_feature *of_block, const tp_feature *of_base);

/* False where their gap is not below `below`, or where they do not face each other: then others
 * beside them do. `grace`: a length by which contacts may run past the end of a feature. */
bool tp_features_meet(tp_meeting *meeting, const tp_feature *of_block, const tp_feature *of_base,
                      const tp_placing *placing, double grace, double below);

#endif
