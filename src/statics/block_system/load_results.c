/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Wrenches at the tilt of a case, moved from the own points of blocks to their centroids. */

#include "block_system/load_results.h"

#include <stdlib.h>

enum { BITS = 256 };

typedef struct turned {
  arb_t sine, cosine; /* of the tilt, to the left above zero */
  arb_t metre;        /* of a unit of length of the assemblage */
} turned;

static void set_arm(arb_t arm, tp_near near, const arb_t metre) {
  tp_ball_set_bounded(arm, near.value, near.error);
  arb_mul(arm, arm, metre, BITS);
}

static void set_load(tp_system_load *own, const tp_block_load *load, const tp_rigid_block *block,
                     const turned *t) {
  arb_t x, y, moment, arm;
  arb_init(x);
  arb_init(y);
  arb_init(moment);
  arb_init(arm);
  tp_trig_evaluate(x, &load->wrench.x, t->sine, t->cosine, BITS);
  tp_trig_evaluate(y, &load->wrench.y, t->sine, t->cosine, BITS);
  tp_trig_evaluate(moment, &load->wrench.moment, t->sine, t->cosine, BITS);
  set_arm(arm, block->arm_x, t->metre);
  arb_submul(moment, arm, y, BITS);
  set_arm(arm, block->arm_y, t->metre);
  arb_addmul(moment, arm, x, BITS);
  own->kind = load->kind;
  own->block = (size_t)load->block;
  own->force_x_n_m = tp_ball_bounded(x);
  own->force_y_n_m = tp_ball_bounded(y);
  own->moment_n = tp_ball_bounded(moment);
  arb_clear(x);
  arb_clear(y);
  arb_clear(moment);
  arb_clear(arm);
}

tp_status tp_load_results_set(tp_system_case *own, const tp_built_system *s, const tp_resultant *r,
                              tp_message *message) {
  const tp_block_loads *loads = s->loads + (r->left ? 1 : 0);
  const tp_assemblage *a = &s->assemblage;
  if (loads->count == 0) return TP_OK;
  own->loads = calloc((size_t)loads->count, sizeof *own->loads);
  if (own->loads == NULL) return tp_fail_memory(message, "the loads");
  for (size_t k = 0; k < own->force_count; k++) own->forces[k].water_n_m = loads->water[k];
  own->load_count = (size_t)loads->count;
  turned t;
  arb_init(t.sine);
  arb_init(t.cosine);
  arb_init(t.metre);
  tp_ball_sin_cos(t.sine, t.cosine, r->tilt_deg, BITS);
  if (!r->left) arb_neg(t.sine, t.sine);
  arb_set_fmpq(t.metre, a->lattice.step_m, BITS);
  arb_mul_2exp_si(t.metre, t.metre, a->length_exponent);
  for (long k = 0; k < loads->count; k++) {
    const tp_block_load *load = loads->items + k;
    set_load(own->loads + k, load, a->blocks + load->block, &t);
  }
  arb_clear(t.sine);
  arb_clear(t.cosine);
  arb_clear(t.metre);
  return TP_OK;
}
