/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Sets of tilts between -90 and 90 degrees: spans, with ends whose order is proven.
 *
 * Two ends that have one source are the same tilt. Two from different sources whose balls overlap
 * are so only where the judge is settled and does not tell them apart. */

#ifndef TP_MOTION_TILTS_H
#define TP_MOTION_TILTS_H

#include "linear_program/cones.h"
#include "number/judge.h"
#include "plane/vector.h"

#include "load/roots.h"
#include "topple.h"

/* Where a bound of loads comes from (motion/bounds.h), and which of its zeros; `mode` is 0 where
 * all modes share it. */
typedef struct tp_source {
  int kind;
  long a, b, root, mode;
} tp_source;

bool tp_source_is_same(const tp_source *a, const tp_source *b);

typedef struct tp_tilt {
  bool endless; /* of an end: there is none within the range */
  arb_t degrees;
  tp_source source;
  unsigned rays; /* of the bound: see tp_bound */
} tp_tilt;

typedef struct tp_tilt_span {
  tp_tilt from, to;
  long mode;
} tp_tilt_span;

typedef struct tp_motion_tilts {
  long count, room;
  tp_tilt_span *items;
} tp_motion_tilts;

void tp_tilt_init(tp_tilt *tilt);
void tp_tilt_clear(tp_tilt *tilt);
void tp_tilt_set(tp_tilt *tilt, const tp_tilt *other);

/* Sign of a - b for tilts that are no ends without end; TP_OPEN_SIGN where open. */
int tp_tilt_compare(const tp_tilt *a, const tp_tilt *b, const tp_judge *judge);

/* Are they one tilt by where they come from, or as exact numbers? */
bool tp_tilt_is_same(const tp_tilt *a, const tp_tilt *b);

void tp_tilts_clear(tp_motion_tilts *spans);
/* Keeps the room. */
void tp_tilts_empty(tp_motion_tilts *spans);
/* A new one, all of the range: NULL when memory is exhausted. */
tp_tilt_span *tp_tilts_add(tp_motion_tilts *spans);

/* Where a function of the tilt that is not zero throughout is not negative; the ends are like
 * `zero`. `log2_scale` is that of its terms. TP_OPEN where its zeros are open; false when memory is
 * exhausted. */
TP_MUST_USE bool tp_tilts_of(tp_motion_tilts *spans, tp_answer *told, const tp_trig *f,
                             const tp_tilt *zero, double log2_scale, const tp_judge *judge);

/* Where a cos + b sin rises or falls through zero between -90 and 90 degrees: an end like `zero`.
 */
void tp_tilt_set_zero(tp_tilt *end, const tp_tilt *zero, const arb_t a, const arb_t b, bool rises,
                      long bits);

/* spans = spans and other; single tilts stay where both bounds there share a ray of `rays`. */
TP_MUST_USE bool tp_tilts_intersect(tp_motion_tilts *spans, tp_answer *told,
                                    const tp_motion_tilts *other, unsigned rays,
                                    const tp_judge *judge);

#endif
