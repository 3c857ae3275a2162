/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The balance of a block on the springs of its contact at one tilt, found by Newton's method.
 *
 * Of a facet with closures a, b at its ends and the strain e of its shear springs along its
 * tangent: normal forces A, B at the ends (facet_stress.h), shear force T = -r l e, r = k_s / k_n,
 * l the closed length. Where |T| would be above tan(phi) (A + B) the facet slips: T is that, and e
 * follows; else e goes with the block. e is the one thing that the past leaves behind, so in a step
 * of any length in which no facet turns from slip to stick the state at its end is exact. */

#ifndef TP_QUASI_STATIC_BALANCE_H
#define TP_QUASI_STATIC_BALANCE_H

#include "quasi_static/frame.h"

typedef enum tp_facet_shear {
  TP_FACET_OPEN,
  TP_FACET_STICKS,
  TP_FACET_SLIPS_ALONG, /* the block along the facet's tangent, or against it */
  TP_FACET_SLIPS_AGAINST
} tp_facet_shear;

typedef struct tp_facet_state {
  bool from_closed, to_closed;
  tp_facet_shear shear;
  double force_from, force_to; /* normal, at the two ends */
  double shear_force;          /* along the tangent */
  double closed;               /* the share of the length that is closed */
  double strain;               /* of the shear springs, e */
} tp_facet_state;

/* How the ends of a facet move along its normal, and it along its tangent, with the coordinates of
 * a frame; and how forces there act on them (tp_path_along). */
typedef struct tp_facet_lines {
  tp_three from, to, tangent;
} tp_facet_lines;

typedef struct tp_path_lines {
  tp_path_frame frame;
  tp_three x, y; /* of the centroid */
  tp_facet_lines *facets;
} tp_path_lines;

/* Of a frame, where they are not yet. */
void tp_path_lines_set(tp_path_lines *lines, const tp_path_model *model,
                       const tp_path_frame *frame);

typedef struct tp_balance {
  const tp_path_model *model;
  const tp_path_lines *lines; /* of the frame of all poses */
  tp_three load;              /* about the centroid */
  const double *strains;      /* e of each facet before the step */
  /* A drag in proportion to mass against the motion since the last step in time, of this length, in
   * units in which a force of one weight moves the block by one unit; 0: none. */
  double over_time;
} tp_balance;

typedef struct tp_matrix {
  double of[3][3];
} tp_matrix;

/* The force that is out of balance at a pose, on its coordinates; minus its derivative by them;
 * what rounding may make of the force. `states`, where not NULL, of every facet. */
typedef struct tp_imbalance {
  tp_three force;
  tp_matrix stiffness;
  double rounding;
} tp_imbalance;
void tp_balance_at(tp_imbalance *imbalance, const tp_balance *balance, const tp_path_pose *pose,
                   tp_facet_state *states);

/* A pose in balance, searched for from the one given; false: none is found, and `pose` is as it
 * was. `imbalance` is that which is left. */
bool tp_balance_solve(tp_path_pose *pose, double *imbalance, const tp_balance *balance);

/* Solve matrix x = right; false where it is singular. */
bool tp_matrix_solve(tp_three *x, const tp_matrix *matrix, const tp_three *right);

/* Has it a determinant above 0? */
bool tp_matrix_is_positive(const tp_matrix *matrix);

#endif
