/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Tilts: where a mechanism starts, and about where the block lets go. */

#ifndef TP_SEARCH_H
#define TP_SEARCH_H

#include "limit/basis.h"

/* Do all loads turn with the tilt, with no bounded force in play: is the limit one linear program
 * in tan(tilt)? */
bool tp_search_is_linear(const tp_limit_question *question);

/* The share of the loads that goes with one function of the tilt, and the loads at a tilt. */
void tp_search_load_term(tp_vector *term, const tp_wrench *load, int basis);
void tp_search_load_at(tp_vector *wrench, const tp_wrench *load, const arb_t sine,
                       const arb_t cosine, long bits);
void tp_search_load_at_degrees(tp_vector *wrench, const tp_limit_question *question,
                               const arb_t degrees);

/* v . F - K as a function of the tilt. */
void tp_search_excess(tp_trig *excess, const tp_face *face, const tp_limit_question *question);

/* The tilt at which the loads begin to do more work on the face's twist than is held: into the
 * answer's sine, cosine and degrees. Of several the one nearest to `near_degrees`. */
tp_answer tp_search_tilt(tp_limit_answer *answer, const tp_face *face,
                         const tp_limit_question *question, double near_degrees);

/* In doubles: the first tilt from level at which nothing holds the block any more, looking at every
 * degree and halving between two. Where level ground does not do: of the tilts that do those
 * nearest to it, above or below, and where it lets go after those. Unproven (certify.h). */
typedef enum tp_search_found {
  TP_SEARCH_TILT,
  TP_SEARCH_HOLDS_ALWAYS,
  TP_SEARCH_HOLDS_NEVER,
  TP_SEARCH_OPEN /* doubles are too short for this scene */
} tp_search_found;

typedef struct tp_search_tilts {
  double before, held; /* the first tilt that was found to hold, and one before it that does not:
                          both 0 where level ground holds */
  double lets_go;      /* where it does */
} tp_search_tilts;

/* Counts the work of it: false where too much is spent. */
bool tp_search_pay(const tp_limit_question *question, const tp_sketch *sketch);

tp_search_found tp_search_near(tp_search_tilts *tilts, tp_sketch *sketch,
                               const tp_limit_question *question);

/* By halving, where the block lets go between a tilt that holds and one that does not. */
double tp_search_between(tp_sketch *sketch, const tp_limit_question *question, double holds,
                         double fails);

#endif
