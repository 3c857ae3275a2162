/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The number that would mend a formula: with everything else given whole values the numerator of
 * the difference is a polynomial in it, whose rational roots are the only ones that can do. */

#include "verify/mend.h"

#include <flint/fmpz_poly.h>
#include <flint/fmpz_poly_factor.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_DEGREE = 40 };

/* The printed text with [begin, end) replaced. */
char *tp_mend_replaced(const tp_formula *f, int begin, int end, const char *by) {
  const size_t size = strlen(f->text) + strlen(by) + 1;
  char *text = malloc(size);
  if (text != NULL) snprintf(text, size, "%.*s%s%s", begin, f->text, by, f->text + end);
  return text;
}

/* Printed minus derived for another text; false where it cannot be formed. */
bool tp_mend_difference(fmpz_mpoly_q_t difference, bool *failed, const char *text,
                        const tp_question *q) {
  tp_formula formula;
  tp_message ignored;
  tp_question other = *q;
  other.message = &ignored;
  tp_status status = tp_subject_read(&formula, text, q->printed->place, q->subject, &ignored);
  if (status == TP_OUT_OF_MEMORY) *failed = true;
  if (status != TP_OK) return false;
  other.printed = &formula;
  bool rational = false, tangents = false;
  status = tp_question_difference(difference, NULL, &rational, &tangents, &other);
  if (status == TP_OUT_OF_MEMORY) *failed = true;
  tp_formula_clear(&formula);
  return status == TP_OK && rational;
}

/* A polynomial in the unknown alone: its other symbols take whole values. */
static void to_univariate(fmpz_poly_t out, const fmpz_mpoly_t p, const tp_subject *s) {
  const fmpz_mpoly_ctx_struct *ring = s->field->ring;
  fmpz_t term, factor;
  fmpz_init(term);
  fmpz_init(factor);
  for (slong t = 0; t < fmpz_mpoly_length(p, ring); t++) {
    fmpz_mpoly_get_term_coeff_fmpz(term, p, t, ring);
    for (long k = 0; k < s->field->symbol_count; k++) {
      const slong exponent = fmpz_mpoly_get_term_var_exp_si(p, t, k, ring);
      if (exponent == 0 || k == s->mend) continue;
      fmpz_set_si(factor, 1009 + 613 * k * k + 271 * k);
      fmpz_pow_ui(factor, factor, (ulong)exponent);
      fmpz_mul(term, term, factor);
    }
    const slong power = fmpz_mpoly_get_term_var_exp_si(p, t, s->mend, ring);
    fmpz_poly_get_coeff_fmpz(factor, out, power);
    fmpz_add(factor, factor, term);
    fmpz_poly_set_coeff_fmpz(out, power, factor);
  }
  fmpz_clear(term);
  fmpz_clear(factor);
}

static long collect_roots(fmpq **roots, const fmpz_poly_t polynomial) {
  fmpz_poly_factor_t factors;
  fmpz_poly_factor_init(factors);
  fmpz_poly_factor(factors, polynomial);
  long count = 0;
  *roots = calloc((size_t)factors->num + 1, sizeof **roots);
  for (slong k = 0; *roots != NULL && k < factors->num; k++) {
    if (fmpz_poly_degree(factors->p + k) != 1) continue;
    fmpq *root = *roots + count++;
    fmpq_init(root);
    fmpq_set_fmpz_frac(root, factors->p[k].coeffs, factors->p[k].coeffs + 1);
    fmpq_neg(root, root);
  }
  fmpz_poly_factor_clear(factors);
  return *roots != NULL ? count : -1;
}

long tp_mend_solve(fmpq **roots, const char *text, const tp_question *q) {
  const tp_subject *s = q->subject;
  fmpz_mpoly_q_t difference;
  fmpz_poly_t polynomial;
  fmpz_mpoly_q_init(difference, s->field->ring);
  fmpz_poly_init(polynomial);
  *roots = NULL;
  long count = 0;
  bool failed = false;
  if (tp_mend_difference(difference, &failed, text, q) &&
      fmpz_mpoly_degree_si(fmpz_mpoly_q_numref(difference), s->mend, s->field->ring) > 0) {
    to_univariate(polynomial, fmpz_mpoly_q_numref(difference), s);
  }
  const slong degree = fmpz_poly_degree(polynomial);
  if (degree > 0 && degree <= MOST_DEGREE) count = collect_roots(roots, polynomial);
  if (failed) count = -1; /* no roots were asked for */
  fmpz_poly_clear(polynomial);
  fmpz_mpoly_q_clear(difference, s->field->ring);
  return count;
}
