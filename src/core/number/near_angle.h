/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Sine, cosine and arctangent of doubles that carry bounds: the same bits on every machine, where
 * those of a C library are not promised to be.
 *
 * Up to 45 degrees the series of sine and cosine in x, by Horner's rule, to x^19 and x^18; what is
 * left out of an alternating series of falling terms is below its first term, x^21 / 21! and
 * x^20 / 20!, less than 1e-20 at pi/4. Beyond 45 degrees those of what is left to 90. */

#ifndef TP_NUMBER_NEAR_ANGLE_H
#define TP_NUMBER_NEAR_ANGLE_H

#include "number/near.h"

/* Of an angle from -90 to 90 degrees; beyond, nothing is told: infinite errors. */
void tp_near_sin_cos(tp_near *sine, tp_near *cosine, tp_near degrees);

/* The angle in degrees that has the tangent, between -90 and 90: of a size between 2^-400 and
 * 2^400, or 0. */
tp_near tp_near_arctangent(tp_near tangent);

#endif
