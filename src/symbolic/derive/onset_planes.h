/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Planes that bound the loads at which a mode can begin, as bounds on the tilt: h . w >= 0 is
 * slope tan(alpha) + level >= 0 for the weight (derive/onset_terms.h). */

#ifndef TP_DERIVE_ONSET_PLANES_H
#define TP_DERIVE_ONSET_PLANES_H

#include "derive/onset_modes.h"

typedef struct tp_onset_plane {
  long mode;
  long i, j;   /* rows that span it; of a base that is left, the point i with its normal line */
  int turn;    /* 1: h is row i x row j; -1: the other way */
  bool flat;   /* all of the mode's cone lies in it */
  double cost; /* how long its formula is likely to be */
  arb_t slope, level;
} tp_onset_plane;

typedef struct tp_onset_planes {
  const tp_onset_modes *modes;
  long count, room;
  tp_onset_plane *items; /* mode after mode, within one by cost */
} tp_onset_planes;

/* Those of all modes that are told by no chance; false when memory is exhausted. */
bool tp_onset_planes_init(tp_onset_planes *planes, const tp_onset_modes *modes);
void tp_onset_planes_clear(tp_onset_planes *planes);

/* Slope and level in symbols. */
void tp_onset_plane_work(fmpz_mpoly_q_t slope, fmpz_mpoly_q_t level, const tp_onset_planes *planes,
                         const tp_onset_plane *plane);

/* That all of the mode's cone stays on its side. */
void tp_onset_plane_conditions(tp_conditions *conditions, const tp_onset_planes *planes,
                               const tp_onset_plane *plane);
/* That some of it lies off the plane. */
void tp_onset_plane_solid(tp_conditions *conditions, const tp_onset_planes *planes,
                          const tp_onset_plane *plane);

#endif
