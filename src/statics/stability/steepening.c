/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The windows in which motions can begin (docs/mechanics.md section 6a) come from below. A block
 * that stands lies in none, or at the very beginning of one. */

#include "stability/steepening.h"

#include "output/text.h"

static bool stands(const tp_case *c) {
  return c->mechanism == TP_STANDS || c->mechanism == TP_INTERLOCKED;
}

const tp_window *tp_steepening_window(const tp_solution *s, const tp_case *c) {
  const double tilt = s->tilt_angle_deg.value;
  for (size_t k = 0; k < c->onset.window_count; k++) {
    const tp_window *w = c->onset.windows + k;
    const bool ends_below = !w->to_above && w->to_deg.value < tilt;
    if (!w->from_below && !ends_below) return w;
  }
  return NULL;
}

void tp_solution_steepen(tp_solution *s) {
  for (size_t k = 0; k < s->case_count; k++) {
    tp_case *c = s->cases + k;
    const tp_window *above = tp_steepening_window(s, c);
    c->may_steepen = s->frame.world && s->has_tilt_angle && stands(c) &&
                     c->onset.kind != TP_ONSET_NOT_ASKED && c->onset.kind != TP_ONSET_UNDECIDED &&
                     above != NULL;
    if (!c->may_steepen) continue;
    c->steepen_to_deg = above->from_deg;
    c->steepen_by_deg = tp_text_less(above->from_deg, s->tilt_angle_deg);
  }
}
