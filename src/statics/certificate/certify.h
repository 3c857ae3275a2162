/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What a search in doubles leaves open where the loads do not all turn with the tilt: that a limit
 * is the first from level, that the block holds at every tilt or at none. Proven over intervals of
 * tilts (interval.h), or open. */

#ifndef TP_CERTIFICATE_CERTIFY_H
#define TP_CERTIFICATE_CERTIFY_H

#include "certificate/answer.h"
#include "linear_program/scaled.h"

/* A tilt at which the loads are borne: the limit, or the lower end of the bracket about it. */
void tp_certify_held_end(arb_t end, const tp_limit_answer *limit);

/* Does the base bear the loads from `start` up to the limit of the answer, or with NULL for it up
 * to the end of the range? `start` NULL is level; otherwise they are borne there, as they are at
 * the limit. TP_NO: doubles found a tilt `*lost` where not,
 * and `*held` before it where they do. */
tp_answer tp_certify_holds(double *held, double *lost, const tp_limit_question *question,
                           tp_scaled *scaled, const arb_t start, const tp_limit_answer *limit);

/* Does nothing hold the block from the limit of the answer, which is below level, to as far above
 * level? */
tp_answer tp_certify_infeasible(const tp_limit_question *question, tp_scaled *scaled,
                                const tp_limit_answer *limit);

/* Does nothing hold it at any tilt of the range? */
tp_answer tp_certify_never(const tp_limit_question *question, tp_scaled *scaled);

#endif
