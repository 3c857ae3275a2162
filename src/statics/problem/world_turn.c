/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Rotation of a scene's points by an exact direction or by an angle, about one point that stays;
 * directions of anchors and the ends of the contact turn with it. */

#include "problem/world_turn.h"

#include "block/section.h"
#include "number/ball.h"
#include "plane/direction.h"

#include <stdlib.h>
#include <string.h>

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
  tp_direction_unit(w->cosine, w->sine, u, v);
  w->rises = fmpq_sgn(v);
  arb_t x, y;
  arf_t above;
  arb_init(x);
  arb_init(y);
  arf_init(above);
  fmpq_div(w->dip_deg, v, u); /* whole numbers: an angle of 45 degrees is told exactly */
  fmpq_abs(w->dip_deg, w->dip_deg);
  arb_set_fmpz(y, fmpq_numref(w->dip_deg));
  arb_set_fmpz(x, fmpq_denref(w->dip_deg));
  tp_ball_atan2_degrees(y, y, x, 2 * TP_DIRECTION_BITS);
  arb_mul_2exp_si(y, y, TP_DIRECTION_BITS);
  arb_get_ubound_arf(above, y, 4 * TP_DIRECTION_BITS);
  arf_get_fmpz(fmpq_numref(w->dip_deg), above, ARF_RND_CEIL);
  fmpz_one(fmpq_denref(w->dip_deg));
  fmpq_div_2exp(w->dip_deg, w->dip_deg, TP_DIRECTION_BITS);
  arb_clear(x);
  arb_clear(y);
  arf_clear(above);
}

/* Rounded to as many digits as a direction that is cut off. */
static void set_rounded(fmpq_t value, const arb_t ball) {
  arf_get_fmpq(value, arb_midref(ball));
}

void tp_turn_by(tp_turn *turn, const fmpq_t degrees, const tp_turn *of) {
  arb_t sine, cosine;
  arb_init(sine);
  arb_init(cosine);
  fmpq_set(turn->x, of->x);
  fmpq_set(turn->y, of->y);
  fmpq_set(turn->dip_deg, degrees);
  turn->rises = -of->rises;
  tp_ball_sin_cos_degrees(sine, cosine, degrees, TP_DIRECTION_BITS);
  set_rounded(turn->cosine, cosine);
  set_rounded(turn->sine, sine);
  if (turn->rises < 0) fmpq_neg(turn->sine, turn->sine);
  arb_clear(sine);
  arb_clear(cosine);
}

void tp_turn_direction(fmpq_t cosine, fmpq_t sine, const tp_turn *of, const tp_turn *turn) {
  fmpq_mul(cosine, turn->cosine, of->cosine);
  fmpq_addmul(cosine, turn->sine, of->sine);
  fmpq_mul(sine, turn->cosine, of->sine);
  fmpq_submul(sine, turn->sine, of->cosine);
}

void tp_turn_point(fmpq_t x, fmpq_t y, const tp_turn *w) {
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

void tp_turn_back_point(fmpq_t x, fmpq_t y, const tp_turn *w) {
  fmpq_t dx, dy, square;
  fmpq_init(dx);
  fmpq_init(dy);
  fmpq_init(square);
  fmpq_mul(square, w->cosine, w->cosine);
  fmpq_addmul(square, w->sine, w->sine);
  fmpq_sub(dx, x, w->x);
  fmpq_sub(dy, y, w->y);
  fmpq_mul(x, w->cosine, dx);
  fmpq_submul(x, w->sine, dy);
  fmpq_div(x, x, square);
  fmpq_add(x, x, w->x);
  fmpq_mul(y, w->cosine, dy);
  fmpq_addmul(y, w->sine, dx);
  fmpq_div(y, y, square);
  fmpq_add(y, y, w->y);
  fmpq_clear(dx);
  fmpq_clear(dy);
  fmpq_clear(square);
}

static void turn_point(fmpq_t x, fmpq_t y, const void *context) {
  tp_turn_point(x, y, context);
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
