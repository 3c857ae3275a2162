/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A number estimated from samples, and the interval that covers the true one with the confidence
 * asked for. */

#ifndef TP_STATISTICS_ESTIMATE_H
#define TP_STATISTICS_ESTIMATE_H

typedef struct tp_estimate {
  double value, low, high;
} tp_estimate;

#endif
