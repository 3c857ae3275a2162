/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The tilt at which no forces hold the block any more, searched in doubles: a proposal for
 * limit/near.h to prove. */

#ifndef TP_LIMIT_SEARCH_H
#define TP_LIMIT_SEARCH_H

#include "certificate/question.h"
#include "linear_program/scaled.h"

/* In doubles: the first tilt from level at which nothing holds the block any more, looking at every
 * degree and halving between two. Where level ground does not do: of the tilts that do those
 * nearest to it, above or below, and where nothing does after those. Unproven (certify.h). */
typedef enum tp_search_found {
  TP_SEARCH_TILT,
  TP_SEARCH_HOLDS_ALWAYS,
  TP_SEARCH_HOLDS_NEVER,
  TP_SEARCH_OPEN /* doubles are too short for this scene */
} tp_search_found;

typedef struct tp_search_tilts {
  double before, held; /* the first tilt that was found to hold, and one before it that does not:
                          both 0 where level ground holds */
  double fails;        /* where it does */
} tp_search_tilts;

/* Counts the work of it: false where too much is spent. */
bool tp_search_pay(const tp_limit_question *question, const tp_scaled *scaled);

tp_search_found tp_search_near(tp_search_tilts *tilts, tp_scaled *scaled,
                               const tp_limit_question *question);

/* By halving, where nothing holds any more between a tilt that holds and one that does not. */
double tp_search_between(tp_scaled *scaled, const tp_limit_question *question, double holds,
                         double fails);

#endif
