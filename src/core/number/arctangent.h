/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The direction of a vector in degrees by double arithmetic alone, with a proven bound: the same
 * bits on every machine, where the atan2 of a C library promises neither. */

#ifndef TP_NUMBER_ARCTANGENT_H
#define TP_NUMBER_ARCTANGENT_H

/* The bound, as a share of the angle: 2^-49. */
#define TP_ARCTANGENT_ERROR 0x1p-49

/* atan2(y, x) in degrees, -180 to 180, for y and x that are 0 or between 2^-450 and 2^450 in size,
 * not both 0. The errors of y and x are the caller's to add. */
double tp_arctangent_degrees(double y, double x);

#endif
