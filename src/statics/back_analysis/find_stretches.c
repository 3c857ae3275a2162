/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* All numbers that were tried, in order: a row of them at which the result is certain to be above
 * the wanted value is a stretch. What ends it is a number at which that is not certain, or at which
 * the scene has no result. Bisection has narrowed what lies between a stretch and its neighbour:
 * where that is certain to be below, the value is passed there. A factor that is unbounded is above
 * any value. */

#include "back_analysis/find_stretches.h"

#include "common/grow.h"
#include "common/message.h"

#include <stdlib.h>

static bool is_certain(const tp_tried *own) {
  return own->standing == TP_TRIED_ABOVE || own->standing == TP_TRIED_BELOW;
}

/* By number; of those at the same number, tried with fewer and with more digits, a certain one
 * first. */
static int compare(const void *left, const void *right) {
  const tp_tried *a = left, *b = right;
  if (a->x != b->x) return a->x < b->x ? -1 : 1;
  return (int)is_certain(b) - (int)is_certain(a);
}

static void sort(tp_search *s) {
  long kept = 0;
  qsort(s->tried, (size_t)s->tried_count, sizeof *s->tried, compare);
  for (long k = 0; k < s->tried_count; k++) {
    if (kept == 0 || s->tried[kept - 1].x != s->tried[k].x) s->tried[kept++] = s->tried[k];
  }
  s->tried_count = kept;
}

/* From a number on, stepping by `way`, the first that is told from the wanted value, is it below?
 * false too where the scene has no result before that, or the range ends. */
static bool is_below_beyond(const tp_search *s, long from, int way) {
  for (long k = from; k >= 0 && k < s->tried_count; k += way) {
    if (s->tried[k].standing != TP_TRIED_NEAR) return s->tried[k].standing == TP_TRIED_BELOW;
  }
  return false;
}

void tp_search_stretches(tp_search *s) {
  tp_found *f = s->found;
  long room = 0;
  if (s->tried_count == 0) return;
  sort(s);
  for (long first = 0, last; first < s->tried_count; first = last + 1) {
    last = first;
    if (s->tried[first].standing != TP_TRIED_ABOVE) continue;
    while (last + 1 < s->tried_count && s->tried[last + 1].standing == TP_TRIED_ABOVE) last++;
    tp_found_stretch *all = tp_grow(f->at_least, (long)f->at_least_count, &room, sizeof *all);
    if (all == NULL) {
      s->status = tp_fail_memory(s->message, "the solutions");
      return;
    }
    f->at_least = all;
    all[f->at_least_count++] = (tp_found_stretch){.low = s->tried[first].x,
                                                  .high = s->tried[last].x,
                                                  .begins = is_below_beyond(s, first - 1, -1),
                                                  .ends = is_below_beyond(s, last + 1, 1)};
  }
}
