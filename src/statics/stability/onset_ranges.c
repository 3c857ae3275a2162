/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Windows of each mechanism separately, their ends sorted into classes of equal tilts, and the set
 * of mechanisms possible between neighbouring classes (docs/mechanics.md section 6a). */

#include "stability/onset_ranges.h"

#include "stability/friction.h"

#include <stdlib.h>
#include <string.h>

static const tp_mechanism movers[] = {TP_SLIDES, TP_TOPPLES, TP_SLIDES_AND_TOPPLES, TP_LEAVES_BASE};
enum { MOVERS = sizeof movers / sizeof movers[0] };

/* An end of a window of one mechanism. Ends of one class are the same tilt; classes rise from 1. */
typedef struct window_end {
  const tp_tilt *tilt;
  long class_number;
} window_end;

typedef struct ranging {
  const tp_onset_telling *t;
  tp_motion_windows windows[MOVERS];
  long count, classes;
  window_end *ends;
} ranging;

/* The windows of the modes of one mechanism. */
static tp_motion_outcome find_windows(tp_motion_windows *windows, const tp_onset_telling *t,
                                      tp_mechanism mechanism) {
  tp_motions part = *t->motions; /* shares all but the list of spans */
  part.spans.items = calloc((size_t)part.spans.count + 1, sizeof *part.spans.items);
  if (part.spans.items == NULL) return TP_MOTION_OUT_OF_MEMORY;
  part.spans.count = 0;
  for (long k = 0; k < t->motions->spans.count; k++) {
    const tp_tilt_span *own = t->motions->spans.items + k;
    if (part.modes[own->mode].mechanism == mechanism) part.spans.items[part.spans.count++] = *own;
  }
  const tp_motion_outcome done = tp_windows_init(windows, &part, &t->question->judge);
  free(part.spans.items);
  return done;
}

/* An order of search, proven by what follows. */
static int by_tilt(const void *left, const void *right) {
  const window_end *a = left, *b = right;
  return arf_cmp(arb_midref(a->tilt->degrees), arb_midref(b->tilt->degrees));
}

static tp_motion_outcome sort_ends(ranging *r) {
  long room = 1;
  for (int k = 0; k < MOVERS; k++) room += 2 * r->windows[k].count;
  r->ends = calloc((size_t)room, sizeof *r->ends);
  if (r->ends == NULL) return TP_MOTION_OUT_OF_MEMORY;
  for (int k = 0; k < MOVERS; k++) {
    for (long w = 0; w < r->windows[k].count; w++) {
      const tp_motion_window *own = r->windows[k].items + w;
      if (!own->from.endless) r->ends[r->count++].tilt = &own->from;
      if (!own->to.endless) r->ends[r->count++].tilt = &own->to;
    }
  }
  qsort(r->ends, (size_t)r->count, sizeof *r->ends, by_tilt);
  for (long k = 0; k < r->count; k++) {
    const int order =
        k == 0 ? 1 : tp_tilt_compare(r->ends[k].tilt, r->ends[k - 1].tilt, &r->t->question->judge);
    if (order == TP_OPEN_SIGN) return TP_MOTION_OPEN;
    if (order != 0) r->classes++;
    r->ends[k].class_number = r->classes;
  }
  return TP_MOTION_PROVEN;
}

/* Without an end: 0 below all, one past the last above all. */
static long class_of(const ranging *r, const tp_tilt *tilt, bool is_upper) {
  if (tilt->endless) return is_upper ? r->classes + 1 : 0;
  long k = 0;
  while (r->ends[k].tilt != tilt) k++;
  return r->ends[k].class_number;
}

/* motions[c]: what can begin between class c and the next. */
static void collect(unsigned *motions, const ranging *r) {
  for (int k = 0; k < MOVERS; k++) {
    for (long w = 0; w < r->windows[k].count; w++) {
      const tp_motion_window *own = r->windows[k].items + w;
      const long to = class_of(r, &own->to, true);
      for (long c = class_of(r, &own->from, false); c < to; c++) motions[c] |= 1U << movers[k];
    }
  }
}

static tp_bounded tilt_of(const ranging *r, long class_number) {
  long k = 0;
  while (r->ends[k].class_number != class_number) k++;
  return tp_result(r->t->e, r->ends[k].tilt->degrees, r->t->certainty);
}

static void tell(tp_onset *onset, const ranging *r, const unsigned *motions) {
  for (long c = 0, next; c <= r->classes; c = next) {
    for (next = c + 1; next <= r->classes && motions[next] == motions[c];) next++;
    if (motions[c] == 0) continue;
    tp_motion_range *own = onset->ranges + onset->range_count++;
    *own = (tp_motion_range){
        .from_below = c == 0, .to_above = next > r->classes, .motions = motions[c]};
    if (!own->from_below) own->from_deg = tilt_of(r, c);
    if (!own->to_above) own->to_deg = tilt_of(r, next);
  }
  onset->has_ranges = true;
}

tp_motion_outcome tp_onset_ranges(const tp_onset_telling *t) {
  tp_onset *onset = &t->result->onset;
  if (t->question->strong != NULL || tp_friction_is_load_dependent(t->e)) return TP_MOTION_PROVEN;
  ranging r = {.t = t};
  tp_motion_outcome done = TP_MOTION_PROVEN;
  for (int k = 0; k < MOVERS && done == TP_MOTION_PROVEN; k++) {
    done = find_windows(r.windows + k, t, movers[k]);
  }
  if (done == TP_MOTION_PROVEN) done = sort_ends(&r);
  unsigned *motions = calloc((size_t)r.classes + 1, sizeof *motions);
  onset->ranges = calloc((size_t)r.classes + 1, sizeof *onset->ranges);
  if (motions == NULL || onset->ranges == NULL) done = TP_MOTION_OUT_OF_MEMORY;
  if (done == TP_MOTION_PROVEN) {
    collect(motions, &r);
    tell(onset, &r, motions);
  }
  free(motions);
  free(r.ends);
  for (int k = 0; k < MOVERS; k++) tp_windows_clear(r.windows + k);
  return done;
}
