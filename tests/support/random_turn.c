/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "random_turn.h"

/* A profile must go from left to right, and the turned base, upright below its ends, must stay
 * clear of the block as the first one does: no vertex of the block may lie below the lower end. */
static bool still_a_base(const random_scene *s, const long leg[2]) {
  const polygon *p = &s->profile, *o = &s->outline;
  for (long k = 0; k + 1 < p->count; k++) {
    const long dx = p->x[k + 1] - p->x[k], dy = p->y[k + 1] - p->y[k];
    if (leg[0] * dx - leg[1] * dy <= 0) return false;
  }
  for (int end = 0; end < 2; end++) {
    const long at = end == 0 ? 0 : p->count - 1;
    for (long k = 0; k < o->count; k++) {
      const long dx = o->x[k] - p->x[at], dy = o->y[k] - p->y[at];
      const long out = (end == 0 ? -1 : 1) * (leg[0] * dx - leg[1] * dy);
      if (out > 0 && leg[1] * dx + leg[0] * dy < 0) return false;
    }
  }
  return true;
}

bool random_turn(random_scene *s, relation *r, random_numbers *state) {
  static const long triples[][3] = {
      {4, 3, 5}, {12, 5, 13}, {24, 7, 25}, {15, -8, 17}, {40, -9, 41}};
  const long *t = triples[draw_below(state, 5)];
  if (!random_effects_turn(&s->effects)) return false;
  if (s->profile.count == 0 || !fmpq_is_zero(s->numbers + YX) || !still_a_base(s, t)) return false;
  fmpq old[MAP_NUMBERS];
  for (int k = 0; k < MAP_NUMBERS; k++) {
    fmpq_init(old + k);
    fmpq_set(old + k, s->numbers + k);
  }
  const long rows[2][2] = {{t[0], -t[1]}, {t[1], t[0]}};
  fmpq_t cosine_part, sine_part;
  fmpq_init(cosine_part);
  fmpq_init(sine_part);
  static const int from[3][2] = {{XX, YX}, {XY, YY}, {MOVE_X, MOVE_Y}};
  for (int row = 0; row < 2; row++) {
    for (int k = 0; k < 3; k++) {
      fmpq *result = s->numbers + from[k][row];
      fmpq_mul_si(cosine_part, old + from[k][0], rows[row][0]);
      fmpq_mul_si(sine_part, old + from[k][1], rows[row][1]);
      fmpq_add(result, cosine_part, sine_part);
      fmpz_mul_si(fmpq_denref(result), fmpq_denref(result), t[2]);
      fmpq_canonicalise(result);
    }
    fmpq_set_si(r->numbers + MAP_XX + 2 * row, rows[row][0], (ulong)t[2]);
    fmpq_set_si(r->numbers + MAP_XY + 2 * row, rows[row][1], (ulong)t[2]);
  }
  for (int k = 0; k < MAP_NUMBERS; k++) fmpq_clear(old + k);
  fmpq_clear(cosine_part);
  fmpq_clear(sine_part);
  arb_t pi, ratio;
  arb_init(pi);
  arb_init(ratio);
  arb_set_si(ratio, t[1]);
  arb_div_si(ratio, ratio, t[0], 256);
  arb_atan(r->turn_deg, ratio, 256);
  arb_const_pi(pi, 256);
  arb_div(r->turn_deg, r->turn_deg, pi, 256);
  arb_mul_ui(r->turn_deg, r->turn_deg, 180, 256);
  r->turned = true;
  arb_clear(pi);
  arb_clear(ratio);
  return true;
}
