/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A twist that is admissible beyond doubt, beside one that some columns do no work against as far
 * as the bits tell. */

#ifndef TP_CERTIFICATE_RELAX_H
#define TP_CERTIFICATE_RELAX_H

#include "certificate/answer.h"
#include "linear_program/scaled.h"

/* Turns the face's twist v into v + 2^(-3/4 bits) w, w a twist of its size against which every edge
 * does work above zero. It is admissible if each of its powers is found to be above zero, a tie of
 * v included, and bounds the limit by nearly as much as v. TP_OPEN where doubles find no such w or
 * a power is not told from zero. The face is then one of no columns. */
tp_answer tp_relax(tp_face *face, const tp_limit_question *question, const tp_scaled *scaled);

#endif
