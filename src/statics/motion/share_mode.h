/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A mode as a function of the share s of strength, of tan(phi), cohesion and bonds alike, at one
 * tilt, and whether it can begin with a share.
 *
 * It can where the loads w are a sum of its generators (motion/bounds.h) with factors that are not
 * negative, and of what is free with factors from -1 to 1. By Caratheodory three of them will do,
 * g, all that is free besides at a bound: the factor of g_0 is det(w, g_1, g_2) / det(g_0, g_1,
 * g_2). Each of these vectors is a linear function of s. */

#ifndef TP_MOTION_SHARE_MODE_H
#define TP_MOTION_SHARE_MODE_H

#include "motion/mode.h"
#include "motion/share_determinant.h"

enum {
  TP_SHARE_LINES = 24,
  TP_SHARE_FREE = 4,
  TP_SHARE_ALL_LINES = TP_SHARE_LINES + TP_SHARE_FREE
};

/* A mode at one tilt. In the interior there are no generators but planes h, as many as the contact
 * has, with h . w >= 0 of each. */
typedef struct tp_share_mode {
  tp_mechanism mechanism;
  bool interior;
  const tp_share_line *planes;
  long plane_count;
  int ray_count, count; /* of the generators, rays first, */
  int free_count;       /* and of what is free, behind them */
  tp_share_line loads;
  const tp_share_line *of[TP_SHARE_ALL_LINES];
  tp_share_line own[TP_SHARE_ALL_LINES]; /* room for those that no other mode has */
  tp_ball_line *sum; /* room for loads and what is free at its bounds, if there are balls */
  long bits;         /* of the balls */
} tp_share_mode;

/* Can it begin with this share? 1, or -1: no; both proven; 0 where that is open. */
int tp_share_mode_side(const tp_share_mode *mode, double share);

/* ---- its choices of three ----------------------------------------------------------------------
 */

/* Three of the generators and of what is free, the rest of that at its bounds. */
typedef struct tp_share_choice {
  int of[3];
  unsigned bounds; /* bit k: the k-th of what is free, not among the three, is at 1, else at -1 */
} tp_share_choice;

/* The next one: sets of three in their order, each with all bounds; false after the last. */
bool tp_share_choice_next(tp_share_choice *choice, const tp_share_mode *mode);

static inline bool tp_share_choice_is_free(const tp_share_mode *mode, int k) {
  return k >= mode->count;
}

/* Forces through one point, or along one direction, span no solid; with a ray each two of them do.
 */
bool tp_share_choice_is_flat(const tp_share_mode *mode, const int of[3]);

/* The lines of a mode at a share, or for all of an interval. */
typedef struct tp_share_values {
  tp_near loads[3], of[TP_SHARE_ALL_LINES][3];
} tp_share_values;

void tp_share_values_at(tp_share_values *values, const tp_share_mode *mode, tp_near share);

/* The loads as a sum of three: 1, or -1: they are none; 0 where it is open. */
int tp_share_choice_side(const tp_share_mode *mode, const tp_share_values *values,
                         const tp_share_choice *choice);

#endif
