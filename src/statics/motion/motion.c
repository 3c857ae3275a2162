/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Onset of motion (docs/mechanics.md section 6a): for each mode the tilts that satisfy h . w(alpha)
 * >= 0 for all planes of its cone are intersected, with filters in doubles first, of all planes and
 * of each, and kept as spans. */

#include "motion/motion.h"

#include "common/grow.h"
#include "motion/bounds.h"
#include "motion/tilt_side.h"
#include "number/ball.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

void tp_motions_clear(tp_motions *m) {
  for (long k = 0; k < m->mode_count; k++) free(m->modes[k].edges);
  free(m->modes);
  tp_tilts_clear(&m->spans);
  tp_twists_clear(&m->twists);
  if (m->normals.order != NULL) tp_normals_clear(&m->normals);
  memset(m, 0, sizeof *m);
}

/* What the visit of the modes shares. */
typedef struct collecting {
  tp_motions *m;
  const tp_motion_question *q;
  tp_mode_filter filter;
  tp_bounds bounds;
  tp_strength strength;
  long mode;   /* from 1 on */
  long number; /* tp_strength_number */
  bool bonds_alone;
  tp_motion_tilts own, other; /* of the mode, of one bound */
} collecting;

/* Loads through a point have no moment about it, exactly, where the question knows that. */
static void settle_zeros(tp_trig *f, const tp_source *plane, const tp_motion_question *q) {
  if (q->vanishes == NULL || plane->kind != TP_FROM_SITE) return;
  for (int basis = 0; basis < TP_BASIS; basis++) {
    arb_struct *own = f->of + basis;
    if (!arb_contains_zero(own) || arb_is_zero(own)) continue;
    if (q->vanishes(q->loads, plane->a, basis)) arb_zero(own);
  }
}

/* h . w, and the scale of its terms where the judge may ask for it. */
static double set_work(tp_trig *f, const tp_bound *bound, const tp_motion_question *q) {
  const tp_vector *h = &bound->h;
  const tp_trig *load[] = {&q->load.x, &q->load.y, &q->load.moment};
  double log2_scale = -INFINITY;
  for (int basis = 0; basis < TP_BASIS; basis++) {
    arb_zero(f->of + basis);
    for (int row = 0; row < 3; row++) {
      const arb_struct *own = load[row]->of + basis;
      if (arb_is_zero(own)) continue;
      arb_addmul(f->of + basis, h->of + row, own, q->judge.precision);
      if (!q->judge.settled) continue;
      log2_scale = fmax(log2_scale, tp_ball_log2_above(h->of + row) + tp_ball_log2_above(own));
    }
  }
  settle_zeros(f, &bound->source, q);
  return log2_scale;
}

/* Is it zero at every tilt? */
static tp_answer is_nothing(const tp_trig *f, double log2_scale, const tp_judge *judge) {
  tp_answer nothing = TP_YES;
  for (int basis = 0; basis < TP_BASIS; basis++) {
    const int sign = tp_judge_sign(judge, f->of + basis, log2_scale);
    if (sign == 1 || sign == -1) return TP_NO;
    if (sign == TP_OPEN_SIGN) nothing = TP_OPEN;
  }
  return nothing;
}

/* One bound on the tilts of the mode; `rays` are those that lie in all planes that the loads never
 * leave. */
static tp_motion_outcome apply(collecting *c, const tp_bound *bound, unsigned *rays, bool planes) {
  const tp_judge *judge = &c->q->judge;
  tp_trig f;
  tp_tilt zero;
  tp_trig_init(&f);
  tp_tilt_init(&zero);
  zero.source = bound->source;
  if (c->q->strong != NULL) { /* each mode holds otherwise, but for these */
    const bool shared = c->number > 0 && (bound->ray_and_edge || c->bonds_alone);
    zero.source.mode = shared ? c->number : c->q->cones->count + c->mode;
  }
  zero.rays = bound->rays;
  double log2_scale = set_work(&f, bound, c->q);
  if (!arb_is_zero(bound->held)) {
    arb_struct *capacity = f.of + c->q->capacity_basis;
    arb_sub(capacity, capacity, bound->held, c->q->judge.precision);
    log2_scale = fmax(log2_scale, tp_ball_log2_above(bound->held));
  }
  const tp_answer nothing = is_nothing(&f, log2_scale, judge);
  tp_answer told = nothing == TP_OPEN ? TP_OPEN : TP_YES;
  bool done = true;
  if (planes && nothing == TP_YES) *rays &= bound->rays;
  const tp_answer side = !planes && nothing == TP_NO ? tp_tilts_side(&c->own, &f) : TP_YES;
  if (side == TP_NO) tp_tilts_empty(&c->own);
  if (side == TP_OPEN) {
    done = tp_tilts_of(&c->other, &told, &f, &zero, log2_scale, judge);
    if (done && told == TP_YES) done = tp_tilts_intersect(&c->own, &told, &c->other, *rays, judge);
  }
  tp_trig_clear(&f);
  tp_tilt_clear(&zero);
  if (!done) return TP_MOTION_OUT_OF_MEMORY;
  return told == TP_OPEN ? TP_MOTION_OPEN : TP_MOTION_PROVEN;
}

/* An end with the source, of the spans from one to before another; NULL: none. */
static const tp_tilt *end_of(const tp_motion_tilts *spans, const tp_source *source, long first,
                             long last) {
  for (long k = 2 * first; k < 2 * last; k++) {
    const tp_tilt_span *span = spans->items + k / 2;
    const tp_tilt *end = k % 2 == 0 ? &span->from : &span->to;
    if (!end->endless && tp_source_is_same(&end->source, source)) return end;
  }
  return NULL;
}

/* The first span of a ray or of later ones: those of single rays come first, in their order. */
static long first_of_ray(const tp_motions *m, long ray) {
  long low = 0, high = m->spans.count;
  while (low < high) {
    const long middle = low + (high - low) / 2;
    const tp_motion_mode *mode = m->modes + m->spans.items[middle].mode;
    const bool before = mode->ray_count == 0 || (mode->ray_count == 1 && mode->rays[0] < ray);
    if (before) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return low;
}

/* The same in modes side by side: the last ones, and those of the rays of a face. */
static const tp_tilt *shared_end(const tp_motions *m, const tp_mode *mode,
                                 const tp_source *source) {
  enum { NEIGHBOURS = 4, OF_RAY = 2 };
  const tp_motion_tilts *spans = &m->spans;
  const long count = spans->count;
  const tp_tilt *end = end_of(spans, source, count > NEIGHBOURS ? count - NEIGHBOURS : 0, count);
  for (int k = 0; k < 2 && end == NULL && mode->ray_count == 2; k++) {
    const long first = first_of_ray(m, mode->rays[k]);
    end = end_of(spans, source, first, first + OF_RAY < count ? first + OF_RAY : count);
  }
  return end;
}

/* A plane that doubles have chosen: where A cos + B sin of its loads is zero. Planes at one end are
 * one tilt, of which only what they share counts; so are those of one source in modes side by side.
 */
static tp_motion_outcome apply_chosen(collecting *c, long number, const tp_mode *mode) {
  const tp_bound *bound = c->bounds.items + number;
  tp_tilt *end = bound->lower ? &c->own.items->from : &c->own.items->to;
  if (!end->endless) {
    end->rays &= bound->rays;
    return TP_MOTION_PROVEN;
  }
  const tp_tilt *shared = shared_end(c->m, mode, &bound->source);
  if (shared != NULL) {
    tp_tilt_set(end, shared);
    end->rays = bound->rays;
    return TP_MOTION_PROVEN;
  }
  const tp_motion_outcome done =
      tp_bounds_evaluate(&c->bounds, number, c->q, &c->m->normals, &c->m->twists, mode);
  if (done != TP_MOTION_PROVEN) return done;
  tp_trig f;
  tp_tilt zero;
  tp_trig_init(&f);
  tp_tilt_init(&zero);
  zero.source = bound->source;
  zero.rays = bound->rays;
  set_work(&f, bound, c->q);
  tp_tilt_set_zero(end, &zero, f.of + TP_COS, f.of + TP_SIN, bound->lower, c->q->judge.bits);
  tp_trig_clear(&f);
  tp_tilt_clear(&zero);
  return TP_MOTION_PROVEN;
}

static bool keep_mode(tp_motions *m, const tp_mode *mode) {
  tp_motion_mode *more = tp_grow(m->modes, m->mode_count, &m->mode_room, sizeof *more);
  if (more == NULL) return false;
  m->modes = more;
  tp_motion_mode *own = m->modes + m->mode_count;
  *own = (tp_motion_mode){.mechanism = mode->mechanism,
                          .ray_count = mode->ray_count,
                          .rays = {mode->rays[0], mode->rays[1]},
                          .edge_count = mode->edge_count};
  own->edges = calloc((size_t)mode->edge_count + 1, sizeof *own->edges);
  if (own->edges == NULL) return false;
  for (long k = 0; k < mode->edge_count; k++) own->edges[k] = mode->edges[k];
  m->mode_count++;
  return true;
}

static tp_motion_outcome keep(collecting *c, const tp_mode *mode) {
  tp_motions *m = c->m;
  if (!c->q->keeps_all && !keep_mode(m, mode)) return TP_MOTION_OUT_OF_MEMORY;
  for (long k = 0; k < c->own.count; k++) {
    tp_tilt_span *span = tp_tilts_add(&m->spans);
    if (span == NULL) return TP_MOTION_OUT_OF_MEMORY;
    tp_tilt_set(&span->from, &c->own.items[k].from);
    tp_tilt_set(&span->to, &c->own.items[k].to);
    span->mode = m->mode_count - 1;
  }
  return TP_MOTION_PROVEN;
}

static tp_motion_outcome collect(void *context, const tp_mode *mode) {
  collecting *c = context;
  const tp_motions *m = c->m;
  const bool strong = c->q->strong != NULL;
  tp_motion_outcome done = TP_MOTION_PROVEN;
  c->mode++;
  if (c->q->keeps_all && !keep_mode(c->m, mode)) return TP_MOTION_OUT_OF_MEMORY;
  if (strong) done = tp_strength_find(&c->strength, c->q, &m->normals, &m->twists, mode);
  if (strong && done == TP_MOTION_PROVEN) {
    done = tp_strength_number(&c->number, c->q, &m->normals, &m->twists, mode);
  }
  if (done == TP_MOTION_PROVEN) {
    done = tp_bounds_find(&c->bounds, &c->filter, c->q, &m->normals, &m->twists, mode,
                          strong ? &c->strength : NULL);
  }
  const tp_mode_tilts told = c->bounds.tilts;
  if (done != TP_MOTION_PROVEN || told == TP_TILTS_NONE) return done;
  tp_tilts_empty(&c->own);
  if (tp_tilts_add(&c->own) == NULL) return TP_MOTION_OUT_OF_MEMORY;
  unsigned rays = ~0U;
  for (long k = 0; k < c->bounds.count && done == TP_MOTION_PROVEN && told == TP_TILTS_OPEN; k++) {
    done = apply(c, c->bounds.items + k, &rays, true);
  }
  if (done != TP_MOTION_PROVEN || rays == 0) return done;
  for (long k = 0; k < c->bounds.count && done == TP_MOTION_PROVEN && c->own.count > 0; k++) {
    done = told == TP_TILTS_BETWEEN ? apply_chosen(c, k, mode)
                                    : apply(c, c->bounds.items + k, &rays, false);
  }
  return done == TP_MOTION_PROVEN && c->own.count > 0 ? keep(c, mode) : done;
}

tp_motion_outcome tp_motions_init(tp_motions *m, const tp_motion_question *q) {
  memset(m, 0, sizeof *m);
  tp_motion_outcome done = tp_normals_init(&m->normals, q->cones, &q->judge);
  if (done != TP_MOTION_PROVEN) return done;
  done = tp_twists_init(&m->twists, &m->normals, q->work);
  if (done == TP_MOTION_PROVEN) {
    collecting c = {.m = m, .q = q};
    tp_mode_filter_init(&c.filter, q);
    tp_strength_init(&c.strength);
    c.bonds_alone = q->strong != NULL && tp_strength_bonds_alone(q);
    done = tp_strata_visit(&m->twists, &m->normals, q->strong != NULL, collect, &c);
    tp_bounds_clear(&c.bounds);
    tp_strength_clear(&c.strength);
    tp_tilts_clear(&c.own);
    tp_tilts_clear(&c.other);
  }
  if (done != TP_MOTION_PROVEN) tp_motions_clear(m);
  return done;
}
