/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* By how much a block is shifted along its mated base so that no more than a share of its underside
 * is closed: the joint matching coefficient of Zhao (1997), the share of a joint's surface that is
 * in contact, with gaps up to the closure taken for contact.
 *
 * The matching is 1 without a shift, and falls with it as a rule, but not always, and it leaps
 * where the pose does. So shifts are looked at in turn, from the closure on, each the closure
 * farther or a sixteenth, whichever is more, up to the length of the underside; then the interval
 * before the first that has come to match as little is halved down to 1/1024 of the closure. The
 * shift is its end that matches no more than asked: a rational number, at which the pose and what
 * is said of it are as certain as at any other. That no smaller one matches as little is not
 * proven, and the other end of the interval is reported with what matches there. Shifts at which
 * the block does not come to rest are passed over. Cost: a few hundred resting poses at most. */

#include "base/aperture.h"
#include "number/ball.h"
#include "problem/jointed.h"
#include "problem/rested.h"

#include <math.h>

enum {
  BITS = 128,
  UNIT_BITS = 14, /* shifts are whole numbers of units: of the closure over 2^14, */
  CLOSURE = 1 << UNIT_BITS,
  FINEST = 16, /* 1/1024 of it */
  GROWTH = 16  /* a step is at least the shift over that */
};
/* The underside is not so many closures long: units are counted in 63 bits. */
static const double most_closures = 1e12;

/* What is known of one shift. */
typedef struct trial {
  long units;
  bool rests;
  arb_t matching;
} trial;

typedef struct search {
  const tp_scene *scene;
  tp_message *message;
  long most;        /* units that the underside is long */
  trial low, high;  /* above what is sought, and not above it */
  trial own;        /* in hand */
  tp_aperture gaps; /* of it */
  fmpq_t shift;     /* of it */
  double least;     /* that was found to match */
} search;

static void set_shift(fmpq_t shift, const tp_scene *scene, long units) {
  fmpq_mul_si(shift, scene->base.closure.value, scene->base.shift_left ? -units : units);
  fmpq_div_2exp(shift, shift, UNIT_BITS);
}

static void measure(search *s, const tp_jointed *j, const tp_scene *posed) {
  const tp_polyline *profile = &posed->base.profile;
  tp_aperture_measure(&s->gaps, &posed->block.outline, j->sole.first, j->sole.count, profile,
                      profile->count, s->scene->base.closure.value, BITS);
}

/* Shift the block by so much and set it down; where it does not come to rest nothing is known. */
static tp_status look(search *s, long units) {
  tp_message unsaid = {.text = ""};
  tp_jointed *j = NULL;
  tp_rested *r = NULL;
  set_shift(s->shift, s->scene, units);
  tp_status status = tp_jointed_init(&j, s->scene, s->shift, &unsaid);
  if (status == TP_OK) status = tp_rested_init(&r, &j->scene, &unsaid);
  s->own.units = units;
  s->own.rests = status == TP_OK;
  if (status == TP_OK) {
    measure(s, j, &r->scene);
    arb_div(s->own.matching, s->gaps.matched, s->gaps.length, BITS);
    s->least = fmin(s->least, arf_get_d(arb_midref(s->own.matching), ARF_RND_NEAR));
  } else if (status == TP_BAD_INPUT || status == TP_UNDECIDED) {
    status = TP_OK;
  } else if (s->message != NULL) {
    *s->message = unsaid;
  }
  tp_rested_free(r);
  tp_jointed_free(j);
  return status;
}

/* No more than is sought, as far as its ball tells. */
static bool is_enough(const search *s) {
  arb_t sought;
  arb_init(sought);
  arb_set_fmpq(sought, s->scene->base.matching.value, BITS);
  const bool above = arb_gt(s->own.matching, sought);
  arb_clear(sought);
  return !above;
}

static void keep(trial *side, const search *s) {
  side->units = s->own.units;
  side->rests = true;
  arb_set(side->matching, s->own.matching);
}

static tp_status bracket(search *s) {
  tp_status status = TP_OK;
  for (long units = CLOSURE; units <= s->most && status == TP_OK && !s->high.rests;
       units += units / GROWTH > CLOSURE ? units / GROWTH : CLOSURE) {
    status = look(s, units);
    if (status == TP_OK && s->own.rests) keep(is_enough(s) ? &s->high : &s->low, s);
  }
  return status;
}

static tp_status halve(search *s) {
  tp_status status = TP_OK;
  while (status == TP_OK && s->high.units - s->low.units > FINEST) {
    status = look(s, s->low.units + (s->high.units - s->low.units) / 2);
    if (status == TP_OK && !s->own.rests) break;
    if (status == TP_OK) keep(is_enough(s) ? &s->high : &s->low, s);
  }
  return status;
}

static tp_status fail_to_open(const search *s) {
  return tp_refuse(s->message, TP_FAULT_GEOMETRY, tp_scene_shift_place(s->scene),
                   "shifted to the %s by up to the length of its underside the block still matches "
                   "its base by %.4g wherever it comes to rest; give a smaller 'closure', a larger "
                   "'matching', or a 'shift'",
                   s->scene->base.shift_left ? "left" : "right", s->least);
}

/* How many units the underside is long, from the block where it fits. */
static tp_status find_most(search *s) {
  tp_jointed *j = NULL;
  fmpq_zero(s->shift);
  const tp_status status = tp_jointed_init(&j, s->scene, s->shift, s->message);
  if (status != TP_OK) return status;
  measure(s, j, &j->scene);
  tp_jointed_free(j);
  arb_t closures;
  arb_init(closures);
  arb_set_fmpq(closures, s->scene->base.closure.value, BITS);
  arb_div(closures, s->gaps.length, closures, BITS);
  const double many = arf_get_d(arb_midref(closures), ARF_RND_NEAR);
  arb_clear(closures);
  if (many >= 1 && many <= most_closures) {
    s->most = (long)(many * CLOSURE);
    return TP_OK;
  }
  return tp_refuse(
      s->message, TP_FAULT_GEOMETRY, s->scene->base.closure.place,
      "the underside is %.3g closures long: a matching is sought with a 'closure' that "
      "is no longer than the underside, and no less than 1e-12 of it",
      many);
}

static tp_status seek(search *s) {
  tp_status status = find_most(s);
  arb_one(s->low.matching);
  if (status != TP_OK || fmpq_is_one(s->scene->base.matching.value)) return status;
  status = bracket(s);
  if (status == TP_OK && !s->high.rests) status = fail_to_open(s);
  return status == TP_OK ? halve(s) : status;
}

static tp_status take(tp_jointed **jointed, search *s) {
  set_shift(s->shift, s->scene, s->high.units);
  const tp_status status = tp_jointed_init(jointed, s->scene, s->shift, s->message);
  if (status != TP_OK) return status;
  tp_jointed *j = *jointed;
  j->sought = true;
  set_shift(j->before, s->scene, s->low.units);
  j->before_matching = tp_ball_bounded(s->low.matching);
  return TP_OK;
}

tp_status tp_jointed_ask(tp_jointed **jointed, const tp_scene *scene, tp_message *message) {
  if (scene->base.shift.given) {
    return tp_jointed_init(jointed, scene, scene->base.shift.value, message);
  }
  search s = {.scene = scene, .message = message, .least = 1};
  tp_aperture_init(&s.gaps);
  fmpq_init(s.shift);
  arb_init(s.low.matching);
  arb_init(s.high.matching);
  arb_init(s.own.matching);
  tp_status status = seek(&s);
  if (status == TP_OK) status = take(jointed, &s);
  arb_clear(s.low.matching);
  arb_clear(s.high.matching);
  arb_clear(s.own.matching);
  fmpq_clear(s.shift);
  tp_aperture_clear(&s.gaps);
  return status;
}
