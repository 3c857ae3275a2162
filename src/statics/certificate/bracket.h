/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The proof of a limit that needs no zero to be told from what is nearly one: the base bears the
 * loads a hair below it, and an admissible twist shows that it does not a hair above. */

#ifndef TP_CERTIFICATE_BRACKET_H
#define TP_CERTIFICATE_BRACKET_H

#include "certificate/answer.h"
#include "linear_program/scaled.h"

/* About the answer's tilt, as found by mechanisms that tie as far as the bits tell: its `degrees`
 * become the bracket, about 2^(-bits/2) degrees wide, or up to 2^(-bits/4) where less is not
 * proven. */
tp_answer tp_bracket_limit(tp_limit_answer *answer, const tp_limit_question *question,
                           tp_scaled *scaled);

#endif
