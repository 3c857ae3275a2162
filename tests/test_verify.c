/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Claims from within: what names a subject has and what they stand for, the quantities of a slab
 * w wide and h high, which are known by hand, and the verdict on a formula that is right, wrong by
 * a factor, right at the claim's own values alone, or not rational. */

#include "runner.h"
#include "verify/decide.h"
#include "verify/domain.h"
#include "verify/evaluate.h"
#include "verify/subject_init.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* A slab w = 2 wide and h = 3 high; a symbol m = 5 and an angle psi = 30 degrees besides. */
typedef struct bench {
  tp_subject subject;
  tp_sample sample;
  tp_message message;
} bench;

/* A subject of the slab, whose declared symbol has this name. */
static tp_status init_subject(tp_subject *subject, const char *name, tp_message *message) {
  static const char scene[] = "topple: 1\nlength_unit: m\nparameters: {w: 2, h: 3}\n"
                              "block: {slab: {width: w, height: h}}\nbase: {mated: true}\n"
                              "tilt: {towards: left, angle_deg: 20}\n";
  char path[] = "/tmp/topple-test-XXXXXX";
  const int handle = mkstemp(path);
  ck_assert_int_ge(handle, 0);
  ck_assert_int_eq(write(handle, scene, strlen(scene)), (ssize_t)strlen(scene));
  close(handle);
  fmpq values[2];
  for (int k = 0; k < 2; k++) fmpq_init(values + k);
  fmpq_set_si(values, 5, 1);
  fmpq_set_si(values + 1, 30, 1);
  const tp_declared declared[2] = {{name, values, false}, {"psi", values + 1, true}};
  const tp_subject_options options = {.scene = path, .declared_count = 2, .declared = declared};
  const tp_status status = tp_subject_init(subject, &options, (tp_place){"t", 1, 1}, message);
  unlink(path);
  for (int k = 0; k < 2; k++) fmpq_clear(values + k);
  return status;
}

static void bench_init(bench *b) {
  b->message = (tp_message){""};
  ck_assert_msg(init_subject(&b->subject, "m", &b->message) == TP_OK, "%s", b->message.text);
  ck_assert(tp_sample_init(&b->sample, &b->subject));
}

static void bench_clear(bench *b) {
  tp_sample_clear(&b->sample);
  tp_subject_clear(&b->subject);
}

static void reads(tp_formula *formula, bench *b, const char *text) {
  ck_assert_msg(tp_subject_read(formula, text, (tp_place){"t", 1, 1}, &b->subject, &b->message) ==
                    TP_OK,
                "%s: %s", text, b->message.text);
}

/* The text's value at the sample. */
static double value_of(bench *b, const char *text) {
  tp_formula formula;
  arb_t ball;
  arb_init(ball);
  reads(&formula, b, text);
  ck_assert_msg(tp_evaluate_ball(ball, &formula, &b->subject, &b->sample, true, 128, &b->message) ==
                    TP_OK,
                "%s: %s", text, b->message.text);
  const double value = arf_get_d(arb_midref(ball), ARF_RND_NEAR);
  tp_formula_clear(&formula);
  arb_clear(ball);
  return value;
}

/* Are both texts the same rational function? */
static bool same(bench *b, const char *one, const char *other) {
  const fmpz_mpoly_ctx_struct *ring = b->subject.field->ring;
  const char *texts[2] = {one, other};
  fmpz_mpoly_q_t values[2];
  for (int k = 0; k < 2; k++) {
    tp_formula formula;
    bool rational = false;
    fmpz_mpoly_q_init(values[k], ring);
    reads(&formula, b, texts[k]);
    ck_assert_int_eq(tp_evaluate_field(values[k], &rational, &formula, &b->subject, &b->message),
                     TP_OK);
    ck_assert_msg(rational, "%s", texts[k]);
    tp_formula_clear(&formula);
  }
  const bool equal = fmpz_mpoly_q_equal(values[0], values[1], ring) != 0;
  fmpz_mpoly_q_clear(values[0], ring);
  fmpz_mpoly_q_clear(values[1], ring);
  return equal;
}

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
  reads(&formula, &b, "k + 1");
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
    tp_message message = {""};
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
  reads(&formula, &b, "critical_angle");
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

/* The verdict on a printed formula. The caller frees what the result holds. */
static tp_claim_result decide(bench *b, const char *quantity, const char *text) {
  tp_formula formulas[2];
  tp_claim_result result = {.is_formula = true};
  reads(formulas, b, quantity);
  reads(formulas + 1, b, text);
  b->subject.domain = tp_domain_new(&b->subject, &b->sample);
  ck_assert_ptr_nonnull(b->subject.domain);
  const tp_question question = {.subject = &b->subject,
                                .quantity = formulas,
                                .printed = formulas + 1,
                                .number = text,
                                .sample = &b->sample,
                                .message = &b->message};
  ck_assert_msg(tp_decide_formula(&result, &question) == TP_OK, "%s", b->message.text);
  tp_domain_free(b->subject.domain);
  b->subject.domain = NULL;
  tp_subject_forget(&b->subject);
  tp_formula_clear(formulas);
  tp_formula_clear(formulas + 1);
  return result;
}

static void drop(tp_claim_result *result) {
  free(result->derived);
  free(result->difference);
  free(result->mend);
  free(result->change);
  free(result->condition);
  free(result->values);
}

/* Right: proven, and nothing to add. Angles are compared by their tangents. */
START_TEST(a_right_formula_is_proven) {
  static const char *const cases[][2] = {{"area", "wh"},
                                         {"fos", "(w/h) cot α"},
                                         {"fos", "w/(h tan α)"},
                                         {"critical_angle", "tan^-1(w/h)"},
                                         {"x_arm^2 + y_arm^2", "(w^2 + h^2)/4"},
                                         {"block_width", "sqrt(w^2)"},
                                         {"sin^2 psi + cos^2 psi", "m/5*5/m"}};
  bench b;
  bench_init(&b);
  for (size_t k = 0; k < sizeof cases / sizeof cases[0]; k++) {
    tp_claim_result result = decide(&b, cases[k][0], cases[k][1]);
    ck_assert_msg(result.verdict == TP_VERDICT_PROVEN, "%s: %s", cases[k][1],
                  tp_verdict_name(result.verdict));
    ck_assert_ptr_nonnull(result.derived);
    ck_assert_ptr_null(result.mend);
    ck_assert_ptr_null(result.difference);
    ck_assert_ptr_null(result.condition);
    drop(&result);
  }
  bench_clear(&b);
}
END_TEST

/* Wrong by a factor, a sign, an exponent or a name: refuted, with values at which both sides
 * differ, and the mend is proven when it is asked about. */
START_TEST(a_wrong_formula_is_mended) {
  static const char *const cases[][2] = {{"area", "2wh"},
                                         {"area", "wh/3"},
                                         {"x_arm", "w/3"},
                                         {"x_arm^2 + y_arm^2", "(w^2 - h^2)/4"},
                                         {"area*h", "w h^3"},
                                         {"fos", "w/(w tan α)"},
                                         {"critical_angle", "atan(w/(2h))"},
                                         {"sin(psi)^3", "sin^2 psi"}};
  bench b;
  bench_init(&b);
  for (size_t k = 0; k < sizeof cases / sizeof cases[0]; k++) {
    tp_claim_result result = decide(&b, cases[k][0], cases[k][1]);
    ck_assert_msg(result.verdict == TP_VERDICT_REFUTED, "%s: %s", cases[k][1],
                  tp_verdict_name(result.verdict));
    ck_assert_ptr_nonnull(result.difference);
    ck_assert_msg(result.mend != NULL && result.change != NULL, "%s", cases[k][1]);
    ck_assert(result.has_values);
    ck_assert_double_gt(fabs(result.printed_value.value - result.computed.value),
                        result.printed_value.error + result.computed.error);
    tp_claim_result again = decide(&b, cases[k][0], result.mend);
    ck_assert_msg(again.verdict == TP_VERDICT_PROVEN, "%s", result.mend);
    drop(&again);
    drop(&result);
  }
  bench_clear(&b);
}
END_TEST

/* w + 4 is the area where w = 2 and h = 3: it takes other values to tell them apart. */
START_TEST(right_at_a_point_is_refuted) {
  bench b;
  bench_init(&b);
  ck_assert_double_eq(value_of(&b, "area - (w + 4)"), 0);
  tp_claim_result result = decide(&b, "area", "w + 4");
  ck_assert_int_eq(result.verdict, TP_VERDICT_REFUTED);
  ck_assert(result.has_values);
  ck_assert_double_gt(fabs(result.printed_value.value - result.computed.value), 0);
  ck_assert_ptr_null(strstr(result.values, "w = 2, h = 3"));
  drop(&result);
  bench_clear(&b);
}
END_TEST

/* What is no rational function agrees at points, which is no proof, or is refuted by one. */
START_TEST(points_are_no_proof) {
  bench b;
  bench_init(&b);
  tp_claim_result result = decide(&b, "log10(area)", "log10 w + log10 h");
  ck_assert_int_eq(result.verdict, TP_VERDICT_AGREES);
  ck_assert_int_ge(result.points, 20);
  ck_assert_int_ge(result.digits, 60);
  drop(&result);
  result = decide(&b, "90 - critical_angle", "90 - atan(w/h)"); /* angles in a sum */
  ck_assert_int_eq(result.verdict, TP_VERDICT_AGREES);
  drop(&result);
  result = decide(&b, "log10(area)", "log10(w + 4)"); /* right at the claim's own values */
  ck_assert_int_eq(result.verdict, TP_VERDICT_REFUTED);
  drop(&result);
  bench_clear(&b);
}
END_TEST

int main(void) {
  Suite *suite = suite_create("verify");
  TCase *claims = tcase_create("verify");
  tcase_set_timeout(claims, 300);
  tcase_add_test(claims, names_of_a_subject);
  tcase_add_test(claims, definitions_last_for_a_claim);
  tcase_add_test(claims, names_are_told_apart);
  tcase_add_test(claims, quantities_of_a_slab);
  tcase_add_test(claims, a_right_formula_is_proven);
  tcase_add_test(claims, a_wrong_formula_is_mended);
  tcase_add_test(claims, right_at_a_point_is_refuted);
  tcase_add_test(claims, points_are_no_proof);
  suite_add_tcase(suite, claims);
  return run_suite(suite);
}
