/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The strength share nearest to 1 at which the onset changes: searched in doubles over the
 * intervals of all modes, both sides proven in doubles with bounds or by the modes in balls
 * (docs/mechanics.md section 6, factor of the onset). */

#include "motion/strength_change.h"

#include "motion/mode_reading.h"
#include "motion/windows.h"
#include "number/ball.h"

#include <float.h>
#include <math.h>

void tp_strength_change_init(tp_strength_change *change) {
  change->found = change->raised = false;
  change->mechanism = TP_MECHANISM_UNDECIDED;
  arb_init(change->share);
}

void tp_strength_change_clear(tp_strength_change *change) {
  arb_clear(change->share);
}

/* ---- search ------------------------------------------------------------------------------------
 */

/* One question at work. */
typedef struct searching {
  const tp_strength_asked *asked;
  tp_mode_reading reading;
} searching;

/* Below the share with which some forces just hold it, none do. */
static bool add_lost(tp_share_spans *spans, const tp_strength_asked *a) {
  if (a->is_held) return true;
  const double share = arf_get_d(arb_midref(a->held), ARF_RND_NEAR);
  return tp_share_spans_put(spans, (tp_share_span){TP_LEAST_SHARE, share, a->lost});
}

/* The spans of all modes; false where one is too large. */
static bool search(tp_share_spans *spans, searching *r) {
  const tp_motions *m = r->asked->motions;
  tp_share_mode mode;
  bool done = add_lost(spans, r->asked), all = true;
  for (long k = 0; k < m->mode_count && done && r->reading.outcome == TP_MOTION_PROVEN; k++) {
    if (tp_mode_read(&mode, &r->reading, m->modes + k)) {
      done = tp_share_spans_add(spans, &mode);
    } else {
      all = false;
    }
  }
  if (!done) r->reading.outcome = TP_MOTION_OUT_OF_MEMORY;
  return done && all;
}

/* ---- proofs ------------------------------------------------------------------------------------
 */

/* Can a motion begin with the share? 1, or -1: no; 0 where doubles do not tell. */
static int side_by_doubles(searching *r, const arf_t share) {
  const tp_motions *m = r->asked->motions;
  const double s = arf_get_d(share, ARF_RND_NEAR);
  tp_share_mode mode;
  int any = arf_cmp_d(share, s) == 0 ? -1 : 0;
  if (any == 0) return 0;
  for (long k = 0; k < m->mode_count; k++) {
    const int side =
        tp_mode_read(&mode, &r->reading, m->modes + k) ? tp_share_mode_side(&mode, s) : 0;
    if (side > 0) return 1;
    if (side == 0) any = 0;
  }
  return any;
}

static void scale_cones(tp_cones *cones, const arf_t share, long bits) {
  if (cones == NULL) return;
  arb_mul_arf(cones->friction, cones->friction, share, bits);
  for (long k = 0; k < cones->own_count; k++) {
    arb_mul_arf(cones->own_friction + k, cones->own_friction + k, share, bits);
  }
  for (long k = 0; k < cones->capacity_count; k++) {
    arb_mul_arf(cones->capacities[k].shear, cones->capacities[k].shear, share, bits);
    arb_mul_arf(cones->capacities[k].pull, cones->capacities[k].pull, share, bits);
  }
}

/* The strength of cones as given. */
typedef struct given {
  tp_cones *cones;
  arb_t friction;
  arb_ptr own, bounds;
} given;

static void keep(given *g, tp_cones *cones) {
  g->cones = cones;
  if (cones == NULL) return;
  arb_init(g->friction);
  arb_set(g->friction, cones->friction);
  g->own = _arb_vec_init(cones->own_count);
  _arb_vec_set(g->own, cones->own_friction, cones->own_count);
  g->bounds = _arb_vec_init(2 * cones->capacity_count);
  for (long k = 0; k < cones->capacity_count; k++) {
    arb_set(g->bounds + 2 * k, cones->capacities[k].shear);
    arb_set(g->bounds + 2 * k + 1, cones->capacities[k].pull);
  }
}

static void give_back(given *g) {
  tp_cones *cones = g->cones;
  if (cones == NULL) return;
  arb_swap(cones->friction, g->friction);
  _arb_vec_swap(cones->own_friction, g->own, cones->own_count);
  for (long k = 0; k < cones->capacity_count; k++) {
    arb_swap(cones->capacities[k].shear, g->bounds + 2 * k);
    arb_swap(cones->capacities[k].pull, g->bounds + 2 * k + 1);
  }
  _arb_vec_clear(g->own, cones->own_count);
  _arb_vec_clear(g->bounds, 2 * cones->capacity_count);
  arb_clear(g->friction);
}

static int side_of_spans(const tp_motions *m, const arb_t degrees) {
  int any = -1;
  for (long k = 0; k < m->spans.count; k++) {
    const tp_answer here = tp_tilt_span_holds(m->spans.items + k, degrees);
    if (here == TP_YES) return 1;
    if (here == TP_OPEN) any = 0;
  }
  return any;
}

/* The same by balls, of all modes with the strength so scaled; 0 where that is open. Where the
 * judge would take zeros, first without. */
static tp_motion_outcome side_by_balls(int *side, const tp_strength_asked *a, const arf_t share) {
  given own, strong;
  tp_motion_question q = *a->question;
  tp_motion_outcome done = TP_MOTION_OPEN;
  q.keeps_all = false;
  *side = 0;
  keep(&own, a->cones);
  keep(&strong, a->strong);
  scale_cones(a->cones, share, q.judge.bits);
  scale_cones(a->strong, share, q.judge.bits);
  for (int settled = 0; settled <= a->question->judge.settled && done == TP_MOTION_OPEN;
       settled++) {
    tp_motions motions;
    q.judge.settled = settled == 1;
    done = tp_motions_init(&motions, &q);
    if (done != TP_MOTION_PROVEN) continue;
    *side = side_of_spans(&motions, a->degrees);
    tp_motions_clear(&motions);
  }
  give_back(&strong);
  give_back(&own);
  return done == TP_MOTION_OPEN ? TP_MOTION_PROVEN : done;
}

/* Where forces just do not hold it something moves, by a mode or not. */
static bool is_lost(const tp_strength_asked *a, const arf_t share) {
  arb_t own;
  if (a->is_held) return false;
  arb_init(own);
  arb_set_arf(own, share);
  const bool lost = arb_lt(own, a->held) != 0;
  arb_clear(own);
  return lost;
}

static tp_motion_outcome side_of(int *side, searching *r, const arf_t share) {
  *side = is_lost(r->asked, share) ? 1 : side_by_doubles(r, share);
  if (*side != 0 || r->reading.outcome == TP_MOTION_OUT_OF_MEMORY) return r->reading.outcome;
  return side_by_balls(side, r->asked, share);
}

/* From what doubles tell apart, 2^-43 or about 10^-13, to what is asked for. */
enum { NARROWEST = 43, STEP = 4, SPARE = 4 };

/* The sides of a share within 2^-wanted of it: do they differ? Where doubles may tell, the sides
 * are doubles. */
static tp_motion_outcome try_about(bool *proven, searching *r, arb_t share, const arf_t about,
                                   slong wanted) {
  const long bits = wanted > NARROWEST ? r->asked->question->judge.bits : DBL_MANT_DIG;
  arf_t width, end;
  int below = 0, above = 0;
  arf_init(width);
  arf_init(end);
  arf_mul_2exp_si(width, about, -wanted);
  arf_sub(end, about, width, bits, ARF_RND_DOWN);
  tp_motion_outcome done = side_of(&below, r, end);
  if (done == TP_MOTION_PROVEN && below != 0) {
    arf_add(end, about, width, bits, ARF_RND_UP);
    done = side_of(&above, r, end);
  }
  *proven = done == TP_MOTION_PROVEN && below * above < 0;
  if (*proven) {
    arb_set_arf(share, about);
    arf_mul_2exp_si(width, width, 1); /* the rounded ends lie within */
    arf_get_mag(arb_radref(share), width);
  }
  arf_clear(width);
  arf_clear(end);
  return done;
}

/* Halve between shares on different sides, 2^-bracket about it, to 2^-wanted. */
static tp_motion_outcome refine(arf_t about, searching *r, slong bracket, slong wanted) {
  const long bits = r->asked->question->judge.bits;
  arf_t low, high, width;
  int below = 0, side = 1;
  arf_init(low);
  arf_init(high);
  arf_init(width);
  arf_mul_2exp_si(width, about, -bracket);
  arf_sub(low, about, width, bits, ARF_RND_DOWN);
  arf_add(high, about, width, bits, ARF_RND_UP);
  tp_motion_outcome done = side_of(&below, r, low);
  for (; bracket < wanted && done == TP_MOTION_PROVEN && side != 0; bracket++) {
    arf_add(about, low, high, bits, ARF_RND_NEAR);
    arf_mul_2exp_si(about, about, -1);
    done = side_of(&side, r, about);
    if (side != 0) arf_set(side == below ? low : high, about);
  }
  arf_add(about, low, high, bits, ARF_RND_NEAR);
  arf_mul_2exp_si(about, about, -1);
  arf_clear(low);
  arf_clear(high);
  arf_clear(width);
  return done;
}

/* To what doubles tell apart, and where more is asked for on from there by halves. */
static tp_motion_outcome enclose(bool *proven, searching *r, arb_t share, double estimate) {
  const slong asked = (slong)tp_digits_bits(r->asked->digits + 1) + 1;
  tp_motion_outcome done = TP_MOTION_PROVEN;
  arf_t about;
  arf_init(about);
  arf_set_d(about, estimate);
  slong wanted = NARROWEST;
  *proven = false;
  for (; wanted > STEP && done == TP_MOTION_PROVEN && !*proven; wanted -= STEP) {
    done = try_about(proven, r, share, about, wanted);
  }
  wanted += STEP;
  if (done == TP_MOTION_PROVEN && *proven && wanted < asked) {
    done = refine(about, r, wanted, asked + SPARE);
    if (done == TP_MOTION_PROVEN) done = try_about(proven, r, share, about, asked);
  }
  arf_clear(about);
  return done;
}

/* What does not change stays so at the ends of what is tried, unless these prove otherwise. */
static bool is_throughout(searching *r) {
  static const double ends[] = {TP_LEAST_SHARE, TP_MOST_SHARE};
  const int other = r->asked->can_begin ? -1 : 1;
  bool same = true;
  arf_t share;
  arf_init(share);
  for (int k = 0; k < 2 && same; k++) {
    arf_set_d(share, ends[k]);
    same = side_by_doubles(r, share) != other;
  }
  arf_clear(share);
  return same;
}

tp_motion_outcome tp_strength_change_find(tp_strength_change *change,
                                          const tp_strength_asked *asked) {
  searching r = {.asked = asked};
  tp_share_spans spans = {.count = 0};
  change->found = false;
  if (asked->all_is_lost) return TP_MOTION_PROVEN;
  tp_mode_reading_init(&r.reading, asked->question, asked->motions, asked->degrees);
  bool proven = search(&spans, &r);
  tp_share_change found = tp_share_spans_change(&spans, asked->can_begin);
  tp_motion_outcome done = r.reading.outcome;
  if (done == TP_MOTION_PROVEN && proven && found.found && found.share == 1) {
    /* against what is known of all of the strength: nearer to a tie than doubles tell */
    r.reading.keeps_balls = true;
    spans.count = 0;
    proven = search(&spans, &r);
    found = tp_share_spans_change(&spans, asked->can_begin);
    done = r.reading.outcome;
  }
  if (done == TP_MOTION_PROVEN && proven && !found.found) proven = is_throughout(&r);
  if (done == TP_MOTION_PROVEN && found.found) {
    done = enclose(&proven, &r, change->share, found.share);
    change->found = proven;
    change->raised = found.share > 1;
    change->mechanism = found.mechanism;
  }
  tp_share_spans_clear(&spans);
  tp_mode_reading_clear(&r.reading);
  return done == TP_MOTION_PROVEN && !proven ? TP_MOTION_OPEN : done;
}

tp_motion_outcome tp_strength_change_of_modes(double *share, const tp_strength_asked *asked) {
  searching r = {.asked = asked};
  tp_share_spans spans = {.count = 0};
  tp_mode_reading_init(&r.reading, asked->question, asked->motions, asked->degrees);
  const bool all = search(&spans, &r);
  const tp_share_change found = tp_share_spans_change(&spans, asked->can_begin);
  *share = found.found ? found.share : 0;
  const tp_motion_outcome done = r.reading.outcome;
  tp_share_spans_clear(&spans);
  tp_mode_reading_clear(&r.reading);
  return done == TP_MOTION_PROVEN && !all ? TP_MOTION_OPEN : done;
}
