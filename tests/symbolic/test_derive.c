/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Derivations from within: what the field makes of a scene's parameters, what it refuses and what
 * its arithmetic may cost; the moment sums and lever arms of an outline in symbols, equal at
 * hundreds of values of them to the shoelace sums in rationals; the formulas of a slab, by hand. */

#include "derive/field_work.h"
#include "derive/model.h"
#include "random_numbers.h"
#include "suite.h"

#include <stdlib.h>
#include <string.h>

static tp_scene *read_scene(const char *text) {
  tp_scene *scene = NULL;
  tp_message message = {.text = ""};
  ck_assert_msg(tp_scene_read_text(&scene, text, "s", &message) == TP_OK, "%s", message.text);
  return scene;
}

/* A scene whose parameters these are. */
static tp_scene *with_parameters(const char *parameters) {
  char text[2000];
  snprintf(text, sizeof text,
           "topple: 1\nlength_unit: m\nparameters: {%s}\n"
           "block: {slab: {width: 1, height: 2}}\nbase: {mated: true}\n",
           parameters);
  return read_scene(text);
}

/* What numbers give is a symbol, what expressions in these give stands for the expression. */
START_TEST(parameters_become_symbols) {
  tp_scene *scene = with_parameters("a: 30, b: 4*a, c: 1/3, N: a/b - c^2, d: 2*3");
  static const char *const symbols[] = {"a", "c", "d"};
  tp_field field;
  tp_message message = {.text = ""};
  char **names = NULL, **parameters = NULL;
  size_t count = 0;
  ck_assert_int_eq(tp_field_init(&field, scene, NULL, &message), TP_OK);
  ck_assert(tp_field_list_symbols(&count, &names, &parameters, &field));
  ck_assert_uint_eq(count, 3);
  for (size_t k = 0; k < count; k++) {
    ck_assert_str_eq(parameters[k], symbols[k]);
    free(names[k]);
    free(parameters[k]);
  }
  free(names);
  free(parameters);
  ck_assert_str_eq(field.count_name, "n"); /* N is taken */
  char *text =
      fmpz_mpoly_get_str_pretty(fmpz_mpoly_q_numref(field.values + 3), field.names, field.ring);
  ck_assert_str_eq(text, "-4*c^2+1"); /* a/(4 a) - c^2 in lowest terms, over 4 */
  flint_free(text);
  tp_field_clear(&field);
  tp_scene_free(scene);
}
END_TEST

/* At the scene's values these have numbers; as formulas they have none, or too large ones. */
START_TEST(what_has_no_formula) {
  static const char *const cases[][2] = {
      {"a: 3, b: 1/(a - a + 1), c: 1^a", "s:3:42: an exponent must be a whole number"},
      {"a: 3, c: (a + 1)^1001*0", "s:3:30: an exponent may be at most 1000 here"},
      {"a: 3, b: 4, c: (a + b + 1)^11",
       "s:3:29: more than 64 terms in one number; formulas are derived for shorter ones"},
  };
  for (size_t k = 0; k < sizeof cases / sizeof cases[0]; k++) {
    tp_scene *scene = with_parameters(cases[k][0]);
    tp_field field;
    tp_message message = {.text = ""};
    ck_assert_int_eq(tp_field_init(&field, scene, NULL, &message), TP_BAD_INPUT);
    ck_assert_str_eq(message.text, cases[k][1]);
    tp_scene_free(scene);
  }
}
END_TEST

/* An operation that the budget has no room for is not done, and says so until it is forgiven; a
 * spent budget is not. */
START_TEST(work_is_counted) {
  tp_scene *scene = with_parameters("a: 3, b: 4");
  tp_field field;
  fmpz_mpoly_q_t value;
  tp_message message = {.text = ""};
  ck_assert_int_eq(tp_field_init(&field, scene, NULL, &message), TP_OK);
  fmpz_mpoly_q_init(value, field.ring);
  fmpz_mpoly_q_gen(value, 0, field.ring);
  const double before = field.work->spent;
  ck_assert_ptr_null(tp_field_combine(value, TP_FORMULA_MULTIPLY, field.values + 1, &field));
  ck_assert_double_gt(field.work->spent, before);
  field.work->budget = field.work->spent;
  ck_assert_ptr_nonnull(tp_field_combine(value, TP_FORMULA_ADD, field.values + 1, &field));
  ck_assert(fmpz_mpoly_q_is_zero(value, field.ring));
  ck_assert_int_eq(tp_field_check(&field, (tp_place){"s", 2, 1}, &message), TP_NO_ANSWER);
  ck_assert_int_eq(strncmp(message.text, "s:2:1: the formulas take more work", 34), 0);
  tp_field_forgive(&field);
  ck_assert(!tp_field_spend(&field, 1));
  field.work->budget = TP_FIELD_BUDGET;
  fmpz_mpoly_q_clear(value, field.ring);
  tp_field_clear(&field);
  tp_scene_free(scene);
}
END_TEST

/* A block on a flat base, its vertices in four parameters. */
static const char quadrilateral[] =
    "topple: 1\nlength_unit: m\nparameters: {w: 4, h: 3, s: 1/2, t: 1}\n"
    "block: {outline: [[0, 0], [w, 0], [w + s, h], [t/2, 2*h - s*t]]}\nbase: {mated: true}\n"
    "tilt: {towards: both}\n";
enum { SYMBOLS = 4, CORNERS = 4, PLACES = 300 };

/* Its corners at the values of w, h, s, t. */
static void corners(mpq_t x[CORNERS], mpq_t y[CORNERS], mpq_t v[SYMBOLS]) {
  mpq_t two;
  mpq_init(two);
  mpq_set_si(two, 2, 1);
  mpq_set(x[1], v[0]);
  mpq_add(x[2], v[0], v[2]);
  mpq_set(y[2], v[1]);
  mpq_div(x[3], v[3], two);
  mpq_mul(y[3], v[2], v[3]);
  mpq_mul(two, two, v[1]);
  mpq_sub(y[3], two, y[3]);
  mpq_clear(two);
}

/* 2 A, 6 S_x, 6 S_y by the shoelace sums. */
static void shoelace(mpq_t sums[3], mpq_t x[CORNERS], mpq_t y[CORNERS]) {
  mpq_t cross, term;
  mpq_init(cross);
  mpq_init(term);
  for (int k = 0; k < 3; k++) mpq_set_si(sums[k], 0, 1);
  for (int k = 0; k < CORNERS; k++) {
    const int next = (k + 1) % CORNERS;
    mpq_mul(cross, x[k], y[next]);
    mpq_mul(term, x[next], y[k]);
    mpq_sub(cross, cross, term);
    mpq_add(sums[0], sums[0], cross);
    mpq_add(term, x[k], x[next]);
    mpq_mul(term, term, cross);
    mpq_add(sums[1], sums[1], term);
    mpq_add(term, y[k], y[next]);
    mpq_mul(term, term, cross);
    mpq_add(sums[2], sums[2], term);
  }
  mpq_clear(cross);
  mpq_clear(term);
}

/* Is the formula this number at the values? */
static void comes_to(const fmpz_mpoly_q_t formula, const fmpq *values, mpq_t number,
                     const tp_field *field) {
  fmpq_t own, truth;
  fmpq_init(own);
  fmpq_init(truth);
  fmpq_set_mpq(truth, number);
  ck_assert(tp_field_evaluate_at(own, formula, values, field));
  ck_assert(fmpq_equal(own, truth));
  fmpq_clear(own);
  fmpq_clear(truth);
}

/* The sums, and the arms about both ends of the base, which are left of it and right of it. */
static void check_sums(const tp_model *m, mpq_t v[SYMBOLS], mpq_t x[CORNERS], mpq_t y[CORNERS]) {
  const tp_field *field = &m->symbols.field;
  const fmpz_mpoly_ctx_struct *ring = field->ring;
  mpq_t sums[3], arm;
  fmpz_mpoly_q_t x_arm, y_arm;
  fmpq *values = calloc((size_t)field->symbol_count, sizeof *values);
  ck_assert_ptr_nonnull(values);
  for (long k = 0; k < field->symbol_count; k++) fmpq_init(values + k);
  for (int k = 0; k < SYMBOLS; k++) fmpq_set_mpq(values + k, v[k]);
  for (int k = 0; k < 3; k++) mpq_init(sums[k]);
  mpq_init(arm);
  fmpz_mpoly_q_init(x_arm, ring);
  fmpz_mpoly_q_init(y_arm, ring);
  corners(x, y, v);
  shoelace(sums, x, y);
  comes_to(m->formulas.area2, values, sums[0], field);
  comes_to(m->formulas.weighted2, values, sums[0], field);
  comes_to(m->formulas.x6, values, sums[1], field);
  comes_to(m->formulas.y6, values, sums[2], field);
  for (size_t k = 0; k < 2; k++) { /* 6 S_x - 3 (2 A) p_x, the other way round towards the right */
    const tp_direction towards = k == 0 ? TP_TOWARDS_LEFT : TP_TOWARDS_RIGHT;
    tp_symbolic_point pivot;
    ck_assert_int_eq(tp_model_pivot(&pivot, m, k, NULL), TP_OK);
    tp_model_arms(x_arm, y_arm, m, &pivot, towards);
    mpq_set_si(arm, 3, 1);
    mpq_mul(arm, arm, sums[0]);
    mpq_mul(arm, arm, x[k]);
    mpq_sub(arm, sums[1], arm);
    if (towards == TP_TOWARDS_RIGHT) mpq_neg(arm, arm);
    comes_to(x_arm, values, arm, field);
    comes_to(y_arm, values, sums[2], field);
  }
  fmpz_mpoly_q_clear(x_arm, ring);
  fmpz_mpoly_q_clear(y_arm, ring);
  mpq_clear(arm);
  for (int k = 0; k < 3; k++) mpq_clear(sums[k]);
  for (long k = 0; k < field->symbol_count; k++) fmpq_clear(values + k);
  free(values);
}

START_TEST(sums_are_shoelace_sums_at_all_values) {
  random_numbers random = random_numbers_from(9);
  tp_scene *scene = read_scene(quadrilateral);
  tp_model model;
  tp_message message = {.text = ""};
  mpq_t v[SYMBOLS], x[CORNERS], y[CORNERS];
  ck_assert_msg(tp_model_init(&model, scene, false, NULL, &message) == TP_OK, "%s", message.text);
  for (int k = 0; k < SYMBOLS; k++) mpq_init(v[k]);
  for (int k = 0; k < CORNERS; k++) {
    mpq_init(x[k]);
    mpq_init(y[k]);
  }
  for (int place = 0; place < PLACES; place++) {
    for (int k = 0; k < SYMBOLS; k++) {
      mpq_set_si(v[k], draw_below(&random, 2001) - 1000, 1 + (ulong)draw_below(&random, 97));
      mpq_canonicalize(v[k]);
    }
    check_sums(&model, v, x, y);
  }
  for (int k = 0; k < SYMBOLS; k++) mpq_clear(v[k]);
  for (int k = 0; k < CORNERS; k++) {
    mpq_clear(x[k]);
    mpq_clear(y[k]);
  }
  tp_model_clear(&model);
  tp_scene_free(scene);
}
END_TEST

/* Area, critical angle and factor by elements of a slab w wide and h high. */
START_TEST(formulas_of_a_slab) {
  tp_scene *scene = read_scene("topple: 1\nlength_unit: m\nparameters: {w: 2, h: 3}\n"
                               "block: {slab: {width: w, height: h}}\nbase: {mated: true}\n"
                               "tilt: {towards: left, angle_deg: 20}\n");
  tp_derive_options options = tp_derive_options_default();
  tp_derivation *derivation = NULL;
  tp_message message = {.text = ""};
  options.elements = true;
  ck_assert_msg(tp_derive(&derivation, scene, &options, &message) == TP_OK, "%s", message.text);
  ck_assert_str_eq(derivation->area.formula, "w*h");
  bool governed = false;
  for (size_t k = 0; k < derivation->pivot_count; k++) {
    const tp_derived_pivot *p = derivation->pivots + k;
    if (!p->governs) continue;
    governed = true;
    ck_assert_str_eq(p->x.formula, "0");
    ck_assert_str_eq(p->tan_critical_angle.numerator, "w");
    ck_assert_str_eq(p->tan_critical_angle.denominator, "h");
    ck_assert(p->has_elements && p->splits);
    ck_assert_str_eq(p->fos_cot.numerator, "w");
    ck_assert_str_eq(p->fos_cot.denominator, "h");
    ck_assert_str_eq(p->fos_constant.formula, "0");
    ck_assert_double_eq_tol(p->critical_angle_deg.value, 33.690067525979785, 1e-12);
  }
  ck_assert(governed);
  tp_derivation_free(derivation);
  tp_scene_free(scene);
}
END_TEST

SUITE(derive) {
  Suite *suite = suite_create("derive");
  TCase *derive = tcase_create("derive");
  tcase_add_test(derive, parameters_become_symbols);
  tcase_add_test(derive, what_has_no_formula);
  tcase_add_test(derive, work_is_counted);
  tcase_add_test(derive, sums_are_shoelace_sums_at_all_values);
  tcase_add_test(derive, formulas_of_a_slab);
  suite_add_tcase(suite, derive);
  return suite;
}
