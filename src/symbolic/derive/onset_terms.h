/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What the onset of motion is made of, in symbols (motion/ says the same in numbers): contact
 * points, the weight, and what accelerates the block.
 *
 * About the scene's origin, with W = 3 A2 and the sums of formulas.h, all over the weight per W:
 *
 *     W w(alpha) = -(W sin, W cos, X6 cos - Y6 sin),
 *     2 W M r = (2 (W v_x - Y6 theta), 2 (W v_y + X6 theta), 2 (X6 v_y - Y6 v_x) + P12 theta)
 *
 * for the twist r = (v_x, v_y, theta), P12 twelve times the polar second moment. */

#ifndef TP_DERIVE_ONSET_TERMS_H
#define TP_DERIVE_ONSET_TERMS_H

#include "derive/limit_formulas.h"
#include "motion/twists.h"

/* A sign that is told by no identity, and not by the values either: zero by chance, or nearly. */
enum { TP_SIGN_BY_CHANCE = 2 };

typedef struct tp_onset_terms {
  const tp_model *model;
  const tp_field *field;
  tp_direction towards;
  long friction;  /* the symbol tan(phi) */
  arb_ptr values; /* of all symbols, at `bits` */
  long bits;
  tp_weight_formulas weight;
  fmpz_mpoly_q_t polar12;
  tp_cones cones;                /* at the values */
  tp_contacts_formulas contacts; /* by point of the cones */
} tp_onset_terms;

/* NULL, or why there are none, as a static string; then nothing is to be cleared. `*failed` is set
 * when memory is exhausted. */
const char *tp_onset_terms_init(tp_onset_terms *terms, const tp_model *model, tp_direction towards,
                                long friction, bool *failed);
void tp_onset_terms_clear(tp_onset_terms *terms);

/* Of a contact point: h with h . a the velocity of a twist a along its normal; g along t; and -e,
 * the force on the block along an edge of its cone turned round. */
void tp_onset_terms_normal(tp_vector_formulas *h, const tp_onset_terms *terms, long point);
void tp_onset_terms_slip(tp_vector_formulas *g, const tp_onset_terms *terms, long point);
void tp_onset_terms_force(tp_vector_formulas *force, const tp_onset_terms *terms, long point,
                          bool against);

/* M r of a twist. */
void tp_onset_terms_inertia(tp_vector_formulas *inertia, const tp_onset_terms *terms,
                            const tp_vector_formulas *twist);

/* h . w = slope tan(alpha) + level, over cos(alpha). */
static inline void tp_onset_terms_work(fmpz_mpoly_q_t slope, fmpz_mpoly_q_t level,
                                       const tp_onset_terms *terms,
                                       const fmpz_mpoly_q_struct h[3]) {
  const tp_weight_formulas *own = &terms->weight;
  tp_symbol_weight_power(slope, level, h, own->w, own->x6, own->y6, terms->field);
}

/* Sign of a value: 1, -1, 0 where it is nothing for all values of the symbols, or by chance. */
int tp_onset_terms_sign(const tp_onset_terms *terms, const fmpz_mpoly_q_t value);

#endif
