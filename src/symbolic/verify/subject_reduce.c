/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Normal forms of formulas under sin^2 + cos^2 = 1.
 *
 * The polynomials sin^2 + cos^2 - 1 of several angles have coprime leading terms, so they are a
 * Groebner basis, and the remainder of a numerator after division by them is zero if and only if it
 * vanishes for all angles. */

#include "verify/subject.h"

#include <stdlib.h>

/* sin^2 + cos^2 - 1 of every angle. */
bool tp_subject_init_ones(tp_subject *s) {
  const fmpz_mpoly_ctx_struct *ring = s->field->ring;
  s->ones = calloc((size_t)s->angle_count, sizeof *s->ones);
  if (s->ones == NULL) return false;
  fmpz_mpoly_t square;
  fmpz_mpoly_init(square, ring);
  for (long k = 0; k < s->angle_count; k++) {
    fmpz_mpoly_init(s->ones[k], ring);
    fmpz_mpoly_gen(s->ones[k], s->angles[k].sine, ring);
    fmpz_mpoly_pow_ui(s->ones[k], s->ones[k], 2, ring);
    fmpz_mpoly_gen(square, s->angles[k].cosine, ring);
    fmpz_mpoly_pow_ui(square, square, 2, ring);
    fmpz_mpoly_add(s->ones[k], s->ones[k], square, ring);
    fmpz_mpoly_sub_si(s->ones[k], s->ones[k], 1, ring);
  }
  fmpz_mpoly_clear(square, ring);
  return true;
}

static bool reduce_half(fmpz_mpoly_t half, const tp_subject *s) {
  const fmpz_mpoly_ctx_struct *ring = s->field->ring;
  bool changed = false;
  fmpz_mpoly_t quotient;
  fmpz_mpoly_init(quotient, ring);
  for (long k = 0; k < s->angle_count; k++) {
    if (fmpz_mpoly_degree_si(half, s->angles[k].sine, ring) < 2) continue;
    fmpz_mpoly_divrem(quotient, half, half, s->ones[k], ring);
    changed = true;
  }
  fmpz_mpoly_clear(quotient, ring);
  return changed;
}

void tp_subject_reduce(fmpz_mpoly_q_t formula, const tp_subject *s) {
  const bool top = reduce_half(fmpz_mpoly_q_numref(formula), s);
  const bool below = reduce_half(fmpz_mpoly_q_denref(formula), s);
  if ((top || below) && !fmpz_mpoly_is_zero(fmpz_mpoly_q_denref(formula), s->field->ring)) {
    fmpz_mpoly_q_canonicalise(formula, s->field->ring);
  }
}
