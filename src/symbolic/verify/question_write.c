/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Formulas of a verdict in writing.
 *
 * Where every term of numerator and denominator has the same degree in sine and cosine of an angle
 * together, both are divided by that power of the cosine: sine over cosine is the tangent. */

#include "verify/question.h"

#include "derive/notation.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The degree in sine and cosine that all terms share; -1 where they do not, or have none. */
static slong shared_degree(const fmpz_mpoly_q_t formula, const tp_angle *angle,
                           const fmpz_mpoly_ctx_t ring) {
  const fmpz_mpoly_struct *halves[2] = {fmpz_mpoly_q_numref(formula), fmpz_mpoly_q_denref(formula)};
  slong shared = -1;
  for (int h = 0; h < 2; h++) {
    for (slong t = 0; t < fmpz_mpoly_length(halves[h], ring); t++) {
      const slong degree = fmpz_mpoly_get_term_var_exp_si(halves[h], t, angle->sine, ring) +
                           fmpz_mpoly_get_term_var_exp_si(halves[h], t, angle->cosine, ring);
      if (shared >= 0 && degree != shared) return -1;
      shared = degree;
    }
  }
  return shared > 0 ? shared : -1;
}

static void drop_cosine(fmpz_mpoly_q_t formula, const tp_angle *angle,
                        const fmpz_mpoly_ctx_t ring) {
  fmpz_t one;
  fmpz_init_set_ui(one, 1);
  fmpz_mpoly_struct *top = fmpz_mpoly_q_numref(formula), *below = fmpz_mpoly_q_denref(formula);
  fmpz_mpoly_evaluate_one_fmpz(top, top, angle->cosine, one, ring);
  fmpz_mpoly_evaluate_one_fmpz(below, below, angle->cosine, one, ring);
  fmpz_clear(one);
}

static char *tangent_of(const char *angle) {
  const size_t size = strlen(angle) + sizeof "tan()";
  char *text = malloc(size);
  if (text != NULL) snprintf(text, size, "tan(%s)", angle);
  return text;
}

tp_status tp_question_write(char **text, const fmpz_mpoly_q_t formula, const tp_question *q) {
  const tp_subject *s = q->subject;
  const fmpz_mpoly_ctx_struct *ring = s->field->ring;
  tp_field shown = *s->field;
  shown.names = calloc((size_t)shown.symbol_count, sizeof *shown.names);
  char **tangents = calloc((size_t)s->angle_count + 1, sizeof *tangents);
  bool failed = shown.names == NULL || tangents == NULL;
  fmpz_mpoly_q_t copy;
  fmpz_mpoly_q_init(copy, ring);
  fmpz_mpoly_q_set(copy, formula, ring);
  if (!failed) {
    memcpy(shown.names, s->field->names, (size_t)shown.symbol_count * sizeof *shown.names);
    for (long k = 0; k < s->angle_count; k++) {
      if (shared_degree(copy, s->angles + k, ring) < 0) continue;
      drop_cosine(copy, s->angles + k, ring);
      tangents[k] = tangent_of(shown.names[s->angles[k].degrees]);
      failed = failed || tangents[k] == NULL;
      shown.names[s->angles[k].sine] = tangents[k];
    }
  }
  if (!failed) {
    tp_fraction fraction = tp_notation_write(copy, &shown, TP_NOTATION_TEXT, &failed);
    *text = fraction.formula;
    fraction.formula = NULL;
    tp_notation_free(&fraction);
  }
  fmpz_mpoly_q_clear(copy, ring);
  for (long k = 0; k < s->angle_count && tangents != NULL; k++) free(tangents[k]);
  free(tangents);
  free(shown.names);
  return failed ? tp_fail_memory(q->message, "a formula") : TP_OK;
}
