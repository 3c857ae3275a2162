/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Cosine p / k and sine q / k of a direction in whole numbers, k the root of p^2 + q^2. Where that
 * is no whole number k is cut off after TP_DIRECTION_BITS binary digits: the direction stays exact,
 * and lengths that are turned by it come out too long by a share of less than 2^-TP_DIRECTION_BITS,
 * as k is at least 1. */

#ifndef TP_PLANE_DIRECTION_H
#define TP_PLANE_DIRECTION_H

#include <flint/fmpq.h>

enum { TP_DIRECTION_BITS = 256 };

/* Of (u, v), other than zero. */
void tp_direction_unit(fmpq_t cosine, fmpq_t sine, const fmpq_t u, const fmpq_t v);

#endif
