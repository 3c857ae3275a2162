/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What a stage of a solve says of its own results: open where a higher rung may tell, undecided on
 * the last, taken for zero where so many bits do not tell from it; and the order of two angles. */

#include "evaluation/stages.h"
#include "suite.h"

/* A square of side 2, and the same with an arc, whose sums no rung has exactly. */
static const char *const square =
    "topple: 1\nlength_unit: m\nblock: {slab: {width: 2, height: 2}}\n";
static const char *const ellipse =
    "topple: 1\nlength_unit: m\nblock: {ellipse: {width: 4, height: 3, flat: 1}}\n";

typedef struct stage {
  tp_scene *scene;
  tp_solution *noted; /* what the preparation notes */
  tp_problem problem;
  tp_solve_options options;
  tp_evaluation e;
} stage;

static void stage_init(stage *s, const char *text, tp_rung rung) {
  tp_message message = {.text = ""};
  *s = (stage){.options = tp_solve_options_default(), .noted = calloc(1, sizeof *s->noted)};
  ck_assert_msg(tp_scene_read_text(&s->scene, text, "s", &message) == TP_OK, "%s", message.text);
  ck_assert_msg(tp_problem_init(&s->problem, s->scene, &s->options, s->noted, &message) == TP_OK,
                "%s", message.text);
  tp_evaluation_init(&s->e, &s->problem, rung, &s->options);
}

static void stage_clear(stage *s) {
  tp_evaluation_clear(&s->e);
  tp_problem_clear(&s->problem);
  tp_solution_free(s->noted);
  tp_scene_free(s->scene);
}

/* 1 with a bound of 2^log2_radius. */
static void one_within(arb_t ball, long log2_radius) {
  arb_one(ball);
  mag_set_ui_2exp_si(arb_radref(ball), 1, log2_radius);
}

static void about_zero(arb_t ball, long log2_radius) {
  arb_zero(ball);
  mag_set_ui_2exp_si(arb_radref(ball), 1, log2_radius);
}

/* 9 digits are asked for: 2^-40 is enough for them, 2^-20 is not. A wide ball is open on a rung
 * that has others above it, and an undecided number on the last one, where only what is no number
 * is open. */
START_TEST(open_below_undecided_above) {
  static const tp_rung low = {TP_LEVEL_DOUBLE, 64}, last = {TP_LEVEL_EXACT, 5120};
  stage s;
  arb_t ball;
  arb_init(ball);
  for (int k = 0; k < 2; k++) {
    stage_init(&s, square, k == 0 ? low : last);
    tp_certainty narrow = {0}, wide = {0}, none = {0}, told = {0};
    one_within(ball, -40);
    ck_assert_double_eq(tp_result(&s.e, ball, &narrow).value, 1);
    ck_assert(!narrow.open && !narrow.undecided_number);
    one_within(ball, -20);
    const tp_bounded given = tp_result(&s.e, ball, &wide);
    ck_assert_double_ge(given.error, 0x1p-20);
    ck_assert(wide.open == (k == 0) && wide.undecided_number == (k == 1));
    arb_indeterminate(ball);
    (void)tp_result(&s.e, ball, &none);
    ck_assert(none.open && !none.undecided_number);
    tp_certainty_leave_open(&told, &s.e);
    ck_assert(told.open == (k == 0) && !told.undecided_number);
    ck_assert(narrow.zero_bits == 0 && wide.zero_bits == 0 && none.zero_bits == 0);
    stage_clear(&s);
  }
  arb_clear(ball);
}
END_TEST

/* A coordinate is told against the block's size: what is 2^-40 off zero is, of a block of 1 m. */
START_TEST(coordinates_against_the_size) {
  stage s;
  arb_t ball;
  arb_init(ball);
  stage_init(&s, square, (tp_rung){TP_LEVEL_DOUBLE, 64});
  about_zero(ball, -40);
  tp_certainty by_itself = {0}, by_size = {0}, by_small_size = {0};
  (void)tp_result(&s.e, ball, &by_itself);
  (void)tp_result_within(&s.e, ball, 0, &by_size);
  (void)tp_result_within(&s.e, ball, -20, &by_small_size);
  ck_assert(by_itself.open && !by_size.open && by_small_size.open);
  stage_clear(&s);
  arb_clear(ball);
}
END_TEST

/* A zero that no rung has exactly: only where no rung does, from 160 bits on, and only if the ball
 * is narrower than half of them against the scale. */
START_TEST(zeros_of_enclosed_sums) {
  static const struct {
    const char *scene;
    long bits, log2_radius, log2_scale;
    bool is_zero;
  } balls[] = {{ellipse, 160, -84, 0, true},   {ellipse, 160, -76, 0, false},
               {ellipse, 160, -79, 5, true},   {ellipse, 64, -200, 0, false},
               {square, 160, -200, 0, false},  {ellipse, 1280, -644, 0, true},
               {ellipse, 1280, -636, 0, false}};
  arb_t ball;
  arb_init(ball);
  for (size_t k = 0; k < sizeof balls / sizeof balls[0]; k++) {
    stage s;
    stage_init(&s, balls[k].scene, (tp_rung){TP_LEVEL_BALL, balls[k].bits});
    about_zero(ball, balls[k].log2_radius);
    ck_assert_msg(tp_is_zero_width(&s.e, ball, (double)balls[k].log2_scale) == balls[k].is_zero,
                  "ball %zu", k);
    tp_certainty certainty = {0};
    (void)tp_result_scaled(&s.e, ball, (double)balls[k].log2_scale, &certainty);
    ck_assert_msg(certainty.open != balls[k].is_zero, "ball %zu", k);
    stage_clear(&s);
  }
  arb_clear(ball);
}
END_TEST

/* What one part does not know the whole does not; the fewest bits that took a zero are told. */
START_TEST(certainties_add) {
  tp_certainty sum = {0};
  tp_certainty_add(&sum, &(tp_certainty){.zero_bits = 1280});
  tp_certainty_add(&sum, &(tp_certainty){0});
  ck_assert(!sum.open && !sum.undecided_number && sum.zero_bits == 1280);
  tp_certainty_add(&sum, &(tp_certainty){.open = true, .zero_bits = 160});
  tp_certainty_add(&sum, &(tp_certainty){.undecided_number = true, .zero_bits = 5120});
  tp_certainty_add(&sum, &(tp_certainty){0});
  ck_assert(sum.open && sum.undecided_number && sum.zero_bits == 160);
}
END_TEST

/* atan2(sine, cosine) by whole numbers, with its degrees to 64 bits. */
static void set_angle(tp_direction_ball *angle, long sine, long cosine, long bits) {
  arb_t pi;
  arb_init(pi);
  arb_set_si(angle->sine, sine);
  arb_set_si(angle->cosine, cosine);
  arb_const_pi(pi, bits);
  arb_atan2(angle->degrees, angle->sine, angle->cosine, bits);
  arb_mul_ui(angle->degrees, angle->degrees, 180, bits);
  arb_div(angle->degrees, angle->degrees, pi, bits);
  angle->exact_direction = true;
  arb_clear(pi);
}

/* Directions in whole numbers: on an exact rung a tie is proven, and 1 in 10^15 is none; below it
 * the same balls are left open; by many bits of what no rung has exactly a tie is taken, and told.
 */
START_TEST(order_of_angles) {
  static const struct {
    const char *scene;
    tp_rung rung;
    long sine, cosine; /* against 1 over 1 */
    int sign;
    bool open;
    long tie_bits, zero_bits;
  } orders[] = {
      {square, {TP_LEVEL_EXACT, 320}, 3, 3, 0, false, 0, 0},
      {square, {TP_LEVEL_EXACT, 320}, 1000000000000001, 1000000000000000, 1, false, 0, 0},
      {square, {TP_LEVEL_EXACT, 320}, 1000000000000000, 1000000000000001, -1, false, 0, 0},
      {square, {TP_LEVEL_DOUBLE, 64}, 2, 1, 1, false, 0, 0},
      {square, {TP_LEVEL_DOUBLE, 64}, 3, 3, 0, true, 64, 0},
      {ellipse, {TP_LEVEL_BALL, 160}, 3, 3, 0, true, 160, 0},
      {ellipse, {TP_LEVEL_BALL, 1280}, 3, 3, 0, false, 1280, 1280},
  };
  tp_direction_ball a, b;
  tp_direction_ball_init(&a);
  tp_direction_ball_init(&b);
  for (size_t k = 0; k < sizeof orders / sizeof orders[0]; k++) {
    stage s;
    stage_init(&s, orders[k].scene, orders[k].rung);
    set_angle(&a, orders[k].sine, orders[k].cosine, orders[k].rung.bits);
    set_angle(&b, 1, 1, orders[k].rung.bits);
    tp_certainty certainty = {0}, compared = {0};
    const tp_angle_order order = tp_direction_ball_order(&s.e, &a, &b, &certainty);
    ck_assert_msg(order.sign == orders[k].sign, "order %zu: %d", k, order.sign);
    ck_assert_msg(order.tie_bits == orders[k].tie_bits, "order %zu: %ld", k, order.tie_bits);
    ck_assert_msg(certainty.open == orders[k].open && certainty.zero_bits == 0, "order %zu", k);
    ck_assert_int_eq(tp_direction_ball_compare(&s.e, &a, &b, &compared), order.sign);
    ck_assert_msg(compared.open == orders[k].open && compared.zero_bits == orders[k].zero_bits,
                  "order %zu: %ld", k, compared.zero_bits);
    stage_clear(&s);
  }
  tp_direction_ball_clear(&a);
  tp_direction_ball_clear(&b);
}
END_TEST

/* Angles a millionth of a degree apart count as one; what the bounds leave between is open. */
START_TEST(above_by_a_millionth) {
  stage s;
  stage_init(&s, square, (tp_rung){TP_LEVEL_DOUBLE, 64});
  const tp_bounded low = {.value = 30};
  static const struct {
    double value, error;
    bool above, open;
  } highs[] = {{30, 0, false, false},
               {30.0000005, 1e-9, false, false},
               {30.0000015, 1e-9, true, false},
               {30.0000015, 1e-6, true, true},
               {29, 0, false, false}};
  for (size_t k = 0; k < sizeof highs / sizeof highs[0]; k++) {
    tp_certainty certainty = {0};
    const tp_bounded high = {.value = highs[k].value, .error = highs[k].error};
    ck_assert_msg(tp_result_is_above(&s.e, high, low, &certainty) == highs[k].above, "%zu", k);
    ck_assert_msg(certainty.open == highs[k].open, "%zu", k);
  }
  stage_clear(&s);
}
END_TEST

SUITE(certainty) {
  Suite *suite = suite_create("certainty");
  TCase *tests = tcase_create("certainty");
  tcase_add_test(tests, open_below_undecided_above);
  tcase_add_test(tests, coordinates_against_the_size);
  tcase_add_test(tests, zeros_of_enclosed_sums);
  tcase_add_test(tests, certainties_add);
  tcase_add_test(tests, order_of_angles);
  tcase_add_test(tests, above_by_a_millionth);
  suite_add_tcase(suite, tests);
  return suite;
}
