/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Along the gradient of a margin that is linear. */

#include "solid_tilt/wedge_support.h"

#include "number/ball.h"

enum { BITS = TP_WEDGE_LAW_BITS, NEWTONS = 1000, FULL_TURN = 360 };

enum { K, REST, F, MARGIN, SIZE, OWN, SECOND, NUMBERS };

typedef struct work {
  const tp_wedge_law *law;
  const tp_wedge_shape *shape;
  arb_struct stars[2][3]; /* a*, b*: N = -R . a* */
  arb_struct way[3];      /* g */
  arb_struct n[NUMBERS];
} work;

static void each(work *w, void (*what)(arb_t number)) {
  for (int i = 0; i < 3; i++) {
    what(w->stars[0] + i);
    what(w->stars[1] + i);
    what(w->way + i);
  }
  for (int i = 0; i < NUMBERS; i++) what(w->n + i);
}

static void set_stars(work *w) {
  const arb_struct *const normals[] = {w->shape->normals[TP_WEDGE_A],
                                       w->shape->normals[TP_WEDGE_B]};
  tp_wedge_dot(w->n + K, normals[0], normals[1]);
  arb_one(w->n + REST);
  arb_submul(w->n + REST, w->n + K, w->n + K, BITS);
  for (int joint = 0; joint < 2; joint++) {
    for (int i = 0; i < 3; i++) {
      arb_struct *own = w->stars[joint] + i;
      arb_set(own, normals[joint] + i);
      arb_submul(own, w->n + K, normals[1 - joint] + i, BITS);
      arb_div(own, own, w->n + REST, BITS);
    }
  }
}

static void set_way(work *w) {
  for (int i = 0; i < 3; i++) {
    arb_mul(w->way + i, w->shape->line + i, w->n + F, BITS);
    for (int joint = 0; joint < 2; joint++) {
      arb_submul(w->way + i, w->law->friction + joint, w->stars[joint] + i, BITS);
    }
  }
  tp_wedge_dot(w->n + SIZE, w->way, w->way);
}

/* With T = -m / |g|^2 g, N of a joint is above zero. */
static bool presses(work *w, int joint, const arb_struct values[TP_WEDGE_LINES]) {
  tp_wedge_dot(w->n + OWN, w->way, w->stars[joint]);
  arb_mul(w->n + OWN, w->n + OWN, w->n + MARGIN, BITS);
  arb_div(w->n + OWN, w->n + OWN, w->n + SIZE, BITS);
  arb_add(w->n + OWN, w->n + OWN, values + TP_WEDGE_NORMAL_A + joint, BITS);
  return arb_is_positive(w->n + OWN);
}

/* In newtons, towards an azimuth, and how steeply. */
static void tell(tp_solid_wedge *wedge, work *w) {
  arb_sqrt(w->n + SIZE, w->n + SIZE, BITS);
  arb_div(w->n + OWN, w->n + MARGIN, w->n + SIZE, BITS);
  arb_mul_si(w->n + OWN, w->n + OWN, -NEWTONS, BITS);
  wedge->has_support = true;
  wedge->support_n = tp_ball_bounded(w->n + OWN);
  tp_ball_atan2_degrees(w->n + OWN, w->way, w->way + 1, BITS);
  if (arb_is_negative(w->n + OWN)) arb_add_ui(w->n + OWN, w->n + OWN, FULL_TURN, BITS);
  wedge->support_azimuth_deg = tp_ball_bounded(w->n + OWN);
  arb_hypot(w->n + SECOND, w->way, w->way + 1, BITS);
  arb_neg(w->n + OWN, w->way + 2);
  tp_ball_atan2_degrees(w->n + OWN, w->n + OWN, w->n + SECOND, BITS);
  wedge->support_dip_deg = tp_ball_bounded(w->n + OWN);
}

void tp_wedge_support_find(tp_solid_wedge *wedge, const tp_wedge_law *law,
                           const tp_wedge_shape *shape, const arb_struct values[TP_WEDGE_LINES],
                           const fmpq_t factor) {
  work w = {.law = law, .shape = shape};
  if (tp_wedge_way_of(values) != TP_WEDGE_ON_BOTH) return;
  if (!arb_is_negative(values + TP_WEDGE_ALONG)) return;
  each(&w, arb_init);
  arb_set_fmpq(w.n + F, factor, BITS);
  tp_wedge_strength(w.n + MARGIN, law, TP_WEDGE_ON_BOTH, values, false);
  arb_addmul(w.n + MARGIN, w.n + F, values + TP_WEDGE_ALONG, BITS);
  if (arb_is_negative(w.n + MARGIN)) {
    set_stars(&w);
    set_way(&w);
    if (presses(&w, 0, values) && presses(&w, 1, values)) tell(wedge, &w);
  }
  each(&w, arb_clear);
}
