/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Sums of wrenches at the limit in balls, over the weight, about the centroid of the weight. With
 * W the weight, (F, M) a wrench about the origin of the cones and G the centroid, which the terms
 * of the weight's own wrench tell: at a tilt of 0 it is (0, -W) with the moment -x_G W, and its
 * sine part is (-W, 0) with y_G W,
 *
 *     M_G = M - (x_G F_y - y_G F_x).
 *
 * The sums are 0; what is left is the bound of the forces, so it holds 0. */

#include "static_limit/limit_balance.h"

#include "evaluation/loaded.h"

typedef struct weighing {
  const tp_evaluation *e;
  tp_direction towards;
  long bits;
  arb_t weight, x, y; /* of the force of gravity, in the units of the wrenches; its centroid */
} weighing;

/* Where loads act the wrench of the weight is about the scene's origin, and that of the question
 * about the lattice's. */
static void begin(weighing *w, const tp_evaluation *e, const tp_limit_question *q,
                  const tp_limit_answer *answer, tp_direction towards) {
  const tp_wrench *own = e->loaded != NULL ? &e->loaded->items[0].wrench : q->load;
  *w = (weighing){.e = e, .towards = towards, .bits = q->judge.bits};
  arb_init(w->weight);
  arb_init(w->x);
  arb_init(w->y);
  arb_div(w->x, own->moment.of + TP_COS, own->y.of + TP_COS, w->bits);
  arb_div(w->y, own->moment.of + TP_SIN, own->x.of + TP_SIN, w->bits);
  arb_neg(w->y, w->y);
  if (e->loaded != NULL) {
    arb_t x, y;
    arb_init(x);
    arb_init(y);
    tp_loaded_metres(x, y, e);
    if (e->loaded->mirrored) arb_neg(x, x);
    arb_sub(w->x, w->x, x, w->bits);
    arb_sub(w->y, w->y, y, w->bits);
    arb_clear(x);
    arb_clear(y);
  }
  arb_hypot(w->weight, answer->sine, answer->cosine, w->bits);
  arb_mul(w->weight, w->weight, own->y.of + TP_COS, w->bits);
  arb_neg(w->weight, w->weight);
}

static void end(weighing *w) {
  arb_clear(w->weight);
  arb_clear(w->x);
  arb_clear(w->y);
}

/* In the scene's frame, over the weight. */
static void tell(tp_wrench_share *share, const weighing *w, const tp_vector *wrench) {
  arb_t moment, height;
  arb_init(moment);
  arb_init(height);
  tp_vector own;
  tp_vector_init(&own);
  arb_mul(moment, w->x, wrench->of + 1, w->bits);
  arb_submul(moment, w->y, wrench->of, w->bits);
  arb_sub(moment, wrench->of + 2, moment, w->bits);
  if (w->e->loaded == NULL) tp_loaded_local_metres(moment, height, w->e);
  arb_set(own.of, wrench->of);
  arb_set(own.of + 1, wrench->of + 1);
  arb_set(own.of + 2, moment);
  for (int k = 0; k < 3; k++) arb_div(own.of + k, own.of + k, w->weight, w->bits);
  tp_ball_mirror(own.of, w->towards);
  tp_ball_mirror(own.of + 2, w->towards);
  share->share_x = tp_result_of(w->e, own.of);
  share->share_y = tp_result_of(w->e, own.of + 1);
  share->moment_m = tp_result_of(w->e, own.of + 2);
  tp_vector_clear(&own);
  arb_clear(moment);
  arb_clear(height);
}

static void add_reactions(tp_vector *sum, const tp_limit_question *q,
                          const tp_limit_answer *answer) {
  tp_vector column;
  tp_vector_init(&column);
  for (int k = 0; k < 2; k++) {
    if (arb_is_zero(answer->forces + k)) continue;
    tp_cones_column(column.of, q->cones, answer->face.columns[k], q->judge.bits);
    for (int row = 0; row < 3; row++) {
      arb_addmul(sum->of + row, column.of + row, answer->forces + k, q->judge.bits);
    }
  }
  tp_vector_clear(&column);
}

void tp_limit_balance_find(tp_limit_balance *balance, const tp_evaluation *e,
                           const tp_limit_question *q, const tp_limit_answer *answer,
                           tp_direction towards) {
  weighing w;
  tp_vector applied, strength;
  begin(&w, e, q, answer, towards);
  tp_vector_init(&applied);
  tp_vector_init(&strength);
  tp_question_load_at(&applied, q->load, answer->sine, answer->cosine, w.bits);
  if (q->cones->capacity_count > 0) {
    tp_face_add_capacities(&strength, &answer->face, q->cones, &q->judge);
  }
  tell(&balance->applied, &w, &applied);
  tell(&balance->strength, &w, &strength);
  for (int row = 0; row < 3; row++) {
    arb_add(applied.of + row, applied.of + row, strength.of + row, w.bits);
  }
  add_reactions(&applied, q, answer);
  tell(&balance->sum, &w, &applied);
  balance->known = true;
  tp_vector_clear(&applied);
  tp_vector_clear(&strength);
  end(&w);
}
