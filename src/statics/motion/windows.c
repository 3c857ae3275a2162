/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Union of the spans of all modes, sorted by lower end; the mechanisms at both ends of each window
 * are those of the modes that reach them. Gaps that are not proven are closed, the safe side. */

#include "motion/windows.h"

#include <stdlib.h>
#include <string.h>

void tp_windows_clear(tp_motion_windows *w) {
  for (long k = 0; k < w->count; k++) {
    tp_tilt_clear(&w->items[k].from);
    tp_tilt_clear(&w->items[k].to);
  }
  free(w->items);
  memset(w, 0, sizeof *w);
}

/* By lower ends; an order of search, proven by what follows. */
static int by_lower_end(const void *left, const void *right) {
  const tp_tilt_span *a = *(const tp_tilt_span *const *)left,
                     *b = *(const tp_tilt_span *const *)right;
  if (a->from.endless || b->from.endless) return (int)b->from.endless - (int)a->from.endless;
  const int order = arf_cmp(arb_midref(a->from.degrees), arb_midref(b->from.degrees));
  return order != 0 ? order : (a->mode > b->mode) - (a->mode < b->mode);
}

/* A lower end where another span begins as near as can be told: a ball that holds the less. */
static void extend_down(tp_tilt *from, const tp_tilt *other, const tp_judge *judge) {
  if (from->endless || other->endless) return;
  if (tp_tilt_compare(other, from, judge) != TP_OPEN_SIGN) return;
  arb_min(from->degrees, from->degrees, other->degrees, judge->bits);
}

/* The larger of two upper ends. Where their order is open, a ball that holds it, with the source of
 * one that it does not lie below. */
static void extend(tp_tilt *to, const tp_tilt *other, const tp_judge *judge) {
  if (to->endless) return;
  if (other->endless) {
    to->endless = true;
    return;
  }
  const int order = tp_tilt_compare(other, to, judge);
  if (order == 1) tp_tilt_set(to, other);
  if (order == TP_OPEN_SIGN) arb_max(to->degrees, to->degrees, other->degrees, judge->bits);
}

/* Does the span begin beyond what is put together so far? Where no more bits will tell, as with a
 * friction that is known to an interval of tilts, the cautious reading: it does not. */
static tp_answer lies_beyond(const tp_tilt_span *span, const tp_tilt *to, const tp_judge *judge) {
  if (to->endless || span->from.endless) return TP_NO;
  const int order = tp_tilt_compare(&span->from, to, judge);
  if (order == TP_OPEN_SIGN) return tp_judge_takes_equal(judge) ? TP_NO : TP_OPEN;
  return order > 0 ? TP_YES : TP_NO;
}

/* What moves at the end of a span: of a mode of two rays the one whose plane bounds it there. */
static tp_motion_outcome describe(tp_motion_window *w, const tp_motions *m,
                                  const tp_tilt_span *span, const tp_tilt *end) {
  const tp_motion_mode *mode = m->modes + span->mode;
  w->mechanism = mode->mechanism;
  w->has_ray = mode->ray_count == 1;
  w->ray = mode->rays[0];
  if (mode->ray_count != 2 || end->endless || (end->rays != 1 && end->rays != 2)) {
    return TP_MOTION_PROVEN;
  }
  w->has_ray = true;
  w->ray = mode->rays[end->rays == 1 ? 0 : 1];
  return tp_strata_mechanism(&w->mechanism, &m->twists, &m->normals, w->ray);
}

/* Does an end of the span end the window there, too? Where no more bits will tell, it does. */
static tp_answer shares_end(const tp_tilt *end, const tp_tilt *own, const tp_judge *judge) {
  if (end->endless || own->endless) return end->endless == own->endless ? TP_YES : TP_NO;
  const int order = tp_tilt_compare(end, own, judge);
  if (order == TP_OPEN_SIGN) return tp_judge_takes_equal(judge) ? TP_YES : TP_OPEN;
  return order == 0 ? TP_YES : TP_NO;
}

/* Is the motion named before another that begins at the same tilt? That of one ray before a mode of
 * two, of which it is a part; of several the first mode. */
static bool goes_first(const tp_motion_window *named, const tp_motion_window *other,
                       const tp_tilt_span *spans) {
  if (named->begins < 0) return false;
  if (named->has_ray != other->has_ray) return named->has_ray;
  return spans[named->begins].mode <= spans[other->begins].mode;
}

/* Motions about different points are different, whatever they are called. */
static bool ties_with(const tp_motion_window *named, const tp_motion_window *other) {
  return other->has_ray == named->has_ray &&
         (other->mechanism != named->mechanism || (named->has_ray && other->ray != named->ray));
}

/* Of the spans that share the end of a window, the one that is named; and whether another motion
 * begins there. */
static tp_motion_outcome name(tp_motion_window *w, const tp_motions *m, tp_tilt_span *const *spans,
                              long count, const tp_judge *judge) {
  const bool upper = w->from.endless;
  const tp_tilt *own = upper ? &w->to : &w->from;
  w->begins = -1;
  bool named_exactly = false;
  for (int round = 0; round < 2; round++) {
    for (long k = 0; k < count; k++) {
      const tp_tilt *end = upper ? &spans[k]->to : &spans[k]->from;
      const tp_answer shares = shares_end(end, own, judge);
      if (shares == TP_OPEN) return TP_MOTION_OPEN;
      if (shares == TP_NO) continue;
      tp_motion_window other = {.begins = spans[k] - m->spans.items};
      const tp_motion_outcome done = describe(&other, m, spans[k], end);
      if (done != TP_MOTION_PROVEN) return done;
      if (round == 0 && !goes_first(w, &other, m->spans.items)) {
        w->begins = other.begins;
        w->has_ray = other.has_ray;
        w->ray = other.ray;
        w->mechanism = other.mechanism;
        named_exactly = tp_tilt_is_same(end, own);
      }
      if (round == 1 && ties_with(w, &other)) {
        const bool exact = named_exactly && tp_tilt_is_same(end, own);
        if (w->tie && w->tie_exact && !exact) continue;
        w->tie = true;
        w->tie_exact = exact;
        w->tied_with = other.mechanism;
      }
    }
  }
  return TP_MOTION_PROVEN;
}

static tp_motion_outcome merge(tp_motion_windows *w, const tp_motions *m, tp_tilt_span **spans,
                               const tp_judge *judge) {
  const long count = m->spans.count;
  for (long k = 0; k < count;) {
    tp_motion_window *own = w->items + w->count++;
    tp_tilt_set(&own->from, &spans[k]->from);
    tp_tilt_set(&own->to, &spans[k]->to);
    const long first = k++;
    for (; k < count; k++) {
      const tp_answer beyond = lies_beyond(spans[k], &own->to, judge);
      if (beyond == TP_OPEN) return TP_MOTION_OPEN;
      if (beyond == TP_YES) break;
      extend_down(&own->from, &spans[k]->from, judge);
      extend(&own->to, &spans[k]->to, judge);
    }
    const tp_motion_outcome named = name(own, m, spans + first, k - first, judge);
    if (named != TP_MOTION_PROVEN) return named;
  }
  return TP_MOTION_PROVEN;
}

tp_motion_outcome tp_windows_init(tp_motion_windows *w, const tp_motions *m,
                                  const tp_judge *judge) {
  memset(w, 0, sizeof *w);
  tp_tilt_span **spans = calloc((size_t)m->spans.count + 1, sizeof *spans);
  w->items = calloc((size_t)m->spans.count + 1, sizeof *w->items);
  tp_motion_outcome done = TP_MOTION_OUT_OF_MEMORY;
  if (spans != NULL && w->items != NULL) {
    for (long k = 0; k < m->spans.count; k++) {
      spans[k] = m->spans.items + k;
      tp_tilt_init(&w->items[k].from);
      tp_tilt_init(&w->items[k].to);
    }
    qsort(spans, (size_t)m->spans.count, sizeof *spans, by_lower_end);
    done = merge(w, m, spans, judge);
    for (long k = w->count; k < m->spans.count; k++) {
      tp_tilt_clear(&w->items[k].from);
      tp_tilt_clear(&w->items[k].to);
    }
  }
  free(spans);
  if (done != TP_MOTION_PROVEN) tp_windows_clear(w);
  return done;
}

static tp_answer lies_between(const tp_tilt *from, const tp_tilt *to, const arb_t degrees) {
  if ((!from->endless && arb_lt(degrees, from->degrees)) ||
      (!to->endless && arb_gt(degrees, to->degrees))) {
    return TP_NO;
  }
  const bool above = from->endless || arb_le(from->degrees, degrees);
  const bool below = to->endless || arb_le(degrees, to->degrees);
  return above && below ? TP_YES : TP_OPEN;
}

tp_answer tp_window_holds(const tp_motion_window *w, const arb_t degrees) {
  return lies_between(&w->from, &w->to, degrees);
}

tp_answer tp_tilt_span_holds(const tp_tilt_span *span, const arb_t degrees) {
  return lies_between(&span->from, &span->to, degrees);
}
