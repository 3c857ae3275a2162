/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The motion along a step, by the polynomial of fifth degree through place, speed and acceleration
 * at both ends, and the first moment on it at which a gap closes. What is found here is refined by
 * steps from the same begin (rigid_contact/watch.h). */

#ifndef TP_RIGID_CONTACT_ALONG_H
#define TP_RIGID_CONTACT_ALONG_H

#include "rigid_contact/smooth.h"

enum { TP_LOOKS = 8 };

/* With the states at even parts of it, at which everything is looked at. */
typedef struct tp_along {
  double step;
  double from[TP_MOTION_NUMBERS], from_rates[TP_MOTION_NUMBERS];
  double to[TP_MOTION_NUMBERS], to_rates[TP_MOTION_NUMBERS];
  tp_motion_state looks[TP_LOOKS + 1];
  tp_turned_block blocks[TP_LOOKS + 1];
} tp_along;

/* Fills in the looks. */
void tp_along_look(tp_along *along);

tp_motion_state tp_along_at(const tp_along *along, double share);

/* How far the block moves and turns up to one of the looks, at most: between two of them it leaves
 * the straight way by an eighth of the acceleration times the square of the time, for which twice
 * that at the ends of the step is taken. */
double tp_along_reach(const tp_along *along, int looks);

/* A gap, and by how much it may be below 0 without having closed. */
typedef struct tp_slack_gap {
  const tp_contact_shapes *shapes;
  const tp_gap_pair *pair;
  double slack;
  bool beyond; /* it begins beneath the line of a straight face, beyond its end */
} tp_slack_gap;

/* Shares of the step: the last look before a gap was below zero, and where it was. */
typedef struct tp_gap_span {
  double sound, below;
} tp_gap_span;

/* Is it below zero at a look, or where it is least between two? Looks that begin behind a share of
 * the step are left out. */
/* Its width, with the slack; of one that begins beyond its face above 0 as long as it is there. */
double tp_slack_gap_width(const tp_slack_gap *gap, const tp_turned_block *block);

bool tp_gap_span_find(tp_gap_span *found, const tp_along *along, const tp_slack_gap *gap,
                      double until);

/* Where it closes, by the polynomial. */
double tp_gap_span_share(const tp_gap_span *found, const tp_along *along, const tp_slack_gap *gap);

#endif
