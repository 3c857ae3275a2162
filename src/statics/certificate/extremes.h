/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Proofs that there is no limit, for loads F_c cos + F_s sin: forces hold the block at every tilt,
 * by three that balance F_s, or at none, by a twist with v . F_s = 0 < v . F_c that nothing
 * resists. Both are looked for in doubles and proven in balls (certificate/equilibrium.h, face.h).
 */

#ifndef TP_CERTIFICATE_EXTREMES_H
#define TP_CERTIFICATE_EXTREMES_H

#include "certificate/question.h"
#include "linear_program/basis.h"

/* Do three forces hold the block upright, tilted by 90 degrees? The set of wrenches that the base
 * balances is convex, so one that holds level and upright holds between. Those that the doubles of
 * the scaled find are tried, then the columns that grow without end in an exact program. */
tp_answer tp_extremes_interlocked(const tp_limit_question *question, tp_scaled *scaled,
                                  const tp_basis *growing);

/* Is there a twist that no contact resists and on which the loads do the same work, above zero, at
 * every tilt (but for the factor cos)? Under the weight alone one that sinks straight down, or
 * turns about a centre level with the centroid. */
tp_answer tp_extremes_nowhere(const tp_limit_question *question, tp_scaled *scaled);

#endif
