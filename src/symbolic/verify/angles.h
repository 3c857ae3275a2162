/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Sines, cosines and tangents of sums of a subject's angles, as rational functions. */

#ifndef TP_VERIFY_ANGLES_H
#define TP_VERIFY_ANGLES_H

#include "verify/subject.h"

/* Sine and cosine of a rational function that is a whole multiple of angles and right angles; false
 * where it is none. */
bool tp_angle_sine_cosine(fmpz_mpoly_q_t sine, fmpz_mpoly_q_t cosine, const fmpz_mpoly_q_t angle,
                          const tp_subject *subject);
/* Its tangent, for halves of angles too; `*infinite`: a right angle. */
bool tp_angle_tangent(fmpz_mpoly_q_t tangent, bool *infinite, const fmpz_mpoly_q_t angle,
                      const tp_subject *subject);

#endif
