/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Subjects of claims from within: what names one has and what they stand for, and the quantities of
 * a slab w wide and h high, which are known by hand. */

#include "suite.h"
#include "verify/subject_init.h"
#include "verify_bench.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

START_TEST(names_of_a_subject) {
  bench b;
  bench_init(&b);
  const tp_subject *s = &b.subject;
  static const char *const known[] = {"w", "h", "m", "psi", "alpha", "i", "r", "N", "area", "fos"};
  for (size_t k = 0; k < sizeof known / sizeof known[0]; k++) {
    const long index = tp_subject_find(s, known[k], strlen(known[k]));
    ck_assert_msg(index >= 0 && strcmp(s->names[index].text, known[k]) == 0, "%s", known[k]);
  }
  ck_assert_int_eq(tp_subject_find(s, "are", 3), -1);
  ck_assert_int_eq(tp_subject_find(s, "wide", 1), tp_subject_find(s, "w", 1));
  ck_assert_double_eq(value_of(&b, "w + 10h + 100m + 1000ψ"), 30532);
  ck_assert_double_eq(value_of(&b, "alpha"), 20); /* the scene's tilt */
  bench_clear(&b);
}
END_TEST

/* Definitions are names like others, the last of a name counts, and a claim forgets its own. */
START_TEST(definitions_last_for_a_claim) {
  bench b;
  bench_init(&b);
  const long own = b.subject.name_count;
  const tp_place place = {"t", 1, 1};
  ck_assert_int_eq(tp_subject_define(&b.subject, "delta", "90 - psi", place, &b.message), TP_OK);
  ck_assert_int_eq(tp_subject_define(&b.subject, "k", "m*w", place, &b.message), TP_OK);
  ck_assert_int_eq(tp_subject_define(&b.subject, "k", "k + 1", place, &b.message), TP_OK);
  ck_assert_double_eq(value_of(&b, "k"), 11);
  ck_assert_double_eq(value_of(&b, "δ"), 60);
  ck_assert(same(&b, "sin δ", "cos psi"));
  ck_assert(same(&b, "tan^-1 δ", "tan psi")); /* an angle by its form */
  int *used = calloc((size_t)b.subject.field->symbol_count, sizeof *used);
  tp_formula formula;
  read_claim_formula(&formula, &b, "k + 1");
  ck_assert_ptr_nonnull(used);
  ck_assert_int_eq(tp_subject_used(used, &formula, &b.subject, &b.message), TP_OK);
  ck_assert(used[tp_sample_symbol(&b.subject, "m")] && used[tp_sample_symbol(&b.subject, "w")]);
  ck_assert(!used[tp_sample_symbol(&b.subject, "h")]);
  tp_formula_clear(&formula);
  free(used);
  ck_assert_int_eq(tp_subject_define(&b.subject, "2k", "1", place, &b.message), TP_BAD_INPUT);
  ck_assert_str_eq(b.message.text, "t:1:1: '2k' cannot be a name");
  tp_subject_forget(&b.subject);
  ck_assert_int_eq(b.subject.name_count, own);
  ck_assert_int_eq(tp_subject_find(&b.subject, "delta", 5), -1);
  bench_clear(&b);
}
END_TEST

/* A declared name must not hide one of the program's, nor be one of the scene's. */
START_TEST(names_are_told_apart) {
  static const char *const wrong[][2] = {
      {"fos", "t:1:1: 'fos' is a name that claims use for something else; rename the symbol"},
      {"alpha", "t:1:1: 'alpha' is a name that claims use for something else; rename the symbol"},
      {"psi", "t:1:1: 'psi' is declared already; rename the symbol"},
      {"w", "t:1:1: 'w' is declared already; rename the parameter"}};
  for (size_t k = 0; k < sizeof wrong / sizeof wrong[0]; k++) {
    tp_subject subject;
    tp_message message = {.text = ""};
    ck_assert_int_eq(init_subject(&subject, wrong[k][0], &message), TP_BAD_INPUT);
    ck_assert_msg(strncmp(message.text, wrong[k][1], strlen(wrong[k][1])) == 0, "%s", message.text);
  }
}
END_TEST

/* Towards the left a slab turns about its lower left corner. */
START_TEST(quantities_of_a_slab) {
  static const char *const cases[][2] = {
      {"area", "w*h"},
      {"x_arm", "w/2"},
      {"y_arm", "h/2"},
      {"fos", "w cos α/(h sin α)"},
      {"fos_elements", "w cos α/(h sin α)"},
      {"stabilising_area_moment", "w^2 h cos α/2"},
      {"overturning_area_moment", "w h^2 sin α/2"},
      {"stabilising_moment", "w_1*w cos α/2"},
      {"overturning_moment", "w_1*h sin α/2"},
      {"block_width", "w"},
      {"mean_height", "h"},
      {"mean_square_slope", "0"},
      {"amplitude", "0"},
  };
  bench b;
  bench_init(&b);
  for (size_t k = 0; k < sizeof cases / sizeof cases[0]; k++) {
    ck_assert_msg(same(&b, cases[k][0], cases[k][1]), "%s is not %s", cases[k][0], cases[k][1]);
  }
  tp_formula formula;
  bool rational = false;
  fmpz_mpoly_q_t tangent;
  fmpz_mpoly_q_init(tangent, b.subject.field->ring);
  read_claim_formula(&formula, &b, "critical_angle");
  ck_assert_int_eq(tp_evaluate_tangent(tangent, &rational, &formula, &b.subject, &b.message),
                   TP_OK);
  ck_assert(rational);
  tp_formula_clear(&formula);
  arb_t at;
  arb_init(at);
  tp_sample_evaluate(at, tangent, &b.sample, &b.subject, 128);
  ck_assert_double_eq_tol(arf_get_d(arb_midref(at), ARF_RND_NEAR), 2.0 / 3, 1e-15);
  arb_clear(at);
  fmpz_mpoly_q_clear(tangent, b.subject.field->ring);
  ck_assert_double_eq_tol(value_of(&b, "critical_angle"), 33.690067525979785, 1e-13);
  ck_assert_double_eq_tol(value_of(&b, "fos"), 2.0 / 3 / 0.36397023426620236, 1e-13);
  bench_clear(&b);
}
END_TEST

SUITE(verify) {
  Suite *suite = suite_create("verify");
  TCase *claims = tcase_create("verify");
  tcase_set_timeout(claims, 300);
  tcase_add_test(claims, names_of_a_subject);
  tcase_add_test(claims, definitions_last_for_a_claim);
  tcase_add_test(claims, names_are_told_apart);
  tcase_add_test(claims, quantities_of_a_slab);
  suite_add_tcase(suite, claims);
  return suite;
}
