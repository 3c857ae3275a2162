/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The work of the loads on a mechanism over what resists it, v . F(alpha) - K, and the tilt at
 * which it passes zero upwards. Where all loads turn with the tilt that is an arctangent; else one
 * of the zeros that are isolated in balls (load/zeros.h), all of which have to be certain. */

#ifndef TP_CERTIFICATE_EXCESS_H
#define TP_CERTIFICATE_EXCESS_H

#include "certificate/answer.h"

/* v . F - K as a function of the tilt. */
void tp_excess_of(tp_trig *excess, const tp_face *face, const tp_limit_question *question);

/* The tilt at which the loads begin to do more work on the face's twist than is held: into the
 * answer's sine, cosine and degrees. Of several the one nearest to `near_degrees`. */
tp_answer tp_excess_tilt(tp_limit_answer *answer, const tp_face *face,
                         const tp_limit_question *question, double near_degrees);

#endif
