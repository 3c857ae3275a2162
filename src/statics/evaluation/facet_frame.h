/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Forces along and across the facet that a block slides on under loads: with s the direction of
 * motion along it and n its normal. */

#ifndef TP_EVALUATION_FACET_FRAME_H
#define TP_EVALUATION_FACET_FRAME_H

#include "evaluation/evaluation.h"
#include "load/wrench.h"

/* size s = (-run, rise) and size n = (rise, run), exact: forces count times `size`, cohesion too.
 */
typedef struct tp_facet_frame {
  arb_t run, rise, friction, cohesion;
} tp_facet_frame;

/* With a friction angle in degrees and the cohesion of the whole contact. */
void tp_facet_frame_init(tp_facet_frame *frame, const tp_evaluation *evaluation, const fmpz_t run,
                         const fmpz_t rise, const arb_t friction);
void tp_facet_frame_clear(tp_facet_frame *frame);

/* along += F . s, pressing -= F . n, times the size of s and n. */
void tp_facet_frame_resolve(tp_trig *along, tp_trig *pressing, const tp_wrench *wrench,
                            const tp_facet_frame *frame, long bits);

#endif
