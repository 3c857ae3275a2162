/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Balls of 256 bits, of which the middles are rounded to 2^-100. */

#include "solid_tilt/hold_frame.h"

#include <math.h>

enum { BITS = 256, PLACES = 100, EAST = 0, NORTH = 1, UP = 2 };

/* ---- axes --------------------------------------------------------------------------------------
 */

static void set_up(arb_struct up[3], const fmpz given[3]) {
  arb_t length;
  arb_init(length);
  for (int k = 0; k < 3; k++) {
    arb_set_fmpz(up + k, given + k);
    arb_addmul(length, up + k, up + k, BITS);
  }
  arb_sqrt(length, length, BITS);
  for (int k = 0; k < 3; k++) arb_div(up + k, up + k, length, BITS);
  arb_clear(length);
}

/* Upside down: by the turn about x. */
static void turn_about_x(tp_hold_frame *frame) {
  arb_one(frame->axes[EAST]);
  arb_set_si(frame->axes[NORTH] + 1, -1);
}

void tp_hold_frame_init(tp_hold_frame *frame, const fmpz up[3]) {
  for (int k = 0; k < 9; k++) arb_init(frame->axes[k / 3] + k % 3);
  const arb_struct *u = frame->axes[UP];
  set_up(frame->axes[UP], up);
  if (fmpz_is_zero(up) && fmpz_is_zero(up + 1) && fmpz_sgn(up + 2) < 0) {
    turn_about_x(frame);
    return;
  }
  arb_t sum, own;
  arb_init(sum);
  arb_init(own);
  arb_add_ui(sum, u + 2, 1, BITS);
  for (int a = 0; a < 2; a++) {
    for (int b = 0; b < 2; b++) {
      arb_mul(own, u + a, u + b, BITS);
      arb_div(own, own, sum, BITS);
      arb_neg(frame->axes[a] + b, own);
    }
    arb_add_ui(frame->axes[a] + a, frame->axes[a] + a, 1, BITS);
    arb_neg(frame->axes[a] + 2, u + a);
  }
  arb_clear(sum);
  arb_clear(own);
}

void tp_hold_frame_clear(tp_hold_frame *frame) {
  for (int k = 0; k < 9; k++) arb_clear(frame->axes[k / 3] + k % 3);
}

/* ---- loads -------------------------------------------------------------------------------------
 */

/* Returns by how much the true number may differ: no more than 2^-101 for the rounding, and as much
 * for the ball. */
static double set_rounded(fmpq_t number, const arb_t ball) {
  arf_t middle;
  fmpz_t whole;
  arf_init(middle);
  fmpz_init(whole);
  arf_mul_2exp_si(middle, arb_midref(ball), PLACES);
  arf_get_fmpz(whole, middle, ARF_RND_NEAR);
  fmpq_set_fmpz(number, whole);
  const bool is_exact = arb_is_exact(ball) && arf_is_int(middle);
  fmpq_div_2exp(number, number, PLACES);
  arf_clear(middle);
  fmpz_clear(whole);
  if (is_exact) return 0;
  return mag_cmp_2exp_si(arb_radref(ball), -PLACES - 1) <= 0 ? ldexp(1, -PLACES) : INFINITY;
}

/* Of components along east, north and up. */
static void set_load(tp_hold_load *load, const tp_hold_frame *frame, const arb_struct parts[3]) {
  arb_t sum;
  arb_init(sum);
  for (int k = 0; k < 3; k++) {
    arb_zero(sum);
    for (int axis = 0; axis < 3; axis++) {
      arb_addmul(sum, frame->axes[axis] + k, parts + axis, BITS);
    }
    load->error[k] = set_rounded(load->exact + k, sum);
  }
  arb_clear(sum);
  tp_hold_load_settle(load);
}

static void init_parts(arb_struct *parts, int count) {
  for (int k = 0; k < count; k++) arb_init(parts + k);
}

static void clear_parts(arb_struct *parts, int count) {
  for (int k = 0; k < count; k++) arb_clear(parts + k);
}

void tp_hold_frame_axis(tp_hold_load *load, const tp_hold_frame *frame, int axis, bool down) {
  arb_struct parts[3];
  init_parts(parts, 3);
  arb_set_si(parts + axis, down ? -1 : 1);
  set_load(load, frame, parts);
  clear_parts(parts, 3);
}

static void set_sine_cosine(arb_t sine, arb_t cosine, const fmpq_t degrees) {
  fmpq_t half_turns;
  fmpq_init(half_turns);
  fmpq_div_fmpz(half_turns, degrees, (fmpz[]){180});
  arb_sin_cos_pi_fmpq(sine, cosine, half_turns, BITS);
  fmpq_clear(half_turns);
}

void tp_hold_frame_way(tp_hold_load *load, const tp_hold_frame *frame, const fmpq_t azimuth) {
  arb_struct parts[3];
  init_parts(parts, 3);
  set_sine_cosine(parts + EAST, parts + NORTH, azimuth);
  set_load(load, frame, parts);
  clear_parts(parts, 3);
}

/* Of a scene: sines and cosines. */
typedef struct turn {
  arb_struct sine, cosine;
} turn;

static void turn_init(turn *t, const tp_quantity *angle) {
  arb_init(&t->sine);
  arb_init(&t->cosine);
  arb_one(&t->cosine);
  if (angle->given) set_sine_cosine(&t->sine, &t->cosine, angle->value);
}

static void turn_clear(turn *t) {
  arb_clear(&t->sine);
  arb_clear(&t->cosine);
}

static void set_share(arb_t share, const tp_quantity *quantity, bool from_one) {
  if (quantity->given) arb_set_fmpq(share, quantity->value, BITS);
  if (from_one) arb_sub_ui(share, share, 1, BITS);
  if (from_one) arb_neg(share, share);
}

/* Along t, along the strike, and upwards, into east, north and up. */
static void set_base_parts(arb_struct parts[3], const arb_struct own[3], const turn *towards) {
  arb_mul(parts + EAST, own, &towards->sine, BITS);
  arb_addmul(parts + EAST, own + 1, &towards->cosine, BITS);
  arb_mul(parts + NORTH, own, &towards->cosine, BITS);
  arb_submul(parts + NORTH, own + 1, &towards->sine, BITS);
  arb_set(parts + UP, own + 2);
}

/* Of a horizontal share and one down, at the tilt of a scene; without the weight across the base,
 * where it `drives`, so that what is zero stays so. */
static void set_shaken(tp_hold_load *load, const tp_hold_frame *frame, const tp_scene *scene,
                       const arb_struct given[2], const turn *quake, bool drives) {
  arb_struct parts[3], own[3], shares[2]; /* k_h c, k_h w */
  arb_t across;
  turn tilt, towards;
  arb_init(across);
  init_parts(parts, 3);
  init_parts(own, 3);
  init_parts(shares, 2);
  turn_init(&tilt, &scene->tilt_angle_deg);
  turn_init(&towards, &scene->tilt_azimuth_deg);
  arb_mul(shares, &quake->cosine, &towards.cosine, BITS);
  arb_addmul(shares, &quake->sine, &towards.sine, BITS);
  arb_mul(shares + 1, &quake->sine, &towards.cosine, BITS);
  arb_submul(shares + 1, &quake->cosine, &towards.sine, BITS);
  for (int k = 0; k < 2; k++) arb_mul(shares + k, shares + k, given, BITS);
  arb_mul(own, given + 1, &tilt.sine, BITS);
  arb_addmul(own, shares, &tilt.cosine, BITS);
  arb_set(own + 1, shares + 1);
  arb_mul(own + 2, shares, &tilt.sine, BITS);
  arb_sub_ui(across, given + 1, drives ? 1 : 0, BITS);
  arb_submul(own + 2, across, &tilt.cosine, BITS);
  set_base_parts(parts, own, &towards);
  set_load(load, frame, parts);
  clear_parts(parts, 3);
  clear_parts(own, 3);
  clear_parts(shares, 2);
  arb_clear(across);
  turn_clear(&tilt);
  turn_clear(&towards);
}

/* With the horizontal share of the scene, and its weight. */
static void set_of_scene(tp_hold_load *load, const tp_hold_frame *frame, const tp_scene *scene,
                         bool shaken, bool drives) {
  arb_struct given[2];
  turn quake;
  init_parts(given, 2);
  turn_init(&quake, &scene->loads.azimuth_deg);
  if (shaken) set_share(given, &scene->loads.horizontal, false);
  set_share(given + 1, &scene->loads.vertical, true);
  set_shaken(load, frame, scene, given, &quake, drives);
  clear_parts(given, 2);
  turn_clear(&quake);
}

/* Without any of its earthquake. */
static void set_still(tp_hold_load *load, const tp_hold_frame *frame, const tp_scene *scene,
                      bool drives) {
  arb_struct given[2];
  turn quake;
  init_parts(given, 2);
  arb_one(given + 1);
  turn_init(&quake, &scene->loads.azimuth_deg);
  set_shaken(load, frame, scene, given, &quake, drives);
  clear_parts(given, 2);
  turn_clear(&quake);
}

void tp_hold_frame_scene(tp_hold_load *load, const tp_hold_frame *frame, const tp_scene *scene) {
  set_of_scene(load, frame, scene, true, false);
}

void tp_hold_frame_drive(tp_hold_load *load, const tp_hold_frame *frame, const tp_scene *scene,
                         bool shaken) {
  if (shaken) {
    set_of_scene(load, frame, scene, true, true);
  } else {
    set_still(load, frame, scene, true);
  }
}

void tp_hold_frame_rest(tp_hold_load *load, const tp_hold_frame *frame, const tp_scene *scene) {
  arb_struct parts[3];
  turn tilt;
  init_parts(parts, 3);
  turn_init(&tilt, &scene->tilt_angle_deg);
  arb_neg(parts + UP, &tilt.cosine);
  set_load(load, frame, parts);
  clear_parts(parts, 3);
  turn_clear(&tilt);
}

void tp_hold_frame_weight(tp_hold_load *load, const tp_hold_frame *frame, const tp_scene *scene) {
  set_of_scene(load, frame, scene, false, false);
}

void tp_hold_frame_shake(tp_hold_load *load, const tp_hold_frame *frame, const tp_scene *scene,
                         const fmpq_t azimuth) {
  arb_struct given[2];
  turn quake;
  init_parts(given, 2);
  arb_one(given);
  arb_init(&quake.sine);
  arb_init(&quake.cosine);
  set_sine_cosine(&quake.sine, &quake.cosine, azimuth);
  set_shaken(load, frame, scene, given, &quake, false);
  clear_parts(given, 2);
  turn_clear(&quake);
}
