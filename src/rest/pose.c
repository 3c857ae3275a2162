/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

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

void tp_pose_apply(fmpq_t x, fmpq_t y, const tp_pose *pose, const fmpq_t own_x,
                   const fmpq_t own_y) {
  multiply(x, y, pose->cosine, pose->sine, own_x, own_y);
  fmpq_add(x, x, pose->shift_x);
  fmpq_add(y, y, pose->shift_y);
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
