/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "compare.h"

#include <math.h>
#include <stdio.h>

void compare_need(const comparison *c, bool holds, const char *what) {
  if (!holds && c->why[0] == '\0') snprintf(c->why, 256, "%s %s", what, c->where);
}

void compare_set_ball(arb_t ball, tp_bounded number) {
  arf_set_d(arb_midref(ball), number.value);
  mag_set_d(arb_radref(ball), number.error);
}

void compare_ball(const comparison *c, const arb_t expected, tp_bounded number, const char *what) {
  arb_t ball;
  arb_init(ball);
  compare_need(c, isfinite(number.value) && number.error >= 0, what);
  compare_set_ball(ball, number);
  compare_need(c, arb_overlaps(expected, ball) != 0, what);
  arb_clear(ball);
}

/* The other is the one times the length to a power. */
void compare_number(const comparison *c, tp_bounded one, tp_bounded other, int power,
                    const char *what) {
  arb_t expected, length;
  arb_init(expected);
  arb_init(length);
  compare_set_ball(expected, one);
  arb_set_fmpq(length, c->r->numbers + LENGTH, COMPARE_BITS);
  arb_pow_ui(length, length, (ulong)power, COMPARE_BITS);
  arb_mul(expected, expected, length, COMPARE_BITS);
  compare_ball(c, expected, other, what);
  arb_clear(expected);
  arb_clear(length);
}

static void add_product(arb_t sum, const fmpq *factor, const arb_t ball) {
  arb_t own;
  arb_init(own);
  arb_set_fmpq(own, factor, COMPARE_BITS);
  arb_addmul(sum, own, ball, COMPARE_BITS);
  arb_clear(own);
}

/* Row `row` of the map on (x, y). */
void compare_map_row(arb_t result, const relation *r, int row, const arb_t x, const arb_t y) {
  arb_zero(result);
  add_product(result, r->numbers + 2 * row, x);
  add_product(result, r->numbers + 2 * row + 1, y);
}

void compare_point(const comparison *c, const tp_bounded one[2], const tp_bounded other[2],
                   const char *what) {
  arb_t x, y, expected, shift;
  arb_init(x);
  arb_init(y);
  arb_init(expected);
  arb_init(shift);
  compare_set_ball(x, one[0]);
  compare_set_ball(y, one[1]);
  for (int row = 0; row < 2; row++) {
    compare_map_row(expected, c->r, row, x, y);
    arb_set_fmpq(shift, c->r->numbers + SHIFT_X + row, COMPARE_BITS);
    arb_add(expected, expected, shift, COMPARE_BITS);
    compare_ball(c, expected, other[row], what);
  }
  arb_clear(x);
  arb_clear(y);
  arb_clear(expected);
  arb_clear(shift);
}

/* Towards the left the other is the one less the turn, in degrees; towards the right, and more. Of
 * pivots they go about all of a circle. */
void compare_angle(const comparison *c, tp_bounded one, tp_bounded other, const char *what) {
  arb_t expected;
  arb_init(expected);
  compare_set_ball(expected, one);
  if (c->towards_right) {
    arb_add(expected, expected, c->r->turn_deg, COMPARE_BITS);
  } else {
    arb_sub(expected, expected, c->r->turn_deg, COMPARE_BITS);
  }
  if (c->r->turned && arf_cmp_d(arb_midref(expected), other.value - 180) < 0) {
    arb_add_ui(expected, expected, 360, COMPARE_BITS);
  }
  if (c->r->turned && arf_cmp_d(arb_midref(expected), other.value + 180) > 0) {
    arb_sub_ui(expected, expected, 360, COMPARE_BITS);
  }
  compare_ball(c, expected, other, what);
  arb_clear(expected);
}

void compare_fos(const comparison *c, tp_fos one, tp_fos other, const char *what) {
  if (c->r->turned) return;
  const bool open = one.state == TP_FOS_UNDECIDED || other.state == TP_FOS_UNDECIDED;
  compare_need(c, one.state == other.state || open || c->r->uncertain, what);
  if (one.state == TP_FOS_NUMBER && other.state == TP_FOS_NUMBER) {
    compare_number(c, one.value, other.value, 0, what);
  }
}
