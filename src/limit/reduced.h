/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A contact whose strength is divided by a factor, and its limit. */

#ifndef TP_REDUCED_H
#define TP_REDUCED_H

#include "limit/limit.h"
#include "limit/sketch.h"

/* The strength as given, to be divided. */
typedef struct tp_reduced {
  const tp_limit_question *question;
  tp_cones *cones;
  arb_t friction; /* as given */
  arb_ptr bounds; /* shear and pull of each allowance, as given */
  const tp_sketch *given;
  tp_sketch reduced; /* the caller's copy */
  double degrees;    /* the tilt */
} tp_reduced;

/* Keeps the strength of the cones; `clear` gives it back to them. */
void tp_reduced_init(tp_reduced *reduced);
void tp_reduced_clear(tp_reduced *reduced);

/* Limit less tilt in doubles, by the logarithm of the factor: it falls. Where forces hold the block
 * at every tilt, at 90 degrees as well, the limit counts as 180. */
double tp_reduced_margin(tp_reduced *reduced, double log_factor);

/* The limit at a factor, in degrees, and on which side of the tilt it is proven to lie: 1 where the
 * block holds beyond the tilt, -1 where not up to it, 0 open. */
typedef struct tp_reduced_limit {
  int side;
  arb_t degrees; /* where there is one */
  bool has_motion;
  tp_face_motion motion; /* at that limit */
} tp_reduced_limit;

tp_limit_outcome tp_reduced_find(tp_reduced_limit *limit, tp_reduced *reduced, const arf_t factor,
                                 const arb_t degrees);

/* The side alone. */
tp_limit_outcome tp_reduced_side(int *side, tp_reduced *reduced, const arf_t factor,
                                 const arb_t degrees);

#endif
