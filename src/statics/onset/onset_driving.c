/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The multiple of the driving loads at which a motion begins.
 *
 * The loads at the scene's tilt are a sum R + D of resisting and driving loads. Those of a scene
 * with the multiple lambda are R + lambda D, which has the direction of R cos t + D sin t with
 * lambda = tan t. The modes of motion depend on the direction alone, so that the windows of t are
 * those of a question in which R goes with the cosine of the tilt and D with its sine; capacities
 * of cohesion and bonds then go with the cosine, too. For the weight alone that is the question of
 * the onset itself, and lambda = tan(end of a window) / tan(tilt). Loads that all act at the
 * centroid have no moment about it: their direction at the end of a window of tilts is known, and
 * gives lambda by a quotient of two cross products.
 *
 * Under cohesion or bonds the modes alone may begin later than forces fail (onset/onset_limit.c),
 * so that the multiple up to which forces hold the block is an upper bound. It is the static limit
 * of loads R - D + D / cos t, in which capacities stay and lambda = 1 / cos t - 1. */

#include "onset/onset_driving.h"

#include "evaluation/friction.h"
#include "evaluation/loaded_exact.h"
#include "limit/limit.h"
#include "motion/generators.h"
#include "number/ball.h"
#include "static_limit/limit_result.h"

#include <math.h>

/* ---- resisting and driving loads ----------------------------------------------------------------
 */

/* Loads at the scene's tilt: what rests goes with TP_COS, what drives with TP_SIN. */
typedef struct split {
  const tp_evaluation *e;
  tp_wrench all, others; /* of all loads; of those that do not act at the centroid */
  bool has_others;
  arb_t sine, cosine; /* of the scene's tilt */
  long bits;
} split;

static void add_term(tp_wrench *to, int to_basis, const tp_wrench *load, int basis,
                     const arb_t times, long bits) {
  arb_addmul(to->x.of + to_basis, load->x.of + basis, times, bits);
  arb_addmul(to->y.of + to_basis, load->y.of + basis, times, bits);
  arb_addmul(to->moment.of + to_basis, load->moment.of + basis, times, bits);
}

static void add_to(split *s, tp_wrench *to, const tp_load *load, bool by_parts, bool drives) {
  arb_t value;
  if (by_parts) { /* gravity: what points along the base to the down-dip side drives */
    add_term(to, TP_COS, &load->wrench, TP_COS, s->cosine, s->bits);
    add_term(to, arb_is_positive(s->sine) ? TP_SIN : TP_COS, &load->wrench, TP_SIN, s->sine,
             s->bits);
    return;
  }
  arb_init(value);
  const tp_trig *from[] = {&load->wrench.x, &load->wrench.y, &load->wrench.moment};
  tp_trig *parts[] = {&to->x, &to->y, &to->moment};
  for (int k = 0; k < 3; k++) {
    arb_struct *sum = parts[k]->of + (drives ? TP_SIN : TP_COS);
    tp_trig_evaluate(value, from[k], s->sine, s->cosine, s->bits);
    arb_add(sum, sum, value, s->bits);
  }
  arb_clear(value);
}

static bool is_water(const tp_load *load) {
  return load->kind == TP_LOAD_WATER || load->kind == TP_LOAD_UPLIFT || load->kind == TP_LOAD_ICE;
}

/* Adds by how much a force points along the base to the side and off it together. The frame runs
 * along the base, x against the side; but up-dip it is level, and the base rises by c to s, so that
 * (-c, s) points to the side and (s, c) off the base (problem/world.h). */
static void add_push(arb_t push, const split *s, const tp_load *load) {
  const tp_base_description *base = &s->e->problem->scene->base;
  arb_t x, y, cosine, sine;
  arb_init(x);
  arb_init(y);
  arb_init(cosine);
  arb_init(sine);
  tp_trig_evaluate(x, &load->wrench.x, s->sine, s->cosine, s->bits);
  tp_trig_evaluate(y, &load->wrench.y, s->sine, s->cosine, s->bits);
  if (base->beyond_cosine == NULL) {
    arb_one(cosine);
  } else {
    arb_set_fmpq(cosine, base->beyond_cosine, s->bits);
    arb_set_fmpq(sine, base->beyond_sine, s->bits);
    arb_abs(sine, sine);
  }
  arb_submul(push, x, cosine, s->bits);
  arb_addmul(push, x, sine, s->bits);
  arb_addmul(push, y, cosine, s->bits);
  arb_addmul(push, y, sine, s->bits);
  arb_clear(x);
  arb_clear(y);
  arb_clear(cosine);
  arb_clear(sine);
}

/* Does a load that does not turn with gravity drive the block? Water does as one. A push that is
 * zero counts as driving, as balls may not tell it from one that is not. */
static bool drives(const split *s, const tp_load *load) {
  const tp_loaded *loaded = s->e->loaded;
  switch (load->kind) {
  case TP_LOAD_SEISMIC:
    return true;
  case TP_LOAD_ANCHOR:
  case TP_LOAD_SUPPORT:
    return load->active; /* it is taken from the driving loads */
  default:
    break;
  }
  arb_t push;
  arb_init(push);
  if (!is_water(load)) add_push(push, s, load);
  for (long k = 0; k < loaded->count && is_water(load); k++) {
    if (is_water(loaded->items + k)) add_push(push, s, loaded->items + k);
  }
  const bool does = !arb_is_negative(push);
  arb_clear(push);
  return does;
}

/* The weight, and what counts as such: it rests by one part and drives by the other. */
static bool is_by_parts(const tp_load *load) {
  return load->kind == TP_LOAD_WEIGHT || load->kind == TP_LOAD_SURCHARGE;
}

/* Is the moment about a contact point of all that rests (TP_COS), or drives (TP_SIN), zero, as that
 * of each load is, exactly? Of a tp_motion_question. */
static bool vanishes(const void *of, long site, int basis) {
  const split *s = of;
  const tp_evaluation *e = s->e;
  const bool driving = basis == TP_SIN;
  if (site >= e->problem->contact.point_count) return false;
  for (long k = 0; k < e->loaded->count; k++) {
    const tp_load *load = e->loaded->items + k;
    tp_load_part part = TP_LOAD_WHOLE;
    if (is_by_parts(load) && arb_is_positive(s->sine)) {
      part = driving ? TP_WEIGHT_PARALLEL : TP_WEIGHT_NORMAL;
    } else if ((!is_by_parts(load) && drives(s, load)) != driving) {
      continue;
    }
    if (!tp_loaded_vanishes(load, part, e->loaded, e, site)) return false;
  }
  return true;
}

static void split_init(split *s, const tp_evaluation *e, const arb_t tilt) {
  const tp_loaded *loaded = e->loaded;
  s->e = e;
  s->bits = e->rung.bits;
  s->has_others = false;
  tp_wrench_init(&s->all);
  tp_wrench_init(&s->others);
  arb_init(s->sine);
  arb_init(s->cosine);
  tp_ball_sin_cos(s->sine, s->cosine, tilt, s->bits);
  for (long k = 0; k < loaded->count; k++) {
    const tp_load *load = loaded->items + k;
    const bool by_parts = is_by_parts(load);
    const bool pushes = !by_parts && drives(s, load);
    add_to(s, &s->all, load, by_parts, pushes);
    if (tp_onset_load_is_central(load)) continue;
    add_to(s, &s->others, load, by_parts, pushes);
    s->has_others = true;
  }
}

static void split_clear(split *s) {
  tp_wrench_clear(&s->all);
  tp_wrench_clear(&s->others);
  arb_clear(s->sine);
  arb_clear(s->cosine);
}

static bool nothing_drives(const split *s) {
  return arb_is_zero(s->all.x.of + TP_SIN) && arb_is_zero(s->all.y.of + TP_SIN) &&
         arb_is_zero(s->all.moment.of + TP_SIN);
}

/* ---- where a motion begins ----------------------------------------------------------------------
 */

/* One case at work: the factor is known as one of the states, and where it is a number as a ball.
 */
typedef struct finding {
  const tp_onset_telling *t;
  tp_onset_asked *asked;
  tp_answer moves;
  tp_fos_state state;
  arb_t factor;
  tp_mechanism mechanism;
  const tp_motion_window *begins; /* of `telling`, where it turns about a centre; or NULL */
  const tp_onset_telling *of;
} finding;

/* The window whose lower end is sought: that which holds the tilt, or else the next one above it. A
 * tilt that bounds do not tell from a lower end is at that end. NULL: there is none; `*open`: that
 * is not known, or is not as the state of the block has it. */
static const tp_motion_window *window_at(bool *open, const tp_motion_windows *windows,
                                         const arb_t degrees, tp_answer moves) {
  *open = false;
  for (long k = 0; k < windows->count; k++) {
    const tp_motion_window *w = windows->items + k;
    const tp_answer holds = tp_window_holds(w, degrees);
    const bool above = !w->from.endless && arb_gt(w->from.degrees, degrees);
    if (holds == TP_NO && !above) continue;
    const bool at_end = holds != TP_NO && !w->from.endless && !arb_lt(w->from.degrees, degrees);
    *open = !at_end && (holds == TP_OPEN || (holds == TP_YES && moves == TP_NO) ||
                        (holds == TP_NO && moves == TP_YES));
    return *open ? NULL : w;
  }
  *open = moves == TP_YES; /* one should hold it */
  return NULL;
}

/* From `factor`, which may not be finite or of no certain sign. */
static void set_number(finding *f, const tp_motion_window *w, const tp_onset_telling *of) {
  if (arb_is_nonpositive(f->factor)) {
    f->state = f->moves == TP_YES ? TP_FOS_UNDEFINED : TP_FOS_NO_OVERTURNING;
  } else if (arb_is_finite(f->factor) && arb_is_positive(f->factor)) {
    f->state = TP_FOS_NUMBER;
    f->mechanism = w->mechanism;
    f->begins = w;
    f->of = of;
  }
}

/* A motion begins at every lesser multiple, too; or at no greater one. */
static void set_endless(finding *f) {
  if (f->moves == TP_OPEN) return;
  f->state = f->moves == TP_YES ? TP_FOS_UNDEFINED : TP_FOS_NO_OVERTURNING;
}

/* Of the weight alone. */
static void find_by_weight(finding *f, const arb_t tilt) {
  const long bits = f->t->e->rung.bits;
  bool open;
  if (!arb_is_positive(tilt)) {
    if (arb_is_nonpositive(tilt)) set_endless(f);
    return;
  }
  const tp_motion_window *w = window_at(&open, f->t->windows, tilt, f->moves);
  if (open) return;
  if (w == NULL || w->from.endless) {
    set_endless(f);
    return;
  }
  arb_t sine, cosine, own;
  arb_init(sine);
  arb_init(cosine);
  arb_init(own);
  tp_ball_sin_cos(sine, cosine, tilt, bits);
  arb_div(own, cosine, sine, bits);
  tp_ball_sin_cos(sine, cosine, w->from.degrees, bits);
  arb_div(f->factor, sine, cosine, bits);
  arb_mul(f->factor, f->factor, own, bits);
  set_number(f, w, f->t);
  arb_clear(sine);
  arb_clear(cosine);
  arb_clear(own);
}

/* a x b of forces. */
static void cross(arb_t value, const arb_t ax, const arb_t ay, const arb_t bx, const arb_t by,
                  long bits) {
  arb_mul(value, ax, by, bits);
  arb_submul(value, ay, bx, bits);
}

/* Of loads that act at the centroid: R + lambda D has the direction of all loads at the tilt w. */
static void find_by_direction(finding *f, const split *s, const arb_t tilt) {
  const tp_loaded *loaded = f->t->e->loaded;
  const long bits = s->bits;
  bool open;
  const tp_motion_window *w = window_at(&open, f->t->windows, tilt, f->moves);
  if (open) return;
  if (w == NULL || w->from.endless) {
    set_endless(f);
    return;
  }
  arb_t sine, cosine, x, y, over;
  arb_init(sine);
  arb_init(cosine);
  arb_init(x);
  arb_init(y);
  arb_init(over);
  tp_ball_sin_cos(sine, cosine, w->from.degrees, bits);
  tp_trig_evaluate(x, &loaded->sum.x, sine, cosine, bits);
  tp_trig_evaluate(y, &loaded->sum.y, sine, cosine, bits);
  cross(f->factor, s->all.x.of + TP_COS, s->all.y.of + TP_COS, x, y, bits);
  cross(over, s->all.x.of + TP_SIN, s->all.y.of + TP_SIN, x, y, bits);
  arb_neg(over, over);
  if (arb_contains_zero(over) && w->from.source.kind == TP_FROM_SITE &&
      vanishes(s, w->from.source.a, TP_SIN)) {
    set_endless(f); /* what drives passes through the point that it would turn about */
  } else {
    arb_div(f->factor, f->factor, over, bits);
    set_number(f, w, f->t);
  }
  arb_clear(sine);
  arb_clear(cosine);
  arb_clear(x);
  arb_clear(y);
  arb_clear(over);
}

/* Of any loads by the windows of a question of their own. They outlive neither the call nor the
 * centre that is taken from them. */
static tp_motion_outcome find_by_modes(finding *f, const split *s) {
  enum { LEVEL_OF_ONE = 45 }; /* tan 45 degrees is 1, the scene's own loads */
  const tp_evaluation *e = f->t->e;
  tp_motion_question q;
  tp_motions motions;
  tp_motion_windows windows;
  tp_motion_question_init(&q, f->asked->question.cones);
  arb_set(q.scale, f->asked->question.scale);
  arb_set(q.x, f->asked->question.x);
  arb_set(q.y, f->asked->question.y);
  arb_set(q.gyration, f->asked->question.gyration);
  q.strong = f->asked->question.strong;
  q.judge = f->asked->question.judge;
  q.work = f->asked->question.work;
  q.capacity_basis = TP_COS;
  q.vanishes = vanishes;
  q.loads = s;
  tp_onset_question_load(&q, e, f->t->result->towards, &s->all, s->has_others ? &s->others : NULL);
  tp_motion_outcome done = tp_motions_init(&motions, &q);
  if (done == TP_MOTION_PROVEN) {
    done = tp_windows_init(&windows, &motions, &q.judge);
    if (done != TP_MOTION_PROVEN) tp_motions_clear(&motions);
  }
  if (done == TP_MOTION_PROVEN) {
    bool open;
    arb_t one;
    arb_init(one);
    arb_set_ui(one, LEVEL_OF_ONE);
    const tp_motion_window *w = window_at(&open, &windows, one, f->moves);
    const tp_onset_telling t = {e, f->t->certainty, f->t->result, &q, &motions, &windows};
    if (!open && (w == NULL || w->from.endless)) set_endless(f);
    if (!open && w != NULL && !w->from.endless) {
      arb_t sine, cosine;
      arb_init(sine);
      arb_init(cosine);
      tp_ball_sin_cos(sine, cosine, w->from.degrees, s->bits);
      arb_div(f->factor, sine, cosine, s->bits);
      arb_clear(sine);
      arb_clear(cosine);
      set_number(f, w, &t);
    }
    tp_onset *onset = &f->t->result->onset;
    onset->has_driving_centre =
        f->begins != NULL && w->has_ray && motions.twists.rays[w->ray].axis < 0;
    if (onset->has_driving_centre) {
      tp_onset_centre(&onset->driving_centre_x_m, &onset->driving_centre_y_m, &t,
                      &motions.twists.rays[w->ray].twist);
    }
    f->begins = NULL;
    arb_clear(one);
    tp_windows_clear(&windows);
    tp_motions_clear(&motions);
  }
  tp_motion_question_clear(&q);
  return done;
}

/* ---- up to where forces hold --------------------------------------------------------------------
 */

/* The multiple up to which forces hold the block. Capacities stay, so that lambda has to be a
 * function of the tilt by which a search from level begins where forces hold: 1 / cos t from the
 * scene's own loads on, or sin t from no driving loads up to these. */
typedef struct held {
  bool beyond;            /* the first of these */
  bool bounded;           /* there is such a multiple: */
  arb_t multiple;         /* if bounded: that, */
  tp_mechanism mechanism; /* and what moves beyond it */
} held;

/* How far to look for it, in degrees: no farther than a little beyond where a motion can begin, as
 * the lesser of both is taken. Towards upright, and infinite loads, it may not be decided. */
static double range_of(const held *h, const finding *f) {
  static const double all_but_upright = 90 * (1 - 0x1p-20), degrees = 180 / M_PI, more = 1 + 0x1p-8;
  const double factor = arf_get_d(arb_midref(f->factor), ARF_RND_NEAR);
  if (!h->beyond || f->state != TP_FOS_NUMBER || !(factor > 1)) return all_but_upright;
  return fmin(all_but_upright, acos(1 / (factor * more)) * degrees);
}

static tp_limit_outcome find_held(held *h, tp_limit_kind *kind, const finding *f, const split *s) {
  const tp_evaluation *e = f->t->e;
  tp_cones *cones = &f->asked->strong;
  tp_wrench load, local;
  tp_limit_answer answer;
  if (!tp_limit_answer_init(&answer, cones)) return TP_LIMIT_OUT_OF_MEMORY;
  arb_set(cones->friction, f->asked->cones.friction);
  tp_wrench_init(&load);
  tp_wrench_init(&local);
  const tp_trig *from[] = {&s->all.x, &s->all.y, &s->all.moment};
  tp_trig *to[] = {&load.x, &load.y, &load.moment};
  for (int k = 0; k < 3; k++) {
    arb_set(to[k]->of + TP_ONE, from[k]->of + TP_COS);
    arb_set(to[k]->of + (h->beyond ? TP_SEC : TP_SIN), from[k]->of + TP_SIN);
  }
  tp_loaded_local(&local, &load, e->loaded, e);
  const tp_limit_question question = {.cones = cones,
                                      .load = &local,
                                      .range_deg = range_of(h, f),
                                      .work = e->work,
                                      .without_forces = true,
                                      .judge = f->asked->question.judge};
  tp_work_begin(e->work, tp_cones_column_count(cones));
  const tp_limit_outcome outcome = tp_limit_find(&answer, &question);
  *kind = answer.kind;
  h->bounded = outcome == TP_LIMIT_PROVEN && answer.kind == TP_LIMIT_AT_ANGLE;
  if (h->bounded) {
    arb_t other;
    arb_init(other);
    if (h->beyond) {
      tp_ball_sin_cos(other, h->multiple, answer.degrees, s->bits);
      arb_inv(h->multiple, h->multiple, s->bits);
    } else {
      tp_ball_sin_cos(h->multiple, other, answer.degrees, s->bits);
    }
    arb_clear(other);
    h->mechanism = tp_limit_mechanism(answer.face.motion);
  }
  tp_wrench_clear(&load);
  tp_wrench_clear(&local);
  tp_limit_answer_clear(&answer);
  return outcome;
}

static void take_lesser(finding *f, const held *h, long bits) {
  const bool less = f->state == TP_FOS_NO_OVERTURNING ||
                    (f->state == TP_FOS_NUMBER && arb_lt(h->multiple, f->factor));
  if (less) {
    arb_set(f->factor, h->multiple);
    f->state = TP_FOS_NUMBER;
    f->mechanism = h->mechanism;
    f->t->result->onset.has_driving_centre = false;
  } else if (f->state == TP_FOS_NUMBER) {
    arb_min(f->factor, f->factor, h->multiple, bits);
  }
}

/* Takes the lesser of the factor and of that multiple. */
static tp_motion_outcome take_held(finding *f, const split *s) {
  tp_limit_kind kind = TP_LIMIT_UNDECIDED;
  held h = {.beyond = f->moves != TP_YES};
  arb_init(h.multiple);
  tp_limit_outcome outcome = find_held(&h, &kind, f, s);
  if (h.beyond && outcome == TP_LIMIT_PROVEN && kind == TP_LIMIT_NOWHERE) {
    h.beyond = false;
    outcome = find_held(&h, &kind, f, s);
  }
  if (h.bounded) take_lesser(f, &h, s->bits);
  if (outcome == TP_LIMIT_PROVEN && kind == TP_LIMIT_NOWHERE) f->state = TP_FOS_UNDEFINED;
  arb_clear(h.multiple);
  return outcome == TP_LIMIT_PROVEN          ? TP_MOTION_PROVEN
         : outcome == TP_LIMIT_OUT_OF_MEMORY ? TP_MOTION_OUT_OF_MEMORY
                                             : TP_MOTION_OPEN;
}

/* ---- result -------------------------------------------------------------------------------------
 */

/* Where the windows of tilts, which end at 90 degrees, have no motion that greater multiples reach:
 * what drives may lift the block, and turn all loads beyond. */
static bool may_turn_beyond(const finding *f, const split *s) {
  return f->state == TP_FOS_NO_OVERTURNING && !arb_is_nonpositive(s->all.y.of + TP_SIN);
}

static tp_motion_outcome find_loaded(finding *f, const arb_t tilt) {
  tp_motion_outcome done = TP_MOTION_PROVEN;
  split s;
  split_init(&s, f->t->e, tilt);
  const bool strong = f->asked->question.strong != NULL;
  if (nothing_drives(&s)) {
    set_endless(f);
  } else if (!s.has_others && !strong) {
    find_by_direction(f, &s, tilt);
    if (may_turn_beyond(f, &s)) {
      f->state = TP_FOS_UNDECIDED;
      done = find_by_modes(f, &s);
    }
  } else {
    done = find_by_modes(f, &s);
    if (strong && done == TP_MOTION_PROVEN && f->state != TP_FOS_UNDECIDED) done = take_held(f, &s);
  }
  split_clear(&s);
  return done;
}

static void set_centre(const finding *f) {
  tp_onset *onset = &f->t->result->onset;
  const tp_motion_window *w = f->begins;
  if (w == NULL || !w->has_ray || f->of->motions->twists.rays[w->ray].axis >= 0) return;
  onset->has_driving_centre = true;
  tp_onset_centre(&onset->driving_centre_x_m, &onset->driving_centre_y_m, f->of,
                  &f->of->motions->twists.rays[w->ray].twist);
}

tp_motion_outcome tp_onset_driving(const tp_onset_telling *t, tp_onset_asked *asked,
                                   const arb_t tilt, tp_answer moves) {
  tp_onset *onset = &t->result->onset;
  finding f = {.t = t, .asked = asked, .moves = moves, .state = TP_FOS_UNDECIDED};
  tp_motion_outcome done = TP_MOTION_PROVEN;
  arb_init(f.factor);
  onset->has_driving_centre = false;
  f.mechanism = TP_MECHANISM_UNDECIDED;
  if (t->e->loaded == NULL) {
    find_by_weight(&f, tilt);
  } else {
    done = find_loaded(&f, tilt);
  }
  if (done != TP_MOTION_PROVEN) f.state = TP_FOS_UNDECIDED;
  onset->fos_driving = (tp_fos){.state = f.state};
  onset->fos_driving_mechanism = f.mechanism;
  if (f.state == TP_FOS_NUMBER) {
    onset->fos_driving.value = tp_result(t->e, f.factor, t->certainty);
    set_centre(&f);
  }
  if (f.state == TP_FOS_UNDECIDED && done == TP_MOTION_PROVEN) done = TP_MOTION_OPEN;
  arb_clear(f.factor);
  return done;
}
