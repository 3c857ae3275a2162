/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What a load does to the block as the table tilts.
 *
 * In the block's frame, x mirrored towards the right so that the down-dip side is always -x, the
 * components of a force and its moment (counter-clockwise: overturning) are sums over the basis
 * cos a, sin a, 1, 1 / cos a, 1 / cos^2 a of the tilt a (docs/mechanics.md section 5). Loads fixed
 * to the block give constants; gravity and pseudo-static forces cosines and sines; a level of water
 * that stays horizontal the rest. SI units. */

#ifndef TP_LOAD_WRENCH_H
#define TP_LOAD_WRENCH_H

#include <arb.h>

enum { TP_COS, TP_SIN, TP_ONE, TP_SEC, TP_SEC2, TP_BASIS };

typedef struct tp_trig {
  arb_struct of[TP_BASIS];
} tp_trig;

void tp_trig_init(tp_trig *f);
void tp_trig_clear(tp_trig *f);
void tp_trig_add(tp_trig *sum, const tp_trig *f, long bits);
/* sum += factor f */
void tp_trig_addmul(tp_trig *sum, const tp_trig *f, const arb_t factor, long bits);
void tp_trig_submul(tp_trig *sum, const tp_trig *f, const arb_t factor, long bits);

/* At the tilt with this sine and cosine. */
void tp_trig_evaluate(arb_t value, const tp_trig *f, const arb_t sine, const arb_t cosine,
                      long bits);

/* Force, and moment about the origin. */
typedef struct tp_wrench {
  tp_trig x, y, moment;
} tp_wrench;

void tp_wrench_init(tp_wrench *wrench);
void tp_wrench_clear(tp_wrench *wrench);

/* A force whose components are given, at a point: adds them and their moment. */
void tp_wrench_add_force(tp_wrench *wrench, const tp_trig *fx, const tp_trig *fy, const arb_t x,
                         const arb_t y, long bits);

/* The moment about a point: M - (x F_y - y F_x). */
void tp_wrench_moment(tp_trig *moment, const tp_wrench *wrench, const arb_t x, const arb_t y,
                      long bits);

/* log2 of the largest term of its force. */
double tp_wrench_force_log2(const tp_wrench *wrench);

#endif
