/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* How a block comes to rest on a profile: it is set down from above along gravity, then turns about
 * points of its contact, without sliding there, for as long as a turn lets its centroid down and
 * nothing stops it (docs/rest.md).
 *
 * Friction is taken to hold every point about which it turns. At rest each turn that would let the
 * centroid down, about any point of the contact, is stopped by another: the energy is at a local
 * minimum among all motions without sliding. Every turn ends lower than it began, so no pose comes
 * twice; of a block that has not come to rest after tp_settle_most turns that is said. */

#ifndef TP_REST_SETTLE_H
#define TP_REST_SETTLE_H

#include "rest/touch.h"

typedef enum tp_settled {
  TP_SETTLED_RESTS,
  TP_SETTLED_BESIDE,    /* nothing of it stands over the profile */
  TP_SETTLED_ROLLS_OFF, /* its centroid passes under the point about which it turns, or that is
                           below the profile's end */
  TP_SETTLED_BALANCES,  /* its centroid lies upright over the point that would have to stop it */
  TP_SETTLED_GOES_ON,   /* after tp_settle_most turns */
  TP_SETTLED_TOO_DEAR,  /* with the work allowed (budget.h) all spent */
  TP_SETTLED_TOO_BLIND, /* of too many pairs only exact numbers would tell which touches first */
  TP_SETTLED_UNDECIDED  /* several corners touch at once, in a pose without rational numbers */
} tp_settled;

typedef struct tp_settling {
  tp_bodies bodies; /* in the last pose */
  tp_touches touches;
  fmpq_t height; /* that it fell before it turned; below zero: it was lifted */
  long turns;
  tp_exact_point pivot; /* where it rolls off, or balances */
  tp_settled how;
  double work, work_allowed; /* pairs that were looked at, in all settlings; and may be */
  tp_place asked;            /* for messages: what asked for it */
} tp_settling;

/* From where the block's own coordinates put it, shifted along x by so much. `settling` is cleared
 * on failure, and by the caller else. Rings as for tp_bodies_init. */
TP_MUST_USE tp_status tp_settle(tp_settling *settling, const tp_polyline *outline,
                                const tp_polyline *base_ring, const tp_exact_point *centroid,
                                const fmpq_t shift_x, tp_message *message);
void tp_settling_clear(tp_settling *settling);

/* Once more, shifted by so much instead; the bodies are those that were set up. On failure it is
 * the caller's to clear. */
TP_MUST_USE tp_status tp_settle_from(tp_settling *settling, const fmpq_t shift_x,
                                     tp_message *message);

/* The complaint of TP_SETTLED_TOO_BLIND. */
TP_MUST_USE tp_status tp_settle_fail_blind(tp_place place, tp_message *message);

/* The most turns, for bodies of so many vertices in all. */
long tp_settle_most(long vertices);

#endif
