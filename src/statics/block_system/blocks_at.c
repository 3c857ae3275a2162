/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Loads are those of the program of forces, w0 + s w1; by the tangent of the angle of the
 * resultant. */

#include "block_system/blocks_at.h"

#include <stdlib.h>

enum { BITS = 128 };

bool tp_blocks_at_init(tp_blocks_at *at, const tp_resting *r) {
  at->friction = calloc((size_t)r->contact_count + 1, sizeof *at->friction);
  at->cohesion = calloc((size_t)r->contact_count + 1, sizeof *at->cohesion);
  at->tension = calloc((size_t)r->assemblage->contact_count + 1, sizeof *at->tension);
  at->bond = calloc(2 * (size_t)r->contact_count + 1, sizeof *at->bond);
  at->piece = calloc(2 * (size_t)r->contact_count + 1, sizeof *at->piece);
  at->loads = calloc((size_t)r->rows + 1, sizeof *at->loads);
  at->central = calloc((size_t)r->rows + 1, sizeof *at->central);
  return at->friction != NULL && at->cohesion != NULL && at->tension != NULL && at->bond != NULL &&
         at->piece != NULL && at->loads != NULL && at->central != NULL;
}

void tp_blocks_at_clear(tp_blocks_at *at) {
  free(at->friction);
  free(at->cohesion);
  free(at->tension);
  free(at->bond);
  free(at->piece);
  free(at->loads);
  free(at->central);
  *at = (tp_blocks_at){.friction = NULL};
}

/* Of a piece of a contact. */
static void add_bond(tp_blocks_at *at, const tp_resting *r, long contact, tp_near tension) {
  const tp_resting_piece *piece = r->pieces + contact;
  const long *ends = r->assemblage->contacts[contact].ends,
             *of = r->contacts[piece->contact].of.ends;
  const tp_near force = tp_near_times(tension, piece->length);
  at->has_bond = true;
  for (int e = 0; e < 2; e++) {
    tp_near *bond = at->bond + 2 * piece->contact + e;
    *bond = tp_near_plus(*bond, tp_near_times(piece->share[e], force));
    if (ends[e] == of[e]) at->piece[2 * piece->contact + e] = force;
  }
}

void tp_blocks_at_divisor(tp_blocks_at *at, const tp_resting *r, const tp_built_system *s,
                          double divisor) {
  for (long k = 0; k < r->contact_count; k++) at->cohesion[k] = (tp_near){0, 0};
  for (long k = 0; k < 2 * r->contact_count; k++) at->bond[k] = at->piece[k] = (tp_near){0, 0};
  at->has_bond = false;
  for (long k = 0; k < r->assemblage->contact_count; k++) {
    const tp_contact_strength own = tp_built_system_strength(s, k, divisor);
    const tp_resting_piece *piece = r->pieces + k;
    const tp_near cohesion = tp_near_times(own.cohesion, piece->length);
    at->friction[piece->contact] = own.tangent;
    at->cohesion[piece->contact] = tp_near_plus(at->cohesion[piece->contact], cohesion);
    at->tension[k] = r->contacts[piece->contact].ends == 1 ? (tp_near){0, 0} : own.tension;
    if (!tp_near_is_zero(at->tension[k])) add_bond(at, r, k, at->tension[k]);
  }
  for (long k = r->pair_first; k < r->contact_count; k++) {
    at->friction[k] = tp_built_system_over(s->pair_tangents[k - r->pair_first], divisor);
  }
}

tp_status tp_blocks_at_rest(tp_blocks_at *at, const tp_resting *resting, const tp_resultant *r,
                            tp_message *message) {
  return tp_resting_loads(at->loads, at->central, &at->weights_alone, resting, &r->loads, r->target,
                          at->tension, message);
}

/* Weights alone: by the tangent of the angle of their resultant. */
static tp_status turn_weights(bool *within, tp_blocks_at *at, const tp_resting *resting,
                              const tp_resultant *r, double tilt_deg, tp_message *message) {
  arb_t angle, sine, cosine;
  arb_init(angle);
  arb_init(sine);
  arb_init(cosine);
  arb_set_d(angle, tilt_deg);
  arb_add(angle, angle, r->earthquake_deg, BITS);
  tp_ball_sin_cos(sine, cosine, angle, BITS);
  *within = arb_is_positive(cosine);
  tp_near tangent = {0, 0};
  if (*within) {
    arb_div(sine, sine, cosine, BITS);
    tangent = tp_ball_near_exact(sine);
  }
  arb_clear(angle);
  arb_clear(sine);
  arb_clear(cosine);
  if (!*within) return TP_OK;
  return tp_resting_loads(at->loads, at->central, &at->weights_alone, resting, &r->loads, tangent,
                          at->tension, message);
}

tp_status tp_blocks_at_tilt(bool *within, tp_blocks_at *at, const tp_resting *resting,
                            const tp_resultant *r, bool is_measured, double tilt_deg,
                            tp_message *message) {
  static const double radian = 57.29577951308232; /* degrees */
  if (!is_measured) return turn_weights(within, at, resting, r, tilt_deg, message);
  const tp_weight_loads loads = tp_resultant_at(r, tilt_deg / radian);
  *within = true;
  return tp_resting_loads(at->loads, at->central, &at->weights_alone, resting, &loads, r->target,
                          at->tension, message);
}
