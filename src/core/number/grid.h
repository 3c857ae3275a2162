/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Rationals rounded to a grid of a power of two. */

#ifndef TP_NUMBER_GRID_H
#define TP_NUMBER_GRID_H

#include <flint/fmpq.h>

/* To the nearest multiple of 2^exponent, up where two are as near. */
void tp_round_to_grid(fmpq_t value, long exponent);

#endif
