/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Two exact numbers: how far apart they are, and those on the way from one to the other. */

#ifndef TP_NUMBER_BETWEEN_H
#define TP_NUMBER_BETWEEN_H

#include <flint/fmpq.h>

/* one - other, rounded once. */
double tp_ratio_apart(const fmpq_t one, const fmpq_t other);

/* from + share (to - from). */
void tp_ratio_between(fmpq_t value, const fmpq_t from, const fmpq_t to, const fmpq_t share);

#endif
