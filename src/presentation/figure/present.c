/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What acts on a block as it lies. The contact forces of a block that stands are many, but their
 * sum is known: equal and opposite to that of weight and loads, on the same line (docs/mechanics.md
 * section 5). It is drawn where that line passes the chord of the contact. The size is a ball of
 * 128 bits; where it is drawn is for the eye. */

#include "evaluation/loaded.h"
#include "figure/figure.h"

#include <math.h>

/* Force in shares of the weight, and the point of its line that is nearest to the centroid, in the
 * frame of the loads, in metres from the lattice's origin. */
typedef struct present {
  tp_spot share, on;
  tp_bounded size;
} present;

static double middle(const arb_t ball) {
  return arf_get_d(arb_midref(ball), ARF_RND_NEAR);
}

static void measure(present *found, const tp_evaluation *e, const tp_loaded *loaded,
                    tp_spot centroid) {
  const long bits = e->rung.bits;
  tp_wrench sum;
  arb_t x, y, moment, weight, size;
  tp_wrench_init(&sum);
  arb_init(x);
  arb_init(y);
  arb_init(moment);
  arb_init(weight);
  arb_init(size);
  tp_loaded_local_sum(&sum, loaded, e);
  tp_evaluation_weight(weight, e);
  tp_trig_evaluate(x, &sum.x, e->tilt_sine, e->tilt_cosine, bits);
  tp_trig_evaluate(y, &sum.y, e->tilt_sine, e->tilt_cosine, bits);
  tp_trig_evaluate(moment, &sum.moment, e->tilt_sine, e->tilt_cosine, bits);
  arb_div(x, x, weight, bits);
  arb_div(y, y, weight, bits);
  arb_div(moment, moment, weight, bits);
  arb_hypot(size, x, y, bits);
  found->size = tp_result_of(e, size);
  found->share = (tp_spot){middle(x), middle(y)};
  const double square = found->size.value * found->size.value;
  const double about = middle(moment) - centroid.x * found->share.y + centroid.y * found->share.x;
  const double along = square > 0 ? about / square : 0;
  found->on = (tp_spot){centroid.x + along * found->share.y, centroid.y - along * found->share.x};
  arb_clear(x);
  arb_clear(y);
  arb_clear(moment);
  arb_clear(weight);
  arb_clear(size);
  tp_wrench_clear(&sum);
}

/* Of all loads, in the frame of the figure. */
static bool find_resultant(tp_state *state, const tp_figure *figure) {
  enum { BITS = 128 };
  const tp_solve_options options = {.size = sizeof options, .digits = 9};
  const double unit = figure->shape.unit_m;
  const double side = state->own->towards == TP_TOWARDS_RIGHT ? -1 : 1;
  tp_evaluation e;
  tp_loaded loaded;
  present found = {.size = {.value = 0}};
  tp_evaluation_init(&e, figure->problem, (tp_rung){TP_LEVEL_BALL, BITS}, &options);
  const bool done = tp_loaded_init(&loaded, &e, state->own->towards);
  if (done) {
    measure(&found, &e, &loaded,
            (tp_spot){side * unit * state->centroid.x, unit * state->centroid.y});
    tp_loaded_clear(&loaded);
  }
  tp_evaluation_clear(&e);
  state->has_resultant = done && found.size.value > 0;
  state->resultant = (tp_force){.at = {side * found.on.x / unit, found.on.y / unit},
                                .share = {side * found.share.x, found.share.y},
                                .size = found.size};
  return done;
}

/* Where the line of the force passes the chord of the contact, and whether between its ends and
 * into the base. */
static bool find_crossing(tp_spot *at, const tp_figure *figure, const tp_force *force) {
  const tp_problem *problem = figure->problem;
  const tp_contact *contact = &problem->contact;
  const tp_spot left =
      tp_shape_of_point(&figure->shape, &problem->lattice, tp_contact_extreme(contact, true).point);
  const tp_spot right = tp_shape_of_point(&figure->shape, &problem->lattice,
                                          tp_contact_extreme(contact, false).point);
  const tp_spot chord = {right.x - left.x, right.y - left.y};
  if (!tp_spot_meet(at, force->at, force->share, left, chord)) return false;
  const double square = chord.x * chord.x + chord.y * chord.y;
  const double part = ((at->x - left.x) * chord.x + (at->y - left.y) * chord.y) / square;
  return part >= 0 && part <= 1 && chord.x * force->share.y - chord.y * force->share.x < 0;
}

/* The centre about which it begins to turn. */
static void find_centre(tp_state *state, const tp_figure *figure) {
  const tp_onset *onset = &state->own->onset;
  if (!onset->has_motions || onset->motion_count == 0 || !onset->motions->has_centre) return;
  state->has_centre = true;
  state->centre =
      tp_shape_of_metres(&figure->shape, onset->motions->centre_x_m, onset->motions->centre_y_m);
  state->shows_centre = tp_figure_in_sight(figure, state->centre);
}

bool tp_state_find_present(tp_state *state, const tp_figure *figure) {
  const tp_mechanism mechanism = state->own->mechanism;
  const bool stands = mechanism == TP_STANDS || mechanism == TP_INTERLOCKED;
  tp_force acts = {.at = state->centroid, .share = state->gravity, .size = {.value = 1}};
  if (figure->solution->loaded) {
    if (!find_resultant(state, figure)) return false;
    acts = state->resultant;
  }
  find_centre(state, figure);
  if (figure->problem->contact.point_count == 0) return true;
  tp_spot at = state->centroid;
  const bool within = find_crossing(&at, figure, &acts);
  if (within && stands) {
    state->reaction_count = 1;
    state->reactions[0] = (tp_force){at, {-acts.share.x, -acts.share.y}, acts.size};
  } else if (tp_figure_in_sight(figure, at)) {
    state->meets = true;
    state->meeting = at;
  }
  return true;
}
