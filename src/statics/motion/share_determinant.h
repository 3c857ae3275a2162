/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* det(a, b, c) of three vectors that are linear functions of the share of strength. */

#ifndef TP_MOTION_SHARE_DETERMINANT_H
#define TP_MOTION_SHARE_DETERMINANT_H

#include "motion/share_spans.h"
#include "plane/vector.h"

/* A linear function of the share in balls, at + share rise. */
typedef struct tp_ball_line {
  tp_vector at, rise;
} tp_ball_line;

/* at + s rise; forces of one site, from 1 on, act through one point, and parallel ones along one
 * direction, so that three of them span no solid; 0: of none. */
typedef struct tp_share_line {
  tp_near at[3], rise[3];
  long site, parallel;
  const tp_ball_line *balls; /* the same, or NULL */
} tp_share_line;

/* As a polynomial; a coefficient that its bound does not tell from zero is none. Where the vectors
 * have balls, these are asked first. */
tp_share_polynomial tp_share_determinant(const tp_share_line *a, const tp_share_line *b,
                                         const tp_share_line *c, long bits);

#endif
