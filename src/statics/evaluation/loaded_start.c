/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Where friction depends on the load: from which tilt on a block slides along a facet. */

#include "evaluation/loaded.h"

#include "evaluation/facet_frame.h"
#include "evaluation/friction.h"
#include "number/ball.h"

/* The force along the facet over what resists it, at any of the tilts in a ball, with the friction
 * that their stress gives: wide where that leaps, so the force across is one number before it is
 * multiplied by it. */
static void excess_at(arb_t excess, const tp_loaded *loaded, const tp_evaluation *e,
                      tp_facet_frame *f, const arb_t degrees) {
  const long bits = e->rung.bits;
  tp_trig along, normal;
  arb_t friction, sine, cosine, pressing;
  tp_trig_init(&along);
  tp_trig_init(&normal);
  arb_init(friction);
  arb_init(sine);
  arb_init(cosine);
  arb_init(pressing);
  tp_facet_frame_resolve(&along, &normal, &loaded->sum, f, bits);
  tp_ball_sin_cos(sine, cosine, degrees, bits);
  tp_friction_at(friction, e, degrees);
  tp_friction_tangent(f->friction, friction, bits);
  tp_trig_evaluate(excess, &along, sine, cosine, bits);
  tp_trig_evaluate(pressing, &normal, sine, cosine, bits);
  arb_submul(excess, pressing, f->friction, bits);
  arb_sub(excess, excess, f->cohesion, bits);
  tp_trig_clear(&along);
  tp_trig_clear(&normal);
  arb_clear(friction);
  arb_clear(sine);
  arb_clear(cosine);
  arb_clear(pressing);
}

/* From level on the excess has the sign `own` up to `kept`: below zero, it holds. */
typedef struct stretch {
  const tp_loaded *loaded;
  const tp_evaluation *e;
  tp_facet_frame frame;
  int own;
  slong least; /* the start is to be known to 2^least degrees */
  arf_t kept, step, last;
} stretch;

enum { SPARE_DIGITS = 8 };

static void stretch_init(stretch *s, const tp_loaded *loaded, const tp_evaluation *e,
                         const fmpz_t run, const fmpz_t rise) {
  arb_t level, excess;
  arb_init(level);
  arb_init(excess);
  arf_init(s->kept);
  arf_init(s->step);
  arf_init(s->last);
  s->loaded = loaded;
  s->e = e;
  s->least = -(slong)tp_digits_bits(e->digits + SPARE_DIGITS);
  tp_facet_frame_init(&s->frame, e, run, rise, level);
  excess_at(excess, loaded, e, &s->frame, level);
  s->own = tp_ball_sign(excess);
  arf_set_d(s->last, s->own > 0 ? -loaded->range_deg : loaded->range_deg);
  arf_set_si(s->step, s->own > 0 ? -1 : 1);
  arb_clear(level);
  arb_clear(excess);
}

static void stretch_clear(stretch *s) {
  tp_facet_frame_clear(&s->frame);
  arf_clear(s->kept);
  arf_clear(s->step);
  arf_clear(s->last);
}

/* One step on, not beyond the last tilt; and the tilts from `kept` to there. */
static void set_end(arf_t end, arb_t between, const stretch *s) {
  const long bits = s->e->rung.bits;
  arf_add(end, s->kept, s->step, bits, ARF_RND_NEAR);
  if (arf_cmpabs(end, s->last) > 0) arf_set(end, s->last);
  arb_set_interval_arf(between, s->own < 0 ? s->kept : end, s->own < 0 ? end : s->kept, bits);
}

static int sign_at(stretch *s, const arb_t degrees) {
  arb_t excess;
  arb_init(excess);
  excess_at(excess, s->loaded, s->e, &s->frame, degrees);
  const int sign = tp_ball_sign(excess);
  arb_clear(excess);
  return sign;
}

/* Might a shorter step still prove more, or tell the friction better? A leap of that never ends. */
static bool is_too_long(const stretch *s) {
  enum { ROUNDING_BITS = 16 };
  return arf_cmpabs_2exp_si(s->step, ROUNDING_BITS - s->e->rung.bits) > 0 &&
         (arf_cmpabs_2exp_si(s->step, s->least) > 0 ||
          mag_cmp_2exp_si(arb_radref(s->frame.friction), s->least + SPARE_DIGITS) > 0);
}

/* The start within a step; where that ends at a leap as near as can be told within twice it, and so
 * on. Upright the excess may touch zero: no change. */
static tp_loaded_start start_behind(arb_t degrees, stretch *s) {
  arf_t end;
  arb_t at;
  arf_init(end);
  arb_init(at);
  int sign = 0;
  for (; sign == 0 && arf_cmpabs_2exp_si(s->step, s->least) <= 0;
       arf_mul_2exp_si(s->step, s->step, 1)) {
    set_end(end, degrees, s);
    arb_set_arf(at, end);
    sign = sign_at(s, at);
  }
  tp_loaded_start found = TP_START_OPEN;
  if (sign == -s->own) {
    found = TP_START_AT_ANGLE;
  } else if (arf_equal(end, s->last)) {
    found = s->own < 0 ? TP_START_NEVER : TP_START_ALWAYS;
  }
  arf_clear(end);
  arb_clear(at);
  return found;
}

/* From level the stretch on which the excess keeps its sign is made longer, by steps as long as
 * they prove it, until they and the friction on them are known well enough: behind the last one it
 * changes. */
tp_loaded_start tp_loaded_sliding_start(arb_t degrees, const tp_loaded *loaded,
                                        const tp_evaluation *e, const fmpz_t run,
                                        const fmpz_t rise) {
  enum { MOST_STEPS = 40000 };
  stretch s;
  arf_t end;
  arb_t between;
  arf_init(end);
  arb_init(between);
  stretch_init(&s, loaded, e, run, rise);
  tp_loaded_start found = TP_START_OPEN;
  for (int k = 0; k < MOST_STEPS && s.own != 0; k++) {
    set_end(end, between, &s);
    if (sign_at(&s, between) == s.own) {
      arf_set(s.kept, end);
      arf_mul_2exp_si(s.step, s.step, 1);
      if (!arf_equal(end, s.last)) continue;
      found = s.own < 0 ? TP_START_NEVER : TP_START_ALWAYS;
      break;
    }
    if (!is_too_long(&s)) {
      found = start_behind(degrees, &s);
      break;
    }
    arf_mul_2exp_si(s.step, s.step, -1);
  }
  stretch_clear(&s);
  arf_clear(end);
  arb_clear(between);
  return found;
}
