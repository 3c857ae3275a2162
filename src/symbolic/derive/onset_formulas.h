/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The onset of motion in symbols (docs/onset.md): the tilt at which a plane that bounds the loads
 * of the first motion lets the weight through.
 *
 * At the plane of two rows g_i, g_j with h = g_i x g_j the weight leaves it at tan(alpha) = T with
 * h . w = 0. T is the onset where
 *
 *   - the same contacts close, stick and slip in the same sense in every motion
 *     (tp_onset_modes_conditions);
 *   - w(T) = mu g_i + nu g_j with mu, nu > 0, some other row g_k of the mode has h . g_k > 0, and
 *     h . w grows with the tilt: just beyond T w lies inside the mode's cone, so that it begins;
 *   - up to T no mode begins. A motion a takes the energy a . M a > 0, which the weight must give
 *     it, a . w, as friction takes some: where a . w is not above zero for its rays, level and at
 * T, and so between, a mode does not begin. Nor does it where a plane has all its rows on one side
 *     and the weight on the other, level and at T; or two such planes of which the weight does not
 *     reach one before it has passed the other.
 *
 * All of it is signs of polynomials, each of which is what it is at the scene's values: conditions.
 * They are enough; the formula may hold beyond them. */

#ifndef TP_DERIVE_ONSET_FORMULAS_H
#define TP_DERIVE_ONSET_FORMULAS_H

#include "derive/onset_planes.h"

typedef struct tp_onset_formulas {
  tp_onset_terms terms;
  tp_onset_modes modes;
  tp_onset_planes planes;
  const tp_onset_plane *begins; /* the plane, of the mode */
  fmpz_mpoly_q_t tangent;
  tp_conditions conditions;
} tp_onset_formulas;

/* What is asked: the onset at the scene's values, above 0 degrees. */
typedef struct tp_onset_wanted {
  const tp_model *model;
  tp_direction towards;
  long friction; /* the symbol tan(phi) */
  tp_bounded degrees;
  bool positive; /* all parameters are */
} tp_onset_wanted;

/* NULL, or why there is no formula, as a static string; then nothing is to be cleared. `*failed` is
 * set when memory is exhausted. */
const char *tp_onset_formulas_init(tp_onset_formulas *formulas, const tp_onset_wanted *wanted,
                                   bool *failed);
void tp_onset_formulas_clear(tp_onset_formulas *formulas);

#endif
