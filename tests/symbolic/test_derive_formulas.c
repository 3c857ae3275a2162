/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The moments and lever arms of a block in symbols against sums over triangles in rationals, at the
 * scene's parameters and at others, for which the outline need not even be one: the formulas are
 * identities. Blocks: stars with a hole and a part of its own density, linear in two parameters. */

#include "derive/model.h"
#include "exact_vectors.h"
#include "random_numbers.h"
#include "suite.h"

#include <flint/fmpq_vec.h>
#include <stdio.h>
#include <unistd.h>

enum { ROUNDS = 60, PLACES = 5, STAR = 8, RINGS = 3, PARAMETERS = 2 };

static random_numbers state;

/* constant + a[0] first + a[1] second parameter */
typedef struct linear {
  long constant, a[PARAMETERS];
} linear;

typedef struct vertex {
  linear x, y;
} vertex;

/* The outline, the hole and the part, counter-clockwise; densities of block and part. */
typedef struct block {
  long count[RINGS];
  vertex vertices[RINGS][STAR];
  long density, part_density;
  long denominator; /* of the parameters: 1 / it and 2 / it */
} block;

static linear draw_linear(long constant) {
  return (linear){constant, {draw_below(&state, 3) - 1, draw_below(&state, 3) - 1}};
}

/* The parameters are at most 2 / 3, so that no vertex moves by more than 1: the star keeps its
 * form, and its triangles theirs within the circle of 12 that it covers. */
static void draw_block(block *b) {
  static const long rays[STAR][2] = {{5, 0},  {4, 4},   {0, 5},  {-4, 4},
                                     {-5, 0}, {-4, -4}, {0, -5}, {4, -4}};
  static const long triangle[3][2] = {{-3, -2}, {3, -2}, {0, 3}};
  *b = (block){.count = {STAR, 3, 3}};
  for (long k = 0; k < STAR; k++) {
    const long far = 4 + draw_below(&state, 3);
    b->vertices[0][k] = (vertex){draw_linear(far * rays[k][0]), draw_linear(far * rays[k][1])};
  }
  for (long r = 1; r < RINGS; r++) {
    for (long k = 0; k < 3; k++) {
      const long y = triangle[k][1] + (r == 1 ? 6 : -6);
      b->vertices[r][k] = (vertex){draw_linear(triangle[k][0]), draw_linear(y)};
    }
  }
  b->density = 20 + draw_below(&state, 9);
  b->part_density = 10 + draw_below(&state, 30);
  b->denominator = 3 + draw_below(&state, 5);
}

static void write_ring(FILE *file, const block *b, long r) {
  fputs("[", file);
  for (long k = 0; k < b->count[r]; k++) {
    const vertex *v = b->vertices[r] + k;
    fprintf(file, "%s[%ld + %ld*a + %ld*b, %ld + %ld*a + %ld*b]", k > 0 ? ", " : "", v->x.constant,
            v->x.a[0], v->x.a[1], v->y.constant, v->y.a[0], v->y.a[1]);
  }
  fputs("]", file);
}

static void read_scene(tp_scene **scene, const block *b) {
  char path[] = "/tmp/topple-derive-XXXXXX";
  tp_message message = {.text = ""};
  const int handle = mkstemp(path);
  ck_assert_int_ge(handle, 0);
  FILE *file = fdopen(handle, "w");
  ck_assert_ptr_nonnull(file);
  fprintf(file, "topple: 1\nlength_unit: m\nparameters: {a: 1/%ld, b: 2/%ld}\nblock:\n  outline: ",
          b->denominator, b->denominator);
  write_ring(file, b, 0);
  fputs("\n  holes: [", file);
  write_ring(file, b, 1);
  fputs("]\n  parts: [{outline: ", file);
  write_ring(file, b, 2);
  fprintf(file, ", unit_weight_kn_m3: %ld}]\n  unit_weight_kn_m3: %ld\n", b->part_density,
          b->density);
  fputs("base: {mated: whole}\ntilt: {towards: left}\n", file);
  fclose(file);
  const tp_status status = tp_scene_read(scene, path, &message);
  unlink(path);
  ck_assert_msg(status == TP_OK, "%s", message.text);
}

static void value_of(fmpq_t value, const linear *f, const fmpq *parameters) {
  fmpq_t term;
  fmpq_init(term);
  fmpq_set_si(value, f->constant, 1);
  for (int k = 0; k < PARAMETERS; k++) {
    fmpq_mul_si(term, parameters + k, f->a[k]);
    fmpq_add(value, value, term);
  }
  fmpq_clear(term);
}

/* What the formulas are of: 2 A without weights, 2 A, 6 S_x, 6 S_y, 12 times the polar moment. */
enum { AREA, WEIGHTED, SUM_X, SUM_Y, POLAR, SUMS };

/* c = det of the triangle's sides: 2 A = c, 6 S_x = c sum x_i, 24 integral of x^2 = c ((sum x_i)^2
 * + sum x_i^2). */
static void add_triangle(fmpq sums[SUMS], const exact_point *const corner[3], const fmpq_t weight,
                         int sign) {
  fmpq_t c, sum, part, left, up;
  fmpq_init(c);
  fmpq_init(sum);
  fmpq_init(part);
  fmpq_init(left);
  fmpq_init(up);
  fmpq_sub(left, &corner[1]->x, &corner[0]->x);
  fmpq_sub(up, &corner[2]->y, &corner[0]->y);
  fmpq_mul(c, left, up);
  fmpq_sub(left, &corner[2]->x, &corner[0]->x);
  fmpq_sub(up, &corner[1]->y, &corner[0]->y);
  fmpq_submul(c, left, up);
  if (sign > 0) fmpq_add(sums + AREA, sums + AREA, c);
  if (sign < 0) fmpq_sub(sums + AREA, sums + AREA, c);
  fmpq_mul(c, c, weight);
  fmpq_add(sums + WEIGHTED, sums + WEIGHTED, c);
  for (int axis = 0; axis < 2; axis++) {
    fmpq_zero(sum);
    fmpq_zero(part);
    for (int k = 0; k < 3; k++) {
      const fmpq *own = axis == 0 ? &corner[k]->x : &corner[k]->y;
      fmpq_add(sum, sum, own);
      fmpq_addmul(part, own, own);
    }
    fmpq_addmul(sums + SUM_X + axis, c, sum);
    fmpq_addmul(part, sum, sum);
    fmpq_div_2exp(part, part, 1);
    fmpq_addmul(sums + POLAR, c, part);
  }
  fmpq_clear(c);
  fmpq_clear(sum);
  fmpq_clear(part);
  fmpq_clear(left);
  fmpq_clear(up);
}

/* Fans of triangles from the first vertex of each ring. */
static void sum_triangles(fmpq sums[SUMS], const block *b, const fmpq *parameters) {
  static const int signs[RINGS] = {1, -1, 0};
  fmpq_t weight;
  exact_point at[3];
  const exact_point *const corner[3] = {at, at + 1, at + 2};
  fmpq_init(weight);
  for (int k = 0; k < 3; k++) exact_point_init(at + k);
  for (int k = 0; k < SUMS; k++) fmpq_zero(sums + k);
  for (long r = 0; r < RINGS; r++) {
    fmpq_set_si(weight, r == 2 ? b->part_density - b->density : signs[r] * b->density,
                (ulong)b->density);
    for (long k = 2; k < b->count[r]; k++) {
      const long which[3] = {0, k - 1, k};
      for (int c = 0; c < 3; c++) {
        value_of(&at[c].x, &b->vertices[r][which[c]].x, parameters);
        value_of(&at[c].y, &b->vertices[r][which[c]].y, parameters);
      }
      add_triangle(sums, corner, weight, signs[r]);
    }
  }
  fmpq_clear(weight);
  for (int k = 0; k < 3; k++) exact_point_clear(at + k);
}

static void check_value(const fmpz_mpoly_q_t formula, const fmpq_t truth, const fmpq *symbols,
                        const tp_field *field, const char *what) {
  fmpq_t value;
  fmpq_init(value);
  ck_assert_msg(tp_field_evaluate_at(value, formula, symbols, field), "%s", what);
  ck_assert_msg(fmpq_equal(value, truth), "%s", what);
  fmpq_clear(value);
}

/* The vertex of the outline in which a pivot lies at the scene's parameters. */
static long vertex_of(const block *b, const tp_symbolic_point *pivot, const fmpq *own,
                      const tp_field *field) {
  fmpq_t x, y, value;
  fmpq_init(x);
  fmpq_init(y);
  fmpq_init(value);
  ck_assert(tp_field_evaluate(x, pivot->x, field));
  ck_assert(tp_field_evaluate(y, pivot->y, field));
  long found = -1;
  for (long k = 0; k < STAR; k++) {
    value_of(value, &b->vertices[0][k].x, own);
    const bool same = fmpq_equal(value, x);
    value_of(value, &b->vertices[0][k].y, own);
    if (same && fmpq_equal(value, y)) found = k;
  }
  fmpq_clear(x);
  fmpq_clear(y);
  fmpq_clear(value);
  ck_assert_int_ge(found, 0);
  return found;
}

/* Its arms times six times the weighted area: S_6 - 3 A_2 p, the one along the base mirrored. */
static void check_pivot(const tp_model *model, const block *b, size_t k, const fmpq *own,
                        const fmpq *symbols, const fmpq sums[SUMS]) {
  const tp_field *field = &model->symbols.field;
  tp_symbolic_point pivot;
  tp_message message = {.text = ""};
  ck_assert_int_eq(tp_model_pivot(&pivot, model, k, &message), TP_OK);
  const vertex *v = b->vertices[0] + vertex_of(b, &pivot, own, field);
  fmpz_mpoly_q_t x_arm, y_arm;
  exact_point truth;
  fmpz_mpoly_q_init(x_arm, field->ring);
  fmpz_mpoly_q_init(y_arm, field->ring);
  exact_point_init(&truth);
  value_of(&truth.x, &v->x, symbols);
  value_of(&truth.y, &v->y, symbols);
  check_value(pivot.x, &truth.x, symbols, field, "pivot x");
  check_value(pivot.y, &truth.y, symbols, field, "pivot y");
  fmpq *const both[2] = {&truth.x, &truth.y};
  for (int axis = 0; axis < 2; axis++) {
    fmpq_mul(both[axis], both[axis], sums + WEIGHTED);
    fmpq_mul_si(both[axis], both[axis], 3);
    fmpq_sub(both[axis], sums + SUM_X + axis, both[axis]);
  }
  tp_model_arms(x_arm, y_arm, model, &pivot, TP_TOWARDS_LEFT);
  check_value(x_arm, &truth.x, symbols, field, "arm x");
  check_value(y_arm, &truth.y, symbols, field, "arm y");
  tp_model_arms(x_arm, y_arm, model, &pivot, TP_TOWARDS_RIGHT);
  fmpq_neg(&truth.x, &truth.x);
  check_value(x_arm, &truth.x, symbols, field, "arm x, mirrored");
  fmpz_mpoly_q_clear(x_arm, field->ring);
  fmpz_mpoly_q_clear(y_arm, field->ring);
  exact_point_clear(&truth);
}

/* The scene's parameters first, then others. */
static void set_parameters(fmpq *symbols, const block *b, int place) {
  for (int k = 0; k < PARAMETERS; k++) {
    const long top = place == 0 ? k + 1 : draw_below(&state, 99) - 49;
    fmpq_set_si(symbols + k, top, place == 0 ? (ulong)b->denominator : 7);
  }
}

START_TEST(formulas_are_the_sums_over_triangles) {
  state = random_numbers_from(101);
  long pivots = 0;
  for (int round = 0; round < ROUNDS; round++) {
    block b;
    tp_scene *scene = NULL;
    tp_model model;
    tp_message message = {.text = ""};
    draw_block(&b);
    read_scene(&scene, &b);
    const tp_status status = tp_model_init(&model, scene, false, NULL, &message);
    ck_assert_msg(status == TP_OK, "%s", message.text);
    const tp_field *field = &model.symbols.field;
    fmpz_mpoly_q_t polar;
    fmpz_mpoly_q_init(polar, field->ring);
    tp_formulas_polar(polar, &model.symbols, &model.problem.section);
    fmpq *symbols = _fmpq_vec_init(field->symbol_count), *own = _fmpq_vec_init(PARAMETERS);
    fmpq *sums = _fmpq_vec_init(SUMS);
    set_parameters(own, &b, 0);
    for (int place = 0; place < PLACES; place++) {
      const tp_formulas *f = &model.formulas;
      set_parameters(symbols, &b, place);
      sum_triangles(sums, &b, symbols);
      check_value(f->area2, sums + AREA, symbols, field, "area");
      check_value(f->weighted2, sums + WEIGHTED, symbols, field, "weighted area");
      check_value(f->x6, sums + SUM_X, symbols, field, "first moment x");
      check_value(f->y6, sums + SUM_Y, symbols, field, "first moment y");
      check_value(polar, sums + POLAR, symbols, field, "polar moment");
      for (long k = 0; k < model.problem.contact.point_count; k++, pivots++) {
        check_pivot(&model, &b, (size_t)k, own, symbols, sums);
      }
    }
    _fmpq_vec_clear(symbols, field->symbol_count);
    _fmpq_vec_clear(own, PARAMETERS);
    _fmpq_vec_clear(sums, SUMS);
    fmpz_mpoly_q_clear(polar, field->ring);
    tp_model_clear(&model);
    tp_scene_free(scene);
  }
  ck_assert_int_gt(pivots, ROUNDS * PLACES);
}
END_TEST

SUITE(derive_formulas) {
  Suite *suite = suite_create("derive_formulas");
  TCase *cases = tcase_create("derive_formulas");
  tcase_set_timeout(cases, 120);
  tcase_add_test(cases, formulas_are_the_sums_over_triangles);
  suite_add_tcase(suite, cases);
  return suite;
}
