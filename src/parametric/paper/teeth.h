/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Regularly toothed blocks by the general parameters of section 5.1 of Alejano et al. */

#ifndef TP_PAPER_TEETH_H
#define TP_PAPER_TEETH_H

#include "topple.h"

typedef enum tp_toe_kind { TP_TOE_PLANAR, TP_TOE_PEAK, TP_TOE_VALLEY } tp_toe_kind;

extern const char *const tp_toe_names[3];

static const double tp_degrees_of_radian = 57.29577951308232; /* 180 / pi */

/* A block of mean height 1. */
typedef struct tp_toothed {
  double inverse_slenderness; /* dx / y */
  double amplitude;           /* A / y; 0: a slab */
  size_t sub_blocks;          /* N = 2 dx / lambda, so that lambda = 2 dx / N */
} tp_toothed;

/* What is asked of a block that leans on the axis of a toe, towards the left. */
typedef struct tp_toothed_question {
  tp_toothed block;
  tp_toe_kind toe;
  double friction_deg; /* 0: none is given */
  double tilt_deg;     /* 0: none is given */
} tp_toothed_question;

/* Solve the exact block, on a base that ends with it; with friction and without a tilt, with the
 * motions that can begin at every tilt. */
TP_MUST_USE tp_status tp_toothed_solve(tp_solution **solution, const tp_toothed_question *question,
                                       tp_message *message);

/* The critical angle of toppling about the toe, by solving the exact block. */
TP_MUST_USE tp_status tp_toothed_critical_angle(tp_bounded *degrees, const tp_toothed *block,
                                                tp_toe_kind toe, tp_message *message);

/* Where, at one block, one motion takes over from another: bits as in tp_motion_range. */
typedef struct tp_toothed_border {
  double inverse_slenderness;
  tp_bounded tilt_deg;
  unsigned below, above;
} tp_toothed_border;

/* Those of a question with friction, above level, into `borders` from `*count` on, which has room
 * for `room`. */
TP_MUST_USE tp_status tp_toothed_borders(tp_toothed_border *borders, size_t *count, size_t room,
                                         const tp_toothed_question *question, tp_message *message);

/* Its tangent by the general equations behind Eqs. (15) to (17): (dx / y) / (1 -+ A/y -
 * A^2 / (12 y^2)), upper sign about a peak; amplitude up to 0.5. Exact for an even N. */
tp_bounded tp_toothed_tangent(const tp_toothed *block, tp_toe_kind toe);

/* tan of an angle, 0 < degrees < 90, and of one with a bound. */
tp_bounded tp_tangent_deg(tp_bounded degrees);

tp_bounded tp_quotient(tp_bounded numerator, tp_bounded denominator);

#endif
