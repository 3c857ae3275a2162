/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "stability/world_turn.h"

#include "block/section.h"
#include "number/ball.h"

#include <stdlib.h>
#include <string.h>

/* Binary digits to which the root k and the dip are cut (stability/world.h): a share of 2^-256 is
 * below 1e-77, and a scene of the world may be asked for TP_WORLD_DIGITS, 60. */
enum { CUT_BITS = 256 };

void tp_turn_init(tp_turn *turn) {
  fmpq *const all[] = {turn->dip_deg, turn->x, turn->y, turn->cosine, turn->sine};
  for (size_t k = 0; k < sizeof all / sizeof all[0]; k++) fmpq_init(all[k]);
  turn->rises = 0;
}

void tp_turn_clear(tp_turn *turn) {
  fmpq *const all[] = {turn->dip_deg, turn->x, turn->y, turn->cosine, turn->sine};
  for (size_t k = 0; k < sizeof all / sizeof all[0]; k++) fmpq_clear(all[k]);
}

void tp_turn_set(tp_turn *w, const fmpq_t u, const fmpq_t v) {
  fmpz_t p, q, square, root, rest;
  fmpz_init(p);
  fmpz_init(q);
  fmpz_init(square);
  fmpz_init(root);
  fmpz_init(rest);
  fmpq_div(w->cosine, v, u); /* q / p in lowest terms */
  fmpz_set(q, fmpq_numref(w->cosine));
  fmpz_set(p, fmpq_denref(w->cosine));
  fmpz_mul(square, p, p);
  fmpz_addmul(square, q, q);
  fmpz_sqrtrem(root, rest, square);
  unsigned long cut = 0;
  if (!fmpz_is_zero(rest)) {
    cut = CUT_BITS;
    fmpz_mul_2exp(square, square, 2 * cut);
    fmpz_sqrt(root, square);
  }
  fmpq_set_fmpz_frac(w->cosine, p, root);
  fmpq_set_fmpz_frac(w->sine, q, root);
  fmpq_mul_2exp(w->cosine, w->cosine, cut);
  fmpq_mul_2exp(w->sine, w->sine, cut);
  w->rises = fmpz_sgn(q);
  arb_t x, y;
  arf_t above;
  arb_init(x);
  arb_init(y);
  arf_init(above);
  fmpz_abs(q, q);
  arb_set_fmpz(x, p);
  arb_set_fmpz(y, q);
  tp_ball_atan2_degrees(y, y, x, 2 * CUT_BITS);
  arb_mul_2exp_si(y, y, CUT_BITS);
  arb_get_ubound_arf(above, y, 4 * CUT_BITS);
  arf_get_fmpz(fmpq_numref(w->dip_deg), above, ARF_RND_CEIL);
  fmpz_one(fmpq_denref(w->dip_deg));
  fmpq_div_2exp(w->dip_deg, w->dip_deg, CUT_BITS);
  arb_clear(x);
  arb_clear(y);
  arf_clear(above);
  fmpz_clear(p);
  fmpz_clear(q);
  fmpz_clear(square);
  fmpz_clear(root);
  fmpz_clear(rest);
}

/* The point about which it turns stays: x' = x0 + c (x - x0) + s (y - y0). */
static void turn_point(fmpq_t x, fmpq_t y, const void *context) {
  const tp_turn *w = context;
  fmpq_t dx, dy;
  fmpq_init(dx);
  fmpq_init(dy);
  fmpq_sub(dx, x, w->x);
  fmpq_sub(dy, y, w->y);
  fmpq_mul(x, w->cosine, dx);
  fmpq_addmul(x, w->sine, dy);
  fmpq_add(x, x, w->x);
  fmpq_mul(y, w->cosine, dy);
  fmpq_submul(y, w->sine, dx);
  fmpq_add(y, y, w->y);
  fmpq_clear(dx);
  fmpq_clear(dy);
}

/* The ends by their turned coordinates: vertices of the ring that the section has. */
static bool turn_ends(tp_scene *turned, const tp_turn *w, const tp_scene *scene, long first,
                      long last) {
  tp_section section;
  tp_message message;
  tp_polyline *between = &turned->base.between;
  if (tp_section_init(&section, &scene->block, &message) != TP_OK) return false;
  const tp_polyline *ring = section.rings;
  const long ends[2] = {first, last};
  bool done = true;
  between->file = ring->file;
  between->mark = ring->mark;
  for (int k = 0; k < 2 && done; k++) {
    done = tp_polyline_append(between, ring->x + ends[k], ring->y + ends[k], ring->marks[ends[k]]);
    if (done) turn_point(between->x + k, between->y + k, w);
  }
  tp_section_clear(&section);
  return done;
}

bool tp_turn_scene(tp_scene *turned, const tp_turn *w, const tp_scene *scene, bool keeps_ends,
                   long first, long last) {
  const tp_point_map map = {turn_point, w};
  fmpq_t turn_deg; /* directions are measured from x, which is now the mean plane */
  fmpq_init(turn_deg);
  fmpq_set(turn_deg, w->dip_deg);
  if (w->rises > 0) fmpq_neg(turn_deg, turn_deg);
  const bool done =
      tp_moved_rings(turned, scene, &scene->block.outline, scene->block.holes, &map) &&
      tp_moved_block(turned, scene, turn_deg, &map) && tp_moved_profile(turned, scene, &map) &&
      (!keeps_ends || turn_ends(turned, w, scene, first, last));
  fmpq_clear(turn_deg);
  return done;
}
