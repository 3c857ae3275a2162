/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Scan of a range at 512 points, once more over the part with answers where that is narrow: changes
 * of side between neighbours are handed to find_level.h, ends of the domain are bisected.
 *
 * Between points: the domain ends at a yes or a no. The nearest value is looked for by golden
 * section, not by Brent's method with its parabolas: it lies, as a rule, in a kink, where one pivot
 * or mechanism takes over from another, and that method stops 10^-8 of the number before it. */

#include "back_analysis/find_search.h"

#include "back_analysis/find_level.h"
#include "common/message.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The last point with an answer between one that has some and one that has none. */
static tp_sample domain_edge(tp_search *s, tp_sample inside, tp_sample outside) {
  enum { STEPS = 200 };
  for (int k = 0; k < STEPS && s->status == TP_OK; k++) {
    const double x = inside.x + (outside.x - inside.x) / 2;
    if (x == inside.x || x == outside.x) break;
    if (fabs(outside.x - inside.x) < s->close * fmax(fabs(x), fabs(s->own))) break;
    const tp_sample middle = tp_search_sample(s, x);
    if (middle.known) {
      inside = middle;
    } else {
      outside = middle;
    }
  }
  return inside;
}

/* Three points in a row on one side, the middle one nearest to the wanted value: by golden section
 * to the nearest between them, which may touch the value, or lie beyond it. */
static void descend(tp_search *s, tp_sample low, tp_sample middle, tp_sample high) {
  enum { MOST_SAMPLES = 64 };
  static const double golden = 0.38196601125010515; /* (3 - sqrt(5)) / 2 */
  const int own = tp_search_side(&middle);
  for (int k = 0; k < MOST_SAMPLES && s->status == TP_OK; k++) {
    const bool right = high.x - middle.x > middle.x - low.x;
    const double x = middle.x + golden * (right ? high.x - middle.x : low.x - middle.x);
    if (x <= low.x || x >= high.x || x == middle.x) return;
    const tp_sample next = tp_search_sample(s, x);
    if (!next.known) return;
    if (tp_search_side(&next) == 0) {
      tp_search_level(s, &low, &next, &next, &high);
      return;
    }
    if (tp_search_side(&next) != own) { /* two solutions, closer than the points of the range */
      tp_search_cross(s, low, next);
      if (s->status == TP_OK) tp_search_cross(s, next, high);
      return;
    }
    if (fabs(next.gap.value) < fabs(middle.gap.value)) {
      *(right ? &low : &high) = middle;
      middle = next;
    } else {
      *(right ? &high : &low) = next;
    }
  }
}

static bool is_nearest(const tp_sample *low, const tp_sample *middle, const tp_sample *high) {
  const double own = fabs(middle->gap.value);
  const int side = tp_search_side(middle);
  return side != 0 && tp_search_side(low) == side && tp_search_side(high) == side &&
         own <= fabs(low->gap.value) && own < fabs(high->gap.value);
}

/* Points in a row with an answer, and what lies between them. */
static void search_row(tp_search *s, const tp_sample *row, size_t count) {
  for (size_t k = 0; k < count && s->status == TP_OK; k++) {
    if (tp_search_side(row + k) == 0) {
      const size_t first = k;
      while (k + 1 < count && tp_search_side(row + k + 1) == 0) k++;
      tp_search_level(s, first > 0 ? row + first - 1 : NULL, row + first, row + k,
                      k + 1 < count ? row + k + 1 : NULL);
    } else if (k + 1 < count && tp_search_side(row + k) * tp_search_side(row + k + 1) < 0) {
      tp_search_cross(s, row[k], row[k + 1]);
    } else if (k > 0 && k + 1 < count && is_nearest(row + k - 1, row + k, row + k + 1)) {
      descend(s, row[k - 1], row[k], row[k + 1]);
    }
  }
}

/* A row as it grows, and the ends of all rows. */
typedef struct rows {
  tp_sample row[TP_SEARCH_POINTS + 2];
  size_t count;
  bool any;
  double first, last;
} rows;

static void end_row(tp_search *s, rows *r) {
  if (r->count == 0) return;
  if (!r->any) r->first = r->row[0].x;
  r->any = true;
  r->last = r->row[r->count - 1].x;
  search_row(s, r->row, r->count);
  r->count = 0;
}

static void sample_all(tp_search *s, rows *r) {
  const tp_found *found = s->found;
  tp_sample last = {0};
  for (int k = 0; k < s->points && s->status == TP_OK; k++) {
    const tp_sample next =
        tp_search_sample(s, k == s->points - 1 ? found->high : found->low + k * s->step);
    if (k > 0 && last.known && !next.known) { /* the domain ends between them */
      const tp_sample edge = domain_edge(s, last, next);
      if (edge.x > last.x) r->row[r->count++] = edge;
      end_row(s, r);
    } else if (next.known) {
      if (k > 0 && !last.known) {
        const tp_sample edge = domain_edge(s, next, last);
        if (edge.x < next.x) r->row[r->count++] = edge;
      }
      r->row[r->count++] = next;
    }
    last = next;
  }
  if (s->status == TP_OK) end_row(s, r);
}

/* Forget what was found. */
static void start_again(tp_search *s, rows *r) {
  tp_found *found = s->found;
  found->count = found->touching_count = found->interval_count = 0;
  found->low = r->first;
  found->high = r->last;
  *r = (rows){.count = 0};
}

void tp_search_scan(tp_search *s) {
  tp_found *found = s->found;
  const double width = found->high - found->low;
  rows *r = calloc(1, sizeof *r);
  if (r == NULL) {
    s->status = tp_fail_memory(s->message, "the points of the range");
    return;
  }
  s->step = width / (s->points - 1);
  sample_all(s, r);
  if (s->status == TP_OK && r->any && r->last > r->first && r->last - r->first < width / 2) {
    start_again(s, r); /* few of the points had an answer */
    s->step = (found->high - found->low) / (s->points - 1);
    sample_all(s, r);
  }
  if (s->status == TP_OK && !r->any) {
    s->status =
        tp_fail(s->message, TP_NO_ANSWER, tp_scene_key_place(s->varied.keys, s->varied.scene),
                "nowhere from %g to %g the scene has a %s; %s", found->low, found->high,
                tp_find_target_name(s->options->target),
                s->why.text[0] != '\0' ? s->why.text
                : s->of_many           ? "it is unbounded there, or not known"
                                       : "the block does not begin to move there");
  } else if (s->status == TP_OK) {
    found->low = r->first;
    found->high = r->last;
  }
  free(r);
}
