/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Sines and cosines by balls, rounded to whole numbers; all else in these. */

#include "solid/dipping.h"

#include "solid/centre.h"

#include <arb.h>

enum { NORMAL_BITS = 100, ROOT_BITS = 200 };

/* ---- the normal in the upright frame -----------------------------------------------------------
 */

static void set_sine_cosine(arb_t sine, arb_t cosine, const fmpq_t degrees) {
  fmpq_t half_turns;
  fmpq_init(half_turns);
  fmpq_div_fmpz(half_turns, degrees, (fmpz[]){180});
  arb_sin_cos_pi_fmpq(sine, cosine, half_turns, 2 * NORMAL_BITS);
  fmpq_clear(half_turns);
}

/* The nearest whole number to 2^NORMAL_BITS times a ball. */
static void set_rounded(fmpz_t whole, const arb_t number) {
  arf_t middle;
  arf_init(middle);
  arf_mul_2exp_si(middle, arb_midref(number), NORMAL_BITS);
  arf_get_fmpz(whole, middle, ARF_RND_NEAR);
  arf_clear(middle);
}

static void set_upright_normal(fmpz own[3], const fmpq_t dip, const fmpq_t direction) {
  arb_t sine, cosine, east, north;
  arb_init(sine);
  arb_init(cosine);
  arb_init(east);
  arb_init(north);
  set_sine_cosine(sine, cosine, dip);
  set_sine_cosine(east, north, direction);
  arb_mul(east, east, sine, 2 * NORMAL_BITS);
  arb_mul(north, north, sine, 2 * NORMAL_BITS);
  set_rounded(own, east);
  set_rounded(own + 1, north);
  set_rounded(own + 2, cosine);
  arb_clear(sine);
  arb_clear(cosine);
  arb_clear(east);
  arb_clear(north);
}

/* ---- back into the axes of the mesh ------------------------------------------------------------
 */

static ulong most_bits(const fmpz v[3]) {
  ulong bits = 0;
  for (int k = 0; k < 3; k++) {
    const ulong own = fmpz_bits(v + k);
    if (own > bits) bits = own;
  }
  return bits;
}

/* `up` times 2^shift, and so its length: exact without a shift. L + z is (x x + y y) / (L - z) at
 * least, half of 1 / |z|: so many bits more than ROOT_BITS keep it, too. */
static ulong set_length(fmpz_t length, fmpz scaled[3], const fmpz up[3]) {
  fmpz_t square;
  fmpz_init(square);
  for (int k = 0; k < 3; k++) fmpz_addmul(square, up + k, up + k);
  const ulong shift = fmpz_is_square(square) ? 0 : ROOT_BITS + most_bits(up) + 2;
  fmpz_mul_2exp(square, square, 2 * shift);
  fmpz_sqrt(length, square);
  for (int k = 0; k < 3; k++) fmpz_mul_2exp(scaled + k, up + k, shift);
  fmpz_clear(square);
  return shift;
}

/* Leaves ROOT_BITS of the greatest. */
static void shorten(fmpz v[3]) {
  const ulong bits = most_bits(v);
  for (int k = 0; k < 3 && bits > ROOT_BITS; k++) {
    fmpz_tdiv_q_2exp(v + k, v + k, bits - ROOT_BITS);
  }
}

static void turn_back(fmpz normal[3], const fmpz up[3], const fmpz own[3]) {
  fmpz_t length, rise, across, along;
  fmpz scaled[3];
  fmpz_init(length);
  fmpz_init(rise);
  fmpz_init(across);
  fmpz_init(along);
  for (int k = 0; k < 3; k++) fmpz_init(scaled + k);
  const ulong shift = set_length(length, scaled, up);
  fmpz_add(rise, length, scaled + 2);
  for (int k = 0; k < 2; k++) fmpz_addmul(across, own + k, scaled + k);
  fmpz_mul(along, own + 2, rise);
  fmpz_sub(along, along, across);
  fmpz_mul(length, length, rise);
  for (int k = 0; k < 2; k++) {
    fmpz_mul(normal + k, own + k, length);
    fmpz_addmul(normal + k, scaled + k, along);
  }
  fmpz_mul(normal + 2, own + 2, scaled + 2);
  fmpz_sub(normal + 2, normal + 2, across);
  fmpz_mul(normal + 2, normal + 2, rise);
  if (shift > 0) shorten(normal);
  fmpz_clear(length);
  fmpz_clear(rise);
  fmpz_clear(across);
  fmpz_clear(along);
  for (int k = 0; k < 3; k++) fmpz_clear(scaled + k);
}

static void set_normal(fmpz normal[3], const fmpz up[3], const fmpz own[3]) {
  if (fmpz_is_zero(own) && fmpz_is_zero(own + 1)) { /* level */
    for (int k = 0; k < 3; k++) fmpz_set(normal + k, up + k);
  } else if (fmpz_is_zero(up) && fmpz_is_zero(up + 1)) {
    for (int k = 0; k < 3; k++) fmpz_set(normal + k, own + k);
    for (int k = 1; k < 3 && fmpz_sgn(up + 2) < 0; k++) fmpz_neg(normal + k, normal + k);
  } else {
    turn_back(normal, up, own);
  }
}

void tp_dipping_base_set(fmpz normal[3], tp_map_frame *frame, const fmpz up[3],
                         const fmpq_t dip_deg, const fmpq_t direction_deg) {
  fmpz own[3];
  tp_rest_plane level, base;
  for (int k = 0; k < 3; k++) fmpz_init(own + k);
  set_upright_normal(own, dip_deg, direction_deg);
  set_normal(normal, up, own);
  tp_rest_plane_across(&level, up, 0);
  tp_rest_plane_across(&base, own, 0);
  tp_map_frame_down(frame, level.near_up, base.near_up);
  tp_rest_plane_clear(&level);
  tp_rest_plane_clear(&base);
  for (int k = 0; k < 3; k++) fmpz_clear(own + k);
}
