/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A probability with its complement, each right by itself: 1 - q knows nothing of a small q. */

#ifndef TP_SAMPLING_TAILS_H
#define TP_SAMPLING_TAILS_H

/* The probability of no more than a number, and of more. */
typedef struct tp_tails {
  double p, q; /* p + q = 1 */
} tp_tails;

#endif
