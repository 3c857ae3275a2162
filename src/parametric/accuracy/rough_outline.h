/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A rough block of any number of vertices, the same on every machine, to measure with. */

#ifndef TP_ACCURACY_ROUGH_OUTLINE_H
#define TP_ACCURACY_ROUGH_OUTLINE_H

/* `count` >= 4 vertices, whole numbers below 2^53 for counts up to 10^13, counter-clockwise from
 * (0, 0): a rough underside from left to right, in steps of about 100 and slopes of about half,
 * closed over the top. */
void tp_rough_outline(double *x, double *y, long count);

#endif
