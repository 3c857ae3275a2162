/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* How a frame lies: from its coordinates to level and upright ones. */

#ifndef TP_LOAD_LIE_H
#define TP_LOAD_LIE_H

#include <flint/fmpq.h>
#include <stdbool.h>

/* How a frame lies: which way is up in it, and its point whose level and upright coordinates are
 * its own. In scene lengths. */
typedef struct tp_lie {
  fmpq_t up_x, up_y;
  fmpq_t square; /* of the length of that */
  fmpq_t x, y;
} tp_lie;

void tp_lie_init(tp_lie *lie); /* upright already */
void tp_lie_clear(tp_lie *lie);
/* Which way is up where all is tilted by an angle, the side to the left or to the right lowered;
 * then the length of that. Sine and cosine are cut off after 256 binary digits. */
void tp_lie_tilt(tp_lie *lie, const fmpq_t degrees, bool left);
void tp_lie_measure(tp_lie *lie);
/* A point's level and upright coordinates. */
void tp_lie_of(fmpq_t across, fmpq_t up, const tp_lie *lie, const fmpq_t x, const fmpq_t y);

#endif
