/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Motions that can begin: found by letting the blocks go, then proven. Along a number x, a divisor
 * of strength or a tilt, a motion that is proven is followed down to the least x at which its
 * contacts do the same, and from there the next one. */

#ifndef TP_BLOCK_SYSTEM_MOVING_H
#define TP_BLOCK_SYSTEM_MOVING_H

#include "block_system/blocks_at.h"
#include "contact_modes/beginning.h"
#include "contact_modes/letting_go.h"

/* The state at x; `exists`, or there is none. */
typedef tp_status tp_moving_state(bool *exists, tp_blocks_at *at, const void *context, double x,
                                  tp_message *message);

typedef struct tp_moving_search {
  const tp_resting *resting;
  tp_moving_state *state;
  const void *context;
  tp_blocks_at at;
  tp_letting_go letting_go;
  tp_rigid_groups groups;
  tp_mode_set *modes;    /* as the blocks were let go */
  tp_trial_mode *trial;  /* of what is tried */
  bool found;            /* a motion is proven: */
  double x;              /* there; else an infinity */
  tp_trial_mode *proven; /* its modes, by contact */
  double *accelerations; /* and its accelerations, by row */
  double *tried;         /* room for those */
} tp_moving_search;

/* On failure cleared. */
TP_MUST_USE tp_status tp_moving_init(tp_moving_search *moving, const tp_resting *resting,
                                     tp_moving_state *state, const void *context,
                                     tp_message *message);
void tp_moving_clear(tp_moving_search *moving);

/* Let go at x, from no forces or from those there are; found, where that is a motion. */
TP_MUST_USE tp_status tp_moving_try(tp_moving_search *moving, double x, bool from_nothing,
                                    tp_message *message);
/* From no forces in half of the ways: of very many blocks each one takes long. */
TP_MUST_USE tp_status tp_moving_try_few(tp_moving_search *moving, double x, tp_message *message);

/* Are these modes, or those next to them, those of a motion at x? Then it is found. */
TP_MUST_USE tp_status tp_moving_prove(tp_moving_search *moving, double x,
                                      const tp_trial_mode *trial, tp_message *message);
TP_MUST_USE tp_status tp_moving_prove_modes(tp_moving_search *moving, double x,
                                            const tp_mode_set *modes, tp_message *message);

/* From the motion that is found down to `least`, to such a width. */
TP_MUST_USE tp_status tp_moving_follow(tp_moving_search *moving, double least, double width,
                                       tp_message *message);

#endif
