/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* With which share s of its strength, tan(phi), cohesion and bonds alike, can a mode begin at one
 * tilt?
 *
 * It can where the loads w are a sum of its generators (motion/bounds.h) with factors that are not
 * negative, and of what is free with factors from -1 to 1. By Caratheodory three of them will do,
 * g, all that is free besides at a bound: the factor of g_0 is det(w, g_1, g_2) / det(g_0, g_1,
 * g_2). Each of these vectors is a linear function of s, so that the determinants are polynomials
 * of the third degree at most, and between their zeros nothing changes.
 *
 * The zeros are searched in doubles; that a mode can begin with a share, or cannot, is proven in
 * doubles with bounds, or left open. A coefficient that doubles do not tell from zero is asked of
 * balls, where the mode has them. */

#ifndef TP_MOTION_MODE_SHARES_H
#define TP_MOTION_MODE_SHARES_H

#include "motion/mode.h"
#include "motion/share_determinant.h"

enum { TP_SHARE_LINES = 24, TP_SHARE_FREE = 4 };

/* A mode at one tilt. In the interior there are no generators but planes h, as many as the contact
 * has, with h . w >= 0 of each. */
typedef struct tp_share_mode {
  tp_mechanism mechanism;
  bool interior;
  const tp_share_line *planes;
  long plane_count;
  int ray_count, count; /* of the generators, rays first, */
  int free_count;       /* and of what is free, behind them */
  tp_share_line loads, of[TP_SHARE_LINES + TP_SHARE_FREE];
  tp_ball_line *sum; /* room for loads and what is free at its bounds, if there are balls */
  long bits;         /* of the balls */
} tp_share_mode;

/* Adds the shares at which the mode can begin, as doubles have it; false when memory is exhausted.
 */
TP_MUST_USE bool tp_share_spans_add(tp_share_spans *spans, const tp_share_mode *mode);
/* The same, those left out of which no share lies from 1 / ratio to the ratio: cheaper. */
TP_MUST_USE bool tp_share_spans_add_near(tp_share_spans *spans, const tp_share_mode *mode,
                                         double ratio);

/* Can it begin with this share? 1, or -1: no; both proven; 0 where that is open. */
int tp_share_mode_side(const tp_share_mode *mode, double share);

#endif
