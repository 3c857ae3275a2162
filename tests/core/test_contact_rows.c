/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Rows of a contact point, edges of its friction cone, moments, inertia and the power of the weight
 * (plane/contact_rows.h), as they are once for all arithmetics.
 *
 * What they are is held to how points move, by which they are not written: under a twist (v, omega)
 * the point q moves by v + omega x q, and a force e there has the power e . (v + omega x q). All is
 * drawn as small whole numbers, and frictions as eighths, so that doubles and balls are exact, and
 * have to be the same; doubles with bounds have to hold them. */

#include "number/ball.h"
#include "plane/contact_rows.h"
#include "random_numbers.h"
#include "suite.h"

/* Where each result stands. */
enum {
  NORMAL = 0,
  SLIP = 3,
  EDGES = 6, /* with their moments from the levers; along, against */
  ROWS = 12, /* the same from the rows */
  TURN = 18,
  INERTIA = 21,
  RESPONSE = 24,
  SLOPE = 27,
  LEVEL,
  POWER,
  CROSS,
  RESULTS = CROSS + 3
};

/* A twist, a point, tan(phi), a scale or weight, a centroid and a radius of gyration squared. */
enum { TWIST = 0, POINT = 3, FRICTION = 5, SCALE, CENTROID, GYRATION = 9, NUMBERS };

/* All of them, of numbers `in` and a direction t; what operations need besides comes last. */
#define FILL(name, out, in, t, ...)                                                                \
  do {                                                                                             \
    tp_##name##_normal_row((out) + NORMAL, (in) + POINT, (in) + POINT + 1, t,                      \
                           (t) + 1 __VA_ARGS__);                                                   \
    tp_##name##_slip_row((out) + SLIP, (in) + POINT, (in) + POINT + 1, t, (t) + 1 __VA_ARGS__);    \
    for (int against = 0; against < 2; against++) {                                                \
      tp_##name##_cone_edge((out) + EDGES + 3 * against, t, (t) + 1, (in) + FRICTION,              \
                            against == 1 __VA_ARGS__);                                             \
      tp_##name##_moment((out) + EDGES + 3 * against, (in) + POINT, (in) + POINT + 1 __VA_ARGS__); \
      tp_##name##_cone_row((out) + ROWS + 3 * against, (out) + NORMAL, (out) + SLIP,               \
                           (in) + FRICTION, against == 1 __VA_ARGS__);                             \
    }                                                                                              \
    tp_##name##_turn((out) + TURN, (in) + POINT, (in) + POINT + 1 __VA_ARGS__);                    \
    tp_##name##_inertia((out) + INERTIA, (in) + TWIST, (in) + SCALE, (in) + CENTROID,              \
                        (in) + CENTROID + 1, (in) + GYRATION, true __VA_ARGS__);                   \
    tp_##name##_response((out) + RESPONSE, (out) + NORMAL, (in) + SCALE, (in) + CENTROID,          \
                         (in) + CENTROID + 1, (in) + GYRATION __VA_ARGS__);                        \
    tp_##name##_weight_power((out) + SLOPE, (out) + LEVEL, (in) + TWIST, (in) + SCALE,             \
                             (in) + CENTROID, (in) + CENTROID + 1 __VA_ARGS__);                    \
    tp_##name##_set_dot((out) + POWER, (out) + NORMAL, (in) + TWIST __VA_ARGS__);                  \
    tp_##name##_cross((out) + CROSS, (in) + TWIST, (out) + NORMAL __VA_ARGS__);                    \
  } while (0)

static random_numbers state;

static void draw_contact(double in[NUMBERS], double t[2]) {
  for (int k = 0; k < NUMBERS; k++) in[k] = (double)draw_below(&state, 41) - 20;
  in[FRICTION] = (double)draw_below(&state, 9) / 8;
  in[SCALE] = (double)(1 + draw_below(&state, 9));
  in[GYRATION] = (double)(1 + draw_below(&state, 9));
  for (int k = 0; k < 2; k++) t[k] = (double)draw_below(&state, 13) - 6;
}

static double power(const double triple[3], const double twist[3]) {
  return triple[0] * twist[0] + triple[1] * twist[1] + triple[2] * twist[2];
}

START_TEST(rows_tell_how_points_move) {
  state = random_numbers_from(71);
  for (long run = 0; run < rounds(2000, 200000); run++) {
    double in[NUMBERS], t[2], out[RESULTS];
    draw_contact(in, t);
    FILL(double, out, in, t);
    const double *a = in + TWIST, *q = in + POINT;
    const double vx = a[0] - a[2] * q[1], vy = a[1] + a[2] * q[0];
    const double open = -t[1] * vx + t[0] * vy, slip = t[0] * vx + t[1] * vy;
    ck_assert(power(out + NORMAL, a) == open && out[POWER] == open);
    ck_assert(power(out + SLIP, a) == slip);
    for (int against = 0; against < 2; against++) {
      const double along = against == 1 ? -in[FRICTION] : in[FRICTION];
      ck_assert(power(out + EDGES + 3 * against, a) == open + along * slip);
      ck_assert(power(out + ROWS + 3 * against, a) == open + along * slip);
    }
    const double *turn = out + TURN; /* its point stays */
    ck_assert(turn[0] == turn[2] * q[1] && turn[1] == -turn[2] * q[0] && turn[2] == 1);
    const double s = in[SCALE], *c = in + CENTROID; /* the centroid's way, s times as long */
    const double cx = s * a[0] - a[2] * c[1], cy = s * a[1] + a[2] * c[0];
    const double *inertia = out + INERTIA;
    ck_assert(inertia[0] == cx && inertia[1] == cy && inertia[2] == in[GYRATION] * a[2]);
    ck_assert(power(out + RESPONSE, inertia) == in[GYRATION] * s * open);
    ck_assert(out[SLOPE] == -cx && out[LEVEL] == -cy); /* the weight s (-tan, -1) at it */
    ck_assert(power(out + CROSS, a) == 0 && power(out + CROSS, out + NORMAL) == 0);
  }
}
END_TEST

/* The zero that bounds of exact zeros have is of the size of DBL_MIN. */
static void check_near(const tp_near *near, const double *out) {
  for (int k = 0; k < RESULTS; k++) {
    ck_assert(fabs(near[k].value - out[k]) <= near[k].error);
    ck_assert(near[k].error <= 1e-9);
  }
}

START_TEST(arithmetics_agree) {
  state = random_numbers_from(72);
  arb_ptr balls = _arb_vec_init(NUMBERS), of_balls = _arb_vec_init(RESULTS);
  fmpz *whole = _fmpz_vec_init(2);
  for (long run = 0; run < rounds(2000, 200000); run++) {
    double in[NUMBERS], t[2], out[RESULTS];
    tp_near near[NUMBERS], near_t[2], of_near[RESULTS], sparse[RESULTS];
    draw_contact(in, t);
    for (int k = 0; k < NUMBERS; k++) {
      near[k] = (tp_near){in[k], 0};
      arb_set_d(balls + k, in[k]);
    }
    for (int k = 0; k < 2; k++) {
      near_t[k] = (tp_near){t[k], 0};
      fmpz_set_d(whole + k, t[k]);
    }
    FILL(double, out, in, t);
    FILL(near, of_near, near, near_t);
    FILL(sparse, sparse, near, near_t);
    FILL(ball, of_balls, balls, whole, , ARF_PREC_EXACT);
    check_near(of_near, out);
    check_near(sparse, out);
    for (int k = 0; k < RESULTS; k++) {
      ck_assert(arb_is_exact(of_balls + k));
      ck_assert(arf_cmp_d(arb_midref(of_balls + k), out[k]) == 0);
    }
    /* what is nothing by its factors stays nothing without an error */
    if (t[1] == 0) ck_assert(tp_near_is_zero(sparse[NORMAL]) && tp_near_is_zero(sparse[SLIP + 1]));
    if (in[FRICTION] == 0 && t[1] == 0) ck_assert(tp_near_is_zero(sparse[ROWS]));
  }
  _arb_vec_clear(balls, NUMBERS);
  _arb_vec_clear(of_balls, RESULTS);
  _fmpz_vec_clear(whole, 2);
}
END_TEST

SUITE(contact_rows) {
  Suite *suite = suite_create("contact_rows");
  TCase *rows = tcase_create("rows");
  tcase_add_test(rows, rows_tell_how_points_move);
  tcase_add_test(rows, arithmetics_agree);
  suite_add_tcase(suite, rows);
  return suite;
}
