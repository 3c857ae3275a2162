/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Solutions of one inequality in the tilt as spans between zeros (load/zeros.h), and intersections
 * of spans with ends compared by their source or by disjoint balls. */

#include "motion/tilts.h"

#include "common/grow.h"
#include "load/zeros.h"
#include "number/ball.h"

#include <stdlib.h>
#include <string.h>

void tp_tilt_init(tp_tilt *tilt) {
  memset(tilt, 0, sizeof *tilt);
  arb_init(tilt->degrees);
}

void tp_tilt_clear(tp_tilt *tilt) {
  arb_clear(tilt->degrees);
}

void tp_tilt_set(tp_tilt *tilt, const tp_tilt *other) {
  tilt->endless = other->endless;
  tilt->source = other->source;
  tilt->rays = other->rays;
  arb_set(tilt->degrees, other->degrees);
}

bool tp_source_is_same(const tp_source *a, const tp_source *b) {
  return a->kind == b->kind && a->a == b->a && a->b == b->b && a->root == b->root &&
         a->mode == b->mode;
}

int tp_tilt_compare(const tp_tilt *a, const tp_tilt *b, const tp_judge *judge) {
  if (tp_source_is_same(&a->source, &b->source)) return 0;
  arb_t gap;
  arb_init(gap);
  arb_sub(gap, a->degrees, b->degrees, judge->bits);
  const int sign = tp_judge_sign(judge, gap, 0);
  arb_clear(gap);
  return sign;
}

bool tp_tilt_is_same(const tp_tilt *a, const tp_tilt *b) {
  if (a->endless || b->endless) return a->endless == b->endless;
  return tp_source_is_same(&a->source, &b->source) ||
         (arb_is_exact(a->degrees) && arb_equal(a->degrees, b->degrees));
}

void tp_tilts_clear(tp_motion_tilts *spans) {
  for (long k = 0; k < spans->room; k++) {
    tp_tilt_clear(&spans->items[k].from);
    tp_tilt_clear(&spans->items[k].to);
  }
  free(spans->items);
  memset(spans, 0, sizeof *spans);
}

void tp_tilts_empty(tp_motion_tilts *spans) {
  spans->count = 0;
}

tp_tilt_span *tp_tilts_add(tp_motion_tilts *spans) {
  const long before = spans->room;
  tp_tilt_span *more = tp_grow(spans->items, spans->count, &spans->room, sizeof *more);
  if (more == NULL) return NULL;
  spans->items = more;
  for (long k = before; k < spans->room; k++) {
    tp_tilt_init(&more[k].from);
    tp_tilt_init(&more[k].to);
  }
  tp_tilt_span *own = spans->items + spans->count++;
  own->from.endless = own->to.endless = true;
  own->mode = -1;
  return own;
}

static bool is_homogeneous(const tp_trig *f) {
  return arb_is_zero(f->of + TP_ONE) && arb_is_zero(f->of + TP_SEC) && arb_is_zero(f->of + TP_SEC2);
}

static void set_end(tp_tilt *end, const tp_tilt *zero, long root) {
  tp_tilt_set(end, zero);
  end->endless = false;
  end->source.root = root;
}

void tp_tilt_set_zero(tp_tilt *end, const tp_tilt *zero, const arb_t a, const arb_t b, bool rises,
                      long bits) {
  arb_t sine, cosine;
  arb_init(sine);
  arb_init(cosine);
  arb_set(sine, a);
  arb_set(cosine, b);
  if (rises) {
    arb_neg(sine, sine);
  } else {
    arb_neg(cosine, cosine);
  }
  set_end(end, zero, 0);
  tp_ball_atan2_degrees(end->degrees, sine, cosine, bits);
  arb_clear(sine);
  arb_clear(cosine);
}

/* A cos a + B sin a >= 0, where cos a > 0: A + B tan a >= 0. */
static bool of_line(tp_motion_tilts *spans, tp_answer *told, const tp_trig *f, const tp_tilt *zero,
                    double log2_scale, const tp_judge *judge) {
  const int rises = tp_judge_sign(judge, f->of + TP_SIN, log2_scale);
  if (rises == TP_OPEN_SIGN) {
    *told = TP_OPEN;
    return true;
  }
  if (rises == 0) {
    const int level = tp_judge_sign(judge, f->of + TP_COS, log2_scale);
    if (level == TP_OPEN_SIGN) *told = TP_OPEN;
    return level == TP_OPEN_SIGN || level < 0 || tp_tilts_add(spans) != NULL;
  }
  tp_tilt_span *span = tp_tilts_add(spans);
  if (span == NULL) return false;
  tp_tilt *end = rises > 0 ? &span->from : &span->to;
  tp_tilt_set_zero(end, zero, f->of + TP_COS, f->of + TP_SIN, rises > 0, judge->bits);
  return true;
}

/* Sign of f where nothing is tilted. */
static int sign_level(const tp_trig *f, double log2_scale, const tp_judge *judge) {
  arb_t sum;
  arb_init(sum);
  arb_add(sum, f->of + TP_COS, f->of + TP_ONE, judge->bits);
  arb_add(sum, sum, f->of + TP_SEC, judge->bits);
  arb_add(sum, sum, f->of + TP_SEC2, judge->bits);
  const int sign = tp_judge_sign(judge, sum, log2_scale);
  arb_clear(sum);
  return sign;
}

static bool between_roots(tp_motion_tilts *spans, const tp_roots *roots, const tp_tilt *zero) {
  tp_tilt_span *span = NULL;
  if (!roots->rising[0] && (span = tp_tilts_add(spans)) == NULL) return false;
  for (long k = 0; k < roots->count; k++) {
    if (roots->rising[k] && (span = tp_tilts_add(spans)) == NULL) return false;
    if (span == NULL) continue;
    tp_tilt *end = roots->rising[k] ? &span->from : &span->to;
    set_end(end, zero, k);
    arb_set(end->degrees, roots->degrees + k);
  }
  return true;
}

bool tp_tilts_of(tp_motion_tilts *spans, tp_answer *told, const tp_trig *f, const tp_tilt *zero,
                 double log2_scale, const tp_judge *judge) {
  tp_tilts_empty(spans);
  *told = TP_YES;
  if (is_homogeneous(f)) return of_line(spans, told, f, zero, log2_scale, judge);
  tp_roots roots;
  tp_roots_init(&roots);
  tp_roots_find(&roots, f, judge->bits);
  bool done = true;
  if (!roots.certain) {
    *told = TP_OPEN;
  } else if (roots.count > 0) {
    done = between_roots(spans, &roots, zero);
  } else {
    const int level = sign_level(f, log2_scale, judge);
    if (level == TP_OPEN_SIGN || level == 0) *told = TP_OPEN;
    done = level != 1 || tp_tilts_add(spans) != NULL;
  }
  tp_roots_clear(&roots);
  return done;
}

/* The later of two lower ends, the earlier of two upper ones; of two that are one, what both bounds
 * share. Where no more bits will tell, as with a friction that is known to an interval of tilts, a
 * ball that holds it. False where open. */
static bool tighten(tp_tilt *end, const tp_tilt *a, const tp_tilt *b, bool lower,
                    const tp_judge *judge) {
  if (a->endless || b->endless) {
    tp_tilt_set(end, a->endless ? b : a);
    return true;
  }
  const int order = tp_tilt_compare(a, b, judge);
  if (order == TP_OPEN_SIGN && !tp_judge_takes_equal(judge)) return false;
  const bool told = order == 1 || order == -1;
  tp_tilt_set(end, told && (order > 0) == lower ? a : b);
  if (!told) end->rays = a->rays & b->rays;
  if (order == TP_OPEN_SIGN) {
    (lower ? arb_max : arb_min)(end->degrees, a->degrees, b->degrees, judge->bits);
  }
  return true;
}

/* Does anything lie between the ends: a stretch, or a single tilt at which it moves? */
static tp_answer is_something(const tp_tilt_span *span, unsigned rays, const tp_judge *judge) {
  if (span->from.endless || span->to.endless) return TP_YES;
  const int order = tp_tilt_compare(&span->from, &span->to, judge);
  const bool shared = (span->from.rays & span->to.rays & rays) != 0;
  if (order == TP_OPEN_SIGN) return shared && tp_judge_takes_equal(judge) ? TP_YES : TP_OPEN;
  if (order == 0) return shared ? TP_YES : TP_NO;
  return order < 0 ? TP_YES : TP_NO;
}

bool tp_tilts_intersect(tp_motion_tilts *spans, tp_answer *told, const tp_motion_tilts *other,
                        unsigned rays, const tp_judge *judge) {
  tp_motion_tilts both = {0};
  *told = TP_YES;
  bool done = true;
  for (long i = 0; i < spans->count && done && *told == TP_YES; i++) {
    for (long j = 0; j < other->count && done && *told == TP_YES; j++) {
      tp_tilt_span *own = tp_tilts_add(&both);
      done = own != NULL;
      if (!done) break;
      const tp_tilt_span *a = spans->items + i, *b = other->items + j;
      if (!tighten(&own->from, &a->from, &b->from, true, judge) ||
          !tighten(&own->to, &a->to, &b->to, false, judge)) {
        *told = TP_OPEN;
        break;
      }
      const tp_answer something = is_something(own, rays, judge);
      if (something == TP_OPEN) *told = TP_OPEN;
      if (something == TP_NO) both.count--;
    }
  }
  const tp_motion_tilts old = *spans;
  *spans = both;
  both = old;
  tp_tilts_clear(&both);
  return done;
}
