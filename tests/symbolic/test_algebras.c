/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The three algebras of formulas agree with each other and with the truth.
 *
 * Random trees are written as texts with as few brackets as precedence allows, or a few more, and
 * evaluated while they are written: in GMP's rationals where they have only + - * / and whole
 * powers, in doubles where they have functions. The rationals of a scene's parameters and the
 * field of `derive` must give that rational, `verify`'s rational function too, and its ball must
 * hold it; of trees with functions balls must hold the double to its rounding, and meet the
 * rational function where there is one. */

#include "derive/field.h"
#include "formula_drawing.h"
#include "suite.h"
#include "verify/evaluate.h"
#include "verify/subject_init.h"

#include <gmp.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { TREES = 3000 };

/* A subject without a block, whose symbols are the names. */
static void make_subject(tp_subject *subject) {
  tp_declared declared[FIRST_NAMES];
  fmpq values[FIRST_NAMES];
  for (int k = 0; k < FIRST_NAMES; k++) {
    fmpq_init(values + k);
    fmpq_set_si(values + k, tops[k], (ulong)belows[k]);
    declared[k] = (tp_declared){names[k], values + k, k == FIRST_NAMES - 1};
  }
  const tp_subject_options options = {.declared_count = FIRST_NAMES, .declared = declared};
  tp_message message = {.text = ""};
  ck_assert_msg(tp_subject_init(subject, &options, (tp_place){0}, &message) == TP_OK, "%s",
                message.text);
  for (int k = 0; k < FIRST_NAMES; k++) fmpq_clear(values + k);
}

/* The rational function and the ball of a text; whether there is a rational function. */
static bool evaluate(fmpz_mpoly_q_t value, arb_t ball, const char *text, tp_subject *subject,
                     const tp_claim_sample *sample) {
  tp_formula formula;
  tp_message message = {.text = ""};
  bool rational = false;
  ck_assert_msg(tp_subject_read(&formula, text, (tp_place){0}, subject, &message) == TP_OK,
                "%s: %s", text, message.text);
  ck_assert_msg(tp_evaluate_field(value, &rational, &formula, subject, &message) == TP_OK, "%s: %s",
                text, message.text);
  ck_assert_msg(tp_evaluate_ball(ball, &formula, subject, sample, true, 256, &message) == TP_OK,
                "%s: %s", text, message.text);
  tp_formula_clear(&formula);
  return rational;
}

START_TEST(verify_agrees_with_rationals) {
  random_numbers random = random_numbers_from(14);
  tp_subject subject;
  tp_claim_sample sample;
  written w;
  fmpq_t truth, own;
  arb_t ball;
  fmpz_mpoly_q_t value;
  make_subject(&subject);
  ck_assert(tp_sample_init(&sample, &subject));
  written_init(&w);
  fmpq_init(truth);
  fmpq_init(own);
  arb_init(ball);
  fmpz_mpoly_q_init(value, subject.field->ring);
  for (long k = 0; k < TREES; k++) {
    draw_formula(&w, &random, false);
    fmpq_set_mpq(truth, w.exact);
    ck_assert_msg(evaluate(value, ball, w.text, &subject, &sample), "%s", w.text);
    ck_assert_msg(tp_field_evaluate_at(own, value, sample.values, subject.field) &&
                      fmpq_equal(own, truth),
                  "%s", w.text);
    ck_assert_msg(arb_contains_fmpq(ball, truth), "%s", w.text);
  }
  fmpz_mpoly_q_clear(value, subject.field->ring);
  arb_clear(ball);
  fmpq_clear(own);
  fmpq_clear(truth);
  mpq_clear(w.exact);
  tp_sample_clear(&sample);
  tp_subject_clear(&subject);
}
END_TEST

START_TEST(verify_agrees_with_doubles) {
  random_numbers random = random_numbers_from(15);
  long rational = 0;
  tp_subject subject;
  tp_claim_sample sample;
  written w;
  arb_t ball, other;
  fmpz_mpoly_q_t value;
  make_subject(&subject);
  ck_assert(tp_sample_init(&sample, &subject));
  written_init(&w);
  arb_init(ball);
  arb_init(other);
  fmpz_mpoly_q_init(value, subject.field->ring);
  for (long k = 0; k < TREES; k++) {
    draw_formula(&w, &random, true);
    const bool known = evaluate(value, ball, w.text, &subject, &sample);
    const double middle = arf_get_d(arb_midref(ball), ARF_RND_NEAR);
    ck_assert_msg(fabs(middle - w.value) <= 1e-6 * (1 + fabs(w.value)), "%s: %.17g, not %.17g",
                  w.text, middle, w.value);
    rational += known;
    if (!known) continue;
    tp_sample_evaluate(other, value, &sample, &subject, 256);
    ck_assert_msg(arb_overlaps(ball, other), "%s", w.text);
  }
  ck_assert_int_gt(rational, TREES / 20);
  ck_assert_int_lt(rational, TREES - TREES / 20);
  fmpz_mpoly_q_clear(value, subject.field->ring);
  arb_clear(ball);
  arb_clear(other);
  mpq_clear(w.exact);
  tp_sample_clear(&sample);
  tp_subject_clear(&subject);
}
END_TEST

/* Parameters of a scene, each a tree in the first four: their values in rationals, and in the field
 * where these are symbols. */
START_TEST(scenes_and_derive_agree_with_rationals) {
  enum { ROUNDS = 100, EACH = 30, SHORT = 40 }; /* derive takes so many terms in one number */
  random_numbers random = random_numbers_from(16);
  char *text = malloc((size_t)EACH * (SIZE + 40) + 400);
  ck_assert_ptr_nonnull(text);
  for (long round = 0; round < ROUNDS; round++) {
    written all[EACH];
    size_t length = (size_t)sprintf(text, "topple: 1\nlength_unit: m\nparameters:\n");
    for (int k = 0; k < FIRST_NAMES; k++)
      length += (size_t)sprintf(text + length, "  %s: %ld/%ld\n", names[k], tops[k], belows[k]);
    for (int k = 0; k < EACH; k++) {
      written_init(all + k);
      do draw_formula(all + k, &random, false);
      while (strlen(all[k].text) > SHORT);
      length += (size_t)sprintf(text + length, "  p%d: '%s'\n", k, all[k].text);
    }
    sprintf(text + length, "block: {slab: {width: 1, height: 2}}\nbase: {mated: true}\n");
    tp_scene *scene = NULL;
    tp_field field;
    tp_message message = {.text = ""};
    ck_assert_msg(tp_scene_read_text(&scene, text, "s", &message) == TP_OK, "%s", message.text);
    ck_assert_msg(tp_field_init(&field, scene, NULL, &message) == TP_OK, "%s", message.text);
    fmpq_t truth, own;
    fmpq_init(truth);
    fmpq_init(own);
    for (int k = 0; k < EACH; k++) {
      const long p = FIRST_NAMES + k;
      fmpq_set_mpq(truth, all[k].exact);
      ck_assert_msg(fmpq_equal(scene->parameters.values + p, truth), "%s", all[k].text);
      ck_assert_msg(tp_field_evaluate(own, field.values + p, &field) && fmpq_equal(own, truth),
                    "%s", all[k].text);
      mpq_clear(all[k].exact);
    }
    fmpq_clear(truth);
    fmpq_clear(own);
    tp_field_clear(&field);
    tp_scene_free(scene);
  }
  free(text);
}
END_TEST

SUITE(algebras) {
  Suite *suite = suite_create("algebras");
  TCase *algebras = tcase_create("algebras");
  tcase_set_timeout(algebras, 300);
  tcase_add_test(algebras, verify_agrees_with_rationals);
  tcase_add_test(algebras, verify_agrees_with_doubles);
  tcase_add_test(algebras, scenes_and_derive_agree_with_rationals);
  suite_add_tcase(suite, algebras);
  return suite;
}
