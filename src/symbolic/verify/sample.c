/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Values of a sample by the names of the subject, sines and cosines of its angles in balls, and
 * values of rational functions there. */

#include "verify/sample.h"

#include "common/outside.h"
#include "formula/spelling.h"
#include "number/ball.h"
#include "number/ratio.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

bool tp_sample_init_copy(tp_claim_sample *sample, const tp_claim_sample *other) {
  *sample = (tp_claim_sample){.values = calloc((size_t)other->count, sizeof *sample->values),
                              .given = calloc((size_t)other->count, sizeof *sample->given)};
  if (sample->values == NULL || sample->given == NULL) {
    tp_sample_clear(sample);
    return false;
  }
  sample->count = other->count;
  for (long k = 0; k < other->count; k++) {
    fmpq_init(sample->values + k);
    fmpq_set(sample->values + k, other->values + k);
    sample->given[k] = other->given[k];
  }
  return true;
}

bool tp_sample_init(tp_claim_sample *sample, const tp_subject *s) {
  const tp_claim_sample own = {s->field->symbol_count, s->values, s->given};
  return tp_sample_init_copy(sample, &own);
}

void tp_sample_clear(tp_claim_sample *sample) {
  for (long k = 0; sample->values != NULL && k < sample->count; k++) {
    fmpq_clear(sample->values + k);
  }
  free(sample->values);
  free(sample->given);
  *sample = (tp_claim_sample){0};
}

/* The field's symbol that a name is, or -1. */
static long symbol_of(const tp_subject *s, const tp_name *name) {
  if (name->kind == TP_NAME_ANGLE) return s->angles[name->angle].degrees;
  if (name->kind != TP_NAME_FORMULA || !name->ready) return -1;
  const fmpz_mpoly_ctx_struct *ring = s->field->ring;
  if (!fmpz_mpoly_is_one(fmpz_mpoly_q_denref(name->value), ring)) return -1;
  for (long k = 0; k < s->field->symbol_count; k++) {
    if (fmpz_mpoly_is_gen(fmpz_mpoly_q_numref(name->value), k, ring)) return k;
  }
  return -1;
}

long tp_sample_symbol(const tp_subject *s, const char *name) {
  char spelt[TP_NAME_SIZE];
  const size_t used = tp_name_spell(spelt, sizeof spelt, name, sizeof spelt);
  if (name[used] != '\0') return -1;
  const long index = tp_subject_find(s, spelt, strlen(spelt));
  return index >= 0 ? symbol_of(s, s->names + index) : -1;
}

tp_status tp_sample_set(tp_claim_sample *sample, const tp_subject *s, const char *name,
                        const fmpq_t value, tp_place place, tp_message *message) {
  const long symbol = tp_sample_symbol(s, name);
  if (symbol < 0) {
    return tp_refuse(
        message, TP_FAULT_KEY, place,
        "'%s' is not a symbol that takes a value: 'at' sets parameters, symbols, angles "
        "and r",
        tp_quote_all(name).text);
  }
  fmpq_set(sample->values + symbol, value);
  sample->given[symbol] = true;
  return TP_OK;
}

/* The angle of the facet at the pivot, at the sample. */
static bool facet_angle(arb_t angle, arb_srcptr symbols, tp_subject *s, long bits) {
  const tp_name *name = NULL;
  const long index = tp_subject_find(s, "facet_angle", 11);
  if (index < 0 || tp_subject_name(&name, s, index, NULL) != TP_OK) return false;
  arb_t rise, run;
  arb_init(rise);
  arb_init(run);
  tp_field_evaluate_ball(rise, name->value, symbols, s->field, bits);
  tp_field_evaluate_ball(run, name->run, symbols, s->field, bits);
  tp_ball_atan2_degrees(angle, rise, run, bits);
  arb_clear(rise);
  arb_clear(run);
  return true;
}

arb_ptr tp_sample_balls(const tp_claim_sample *sample, tp_subject *s, long bits) {
  arb_ptr symbols = _arb_vec_init(sample->count);
  for (long k = 0; k < sample->count; k++) arb_set_fmpq(symbols + k, sample->values + k, bits);
  for (long k = 0; k < s->angle_count; k++) {
    const tp_angle *a = s->angles + k;
    if (k == TP_ANGLE_I && !sample->given[a->degrees]) {
      facet_angle(symbols + a->degrees, symbols, s, bits);
    }
    tp_ball_sin_cos(symbols + a->sine, symbols + a->cosine, symbols + a->degrees, bits);
  }
  return symbols;
}

void tp_sample_evaluate(arb_t value, const fmpz_mpoly_q_t formula, const tp_claim_sample *sample,
                        tp_subject *s, long bits) {
  arb_ptr symbols = tp_sample_balls(sample, s, bits);
  tp_field_evaluate_ball(value, formula, symbols, s->field, bits);
  _arb_vec_clear(symbols, sample->count);
}

static bool is_shown(const tp_subject *s, long symbol, const int *used) {
  if (used[symbol]) return true;
  for (long k = 0; k < s->angle_count; k++) {
    const tp_angle *a = s->angles + k;
    if (a->degrees == symbol) return used[a->sine] || used[a->cosine];
  }
  return false;
}

static bool is_function(const tp_subject *s, long symbol) {
  for (long k = 0; k < s->angle_count; k++) {
    if (s->angles[k].sine == symbol || s->angles[k].cosine == symbol) return true;
  }
  return false;
}

void tp_sample_text(char *text, size_t size, const tp_claim_sample *sample, const tp_subject *s,
                    const int *used) {
  size_t length = 0;
  text[0] = '\0';
  for (long k = 0; k < sample->count && length + 1 < size; k++) {
    if (!is_shown(s, k, used) || is_function(s, k)) continue;
    char number[80];
    if (k == s->angles[TP_ANGLE_I].degrees && !sample->given[k]) {
      snprintf(number, sizeof number, "that of the facet");
    } else {
      tp_ratio_text(number, sizeof number, sample->values + k);
    }
    length += (size_t)snprintf(text + length, size - length, "%s%s = %s", length > 0 ? ", " : "",
                               s->field->names[k], number);
  }
}
