/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Rational poses: applied, inverted, pinned to a point, turned along a direction or by tan(t / 2),
 * and put over a common denominator so that points are turned in whole numbers. */

#include "rest/pose.h"

#include "plane/direction.h"

void tp_pose_init(tp_pose *pose) {
  fmpq_init(pose->cosine);
  fmpq_init(pose->sine);
  fmpq_init(pose->shift_x);
  fmpq_init(pose->shift_y);
  fmpq_one(pose->cosine);
}

void tp_pose_clear(tp_pose *pose) {
  fmpq_clear(pose->cosine);
  fmpq_clear(pose->sine);
  fmpq_clear(pose->shift_x);
  fmpq_clear(pose->shift_y);
}

void tp_pose_set(tp_pose *pose, const tp_pose *other) {
  fmpq_set(pose->cosine, other->cosine);
  fmpq_set(pose->sine, other->sine);
  fmpq_set(pose->shift_x, other->shift_x);
  fmpq_set(pose->shift_y, other->shift_y);
}

/* (a + i b) (u + i v) */
static void multiply(fmpq_t x, fmpq_t y, const fmpq_t a, const fmpq_t b, const fmpq_t u,
                     const fmpq_t v) {
  fmpq_t real, imaginary;
  fmpq_init(real);
  fmpq_init(imaginary);
  fmpq_mul(real, a, u);
  fmpq_submul(real, b, v);
  fmpq_mul(imaginary, a, v);
  fmpq_addmul(imaginary, b, u);
  fmpq_swap(x, real);
  fmpq_swap(y, imaginary);
  fmpq_clear(real);
  fmpq_clear(imaginary);
}

void tp_pose_turn_vector(fmpq_t x, fmpq_t y, const tp_pose *pose) {
  multiply(x, y, pose->cosine, pose->sine, x, y);
}

void tp_whole_pose_init(tp_whole_pose *whole) {
  fmpz_init(whole->cosine);
  fmpz_init(whole->sine);
  fmpz_init(whole->shift_x);
  fmpz_init(whole->shift_y);
  fmpz_init(whole->denominator);
}

void tp_whole_pose_clear(tp_whole_pose *whole) {
  fmpz_clear(whole->cosine);
  fmpz_clear(whole->sine);
  fmpz_clear(whole->shift_x);
  fmpz_clear(whole->shift_y);
  fmpz_clear(whole->denominator);
}

/* The numerator of a value over a denominator that its own divides. */
static void set_over(fmpz_t numerator, const fmpq_t value, const fmpz_t denominator) {
  fmpz_divexact(numerator, denominator, fmpq_denref(value));
  fmpz_mul(numerator, numerator, fmpq_numref(value));
}

void tp_whole_pose_set(tp_whole_pose *whole, const tp_pose *pose) {
  fmpz_lcm(whole->denominator, fmpq_denref(pose->cosine), fmpq_denref(pose->sine));
  fmpz_lcm(whole->denominator, whole->denominator, fmpq_denref(pose->shift_x));
  fmpz_lcm(whole->denominator, whole->denominator, fmpq_denref(pose->shift_y));
  set_over(whole->cosine, pose->cosine, whole->denominator);
  set_over(whole->sine, pose->sine, whole->denominator);
  set_over(whole->shift_x, pose->shift_x, whole->denominator);
  set_over(whole->shift_y, pose->shift_y, whole->denominator);
}

void tp_whole_pose_apply(fmpq_t x, fmpq_t y, const tp_whole_pose *whole, const fmpq_t own_x,
                         const fmpq_t own_y) {
  fmpz_t common, i, j;
  fmpz_init(common);
  fmpz_init(i);
  fmpz_init(j);
  fmpz_lcm(common, fmpq_denref(own_x), fmpq_denref(own_y));
  set_over(i, own_x, common);
  set_over(j, own_y, common);
  fmpz_mul(fmpq_numref(x), whole->cosine, i);
  fmpz_submul(fmpq_numref(x), whole->sine, j);
  fmpz_addmul(fmpq_numref(x), whole->shift_x, common);
  fmpz_mul(fmpq_numref(y), whole->sine, i);
  fmpz_addmul(fmpq_numref(y), whole->cosine, j);
  fmpz_addmul(fmpq_numref(y), whole->shift_y, common);
  fmpz_mul(fmpq_denref(x), whole->denominator, common);
  fmpz_set(fmpq_denref(y), fmpq_denref(x));
  fmpq_canonicalise(x);
  fmpq_canonicalise(y);
  fmpz_clear(common);
  fmpz_clear(i);
  fmpz_clear(j);
}

void tp_pose_undo(fmpq_t own_x, fmpq_t own_y, const tp_pose *pose, const fmpq_t x, const fmpq_t y) {
  fmpq_t dx, dy, square;
  fmpq_init(dx);
  fmpq_init(dy);
  fmpq_init(square);
  fmpq_mul(square, pose->cosine, pose->cosine);
  fmpq_addmul(square, pose->sine, pose->sine);
  fmpq_sub(dx, x, pose->shift_x);
  fmpq_sub(dy, y, pose->shift_y);
  fmpq_div(dx, dx, square);
  fmpq_div(dy, dy, square);
  fmpq_neg(square, pose->sine);
  multiply(own_x, own_y, pose->cosine, square, dx, dy);
  fmpq_clear(dx);
  fmpq_clear(dy);
  fmpq_clear(square);
}

void tp_pose_pin(tp_pose *pose, const fmpq_t own_x, const fmpq_t own_y, const fmpq_t x,
                 const fmpq_t y) {
  fmpq_t at_x, at_y;
  fmpq_init(at_x);
  fmpq_init(at_y);
  multiply(at_x, at_y, pose->cosine, pose->sine, own_x, own_y);
  fmpq_sub(pose->shift_x, x, at_x);
  fmpq_sub(pose->shift_y, y, at_y);
  fmpq_clear(at_x);
  fmpq_clear(at_y);
}

void tp_pose_turn_along(tp_pose *pose, const fmpq_t u, const fmpq_t v) {
  fmpq_t x, y;
  fmpq_init(x);
  fmpq_init(y);
  multiply(x, y, pose->cosine, pose->sine, u, v);
  tp_direction_unit(pose->cosine, pose->sine, x, y);
  fmpq_clear(x);
  fmpq_clear(y);
}

void tp_pose_turn_half(tp_pose *pose, const fmpq_t t) {
  fmpq_t cosine, sine, whole;
  fmpq_init(cosine);
  fmpq_init(sine);
  fmpq_init(whole);
  fmpq_mul(cosine, t, t);
  fmpq_add_si(whole, cosine, 1);
  fmpq_neg(cosine, cosine);
  fmpq_add_si(cosine, cosine, 1);
  fmpq_mul_si(sine, t, 2);
  fmpq_div(cosine, cosine, whole);
  fmpq_div(sine, sine, whole);
  multiply(pose->cosine, pose->sine, pose->cosine, pose->sine, cosine, sine);
  fmpq_clear(cosine);
  fmpq_clear(sine);
  fmpq_clear(whole);
}

void tp_pose_scale(tp_pose *pose, const fmpq_t factor) {
  fmpq_mul(pose->cosine, pose->cosine, factor);
  fmpq_mul(pose->sine, pose->sine, factor);
}

bool tp_pose_is_true(const tp_pose *pose) {
  fmpq_t square, most;
  fmpq_init(square);
  fmpq_init(most);
  fmpq_mul(square, pose->cosine, pose->cosine);
  fmpq_addmul(square, pose->sine, pose->sine);
  fmpq_sub_si(square, square, 1);
  fmpq_abs(square, square);
  fmpq_one(most);
  fmpq_div_2exp(most, most, TP_POSE_TRUE_BITS);
  const bool is_true = fmpq_cmp(square, most) <= 0;
  fmpq_clear(square);
  fmpq_clear(most);
  return is_true;
}

/* By the tangent of half the angle, sine / (1 + cosine), which is at most 1 in size where the
 * cosine is not negative; else of half the opposite direction's. */
void tp_pose_shorten(tp_pose *pose) {
  const bool opposite = fmpq_sgn(pose->cosine) < 0;
  fmpq_t t;
  fmpz_t whole;
  fmpq_init(t);
  fmpz_init(whole);
  fmpq_set(t, pose->cosine);
  if (opposite) fmpq_neg(t, t);
  fmpq_add_si(t, t, 1);
  fmpq_div(t, pose->sine, t);
  if (opposite) fmpq_neg(t, t);
  if (fmpq_height_bits(t) > TP_POSE_BITS) {
    fmpq_mul_2exp(t, t, TP_POSE_BITS);
    fmpz_tdiv_q(whole, fmpq_numref(t), fmpq_denref(t));
    fmpq_set_fmpz(t, whole);
    fmpq_div_2exp(t, t, TP_POSE_BITS);
  }
  fmpq_one(pose->cosine);
  if (opposite) fmpq_neg(pose->cosine, pose->cosine);
  fmpq_zero(pose->sine);
  tp_pose_turn_half(pose, t);
  fmpq_clear(t);
  fmpz_clear(whole);
}
