/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The proof of a limit from the two columns of a basis of its linear program: the twist that does
 * no work against either is admissible, the loads do work on it beyond one tilt, and there both
 * columns bear forces that are not negative. By duality no base bears more, and this one bears as
 * much. */

#ifndef TP_CERTIFICATE_PROVE_H
#define TP_CERTIFICATE_PROVE_H

#include "certificate/answer.h"
#include "linear_program/basis.h"

/* TP_NO where the two columns of the basis are not the right ones; TP_OPEN where more bits are
 * needed. `drive` is how the loads change as the tilt grows. */
tp_answer tp_prove_limit(tp_limit_answer *answer, const tp_limit_question *question,
                         const tp_scaled *scaled, const tp_basis *basis, const tp_vector *drive,
                         double near_degrees);

#endif
