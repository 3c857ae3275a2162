/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A state on the path: where the block is at a tilt, what its facets do, and how both go on. */

#ifndef TP_QUASI_STATIC_STATE_H
#define TP_QUASI_STATIC_STATE_H

#include "quasi_static/balance.h"

typedef struct tp_path_state {
  double tilt;
  tp_path_pose pose;
  double imbalance;
  tp_facet_state *facets;
  double *strains;     /* of the facets' shear springs, as the next step takes them */
  tp_path_lines lines; /* of the frame of the pose */
  tp_three rate;       /* of the pose by the tilt, in its frame */
} tp_path_state;

/* Without displacement, the stresses those locked in. */
TP_MUST_USE bool tp_path_state_init(tp_path_state *state, const tp_path_model *model, double tilt);
void tp_path_state_clear(tp_path_state *state);
void tp_path_state_copy(tp_path_state *to, const tp_path_state *from, const tp_path_model *model);

/* A good frame for what comes next: where the two facets are that are the least closed. */
tp_path_frame tp_path_state_frame(const tp_path_state *state, const tp_path_model *model);

/* What the facets do at a pose, taken over with their strains. */
void tp_path_state_take(tp_path_state *state, const tp_path_pose *pose, const tp_balance *balance);

/* The equilibrium at a tilt, near the one before; false: none is found. `near`: it must lie
 * as near as rates at both ends tell; without that, `to` and `from` may be one. On failure `to` is
 * none. */
bool tp_path_state_solve(tp_path_state *to, const tp_path_state *from, const tp_path_model *model,
                         double tilt, bool near);

/* Of a facet that slips at a state: does its slip go on as the tilt rises? */
bool tp_path_slip_goes_on(const tp_path_state *state, const tp_path_model *model, long facet);

#endif
