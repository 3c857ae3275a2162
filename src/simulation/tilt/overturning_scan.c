/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Factors on the scene's shaking that overturn the block: runs on a grid from 1/16 to 16, a finer
 * one below the least that overturns, bisection of each change, and the ranges found. */

#include "common/grow.h"
#include "common/message.h"
#include "tilt/cost.h"
#include "tilt/overturning.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Of the default grid: factors, and how many an octave below the least that overturns. */
static const double weakest = 1.0 / 16, strongest = 16;
enum { COARSE = 65, FINE_AN_OCTAVE = 128 };
/* To which a change is narrowed, as a share. */
static const double tolerance = 1e-3;

typedef struct tried {
  double factor;
  bool overturned;
} tried;

typedef struct scan {
  tp_overturning own;
  tp_tilt_case *found;
  tried *all; /* in their order, once they are sorted */
  long count, room;
  tp_message *message;
} scan;

static int by_factor(const void *a, const void *b) {
  const double x = ((const tried *)a)->factor, y = ((const tried *)b)->factor;
  return (x > y) - (x < y);
}

/* Runs it; `*went_on`: the run was decided. */
static tp_status try_factor(scan *s, double factor, bool *went_on) {
  tp_tilt_verdict verdict = TP_VERDICT_OPEN;
  tried *grown = tp_grow(s->all, s->count, &s->room, sizeof *s->all);
  *went_on = false;
  if (grown == NULL) return tp_fail_memory(s->message, "the factors tried");
  s->all = grown;
  const tp_status status = tp_overturning_look(&verdict, &s->own, factor);
  *went_on = status == TP_OK && s->found->converged;
  if (*went_on) s->all[s->count++] = (tried){factor, verdict == TP_VERDICT_MOVES};
  return status;
}

static bool least_overturning(double *least, const scan *s) {
  *least = INFINITY;
  for (long k = 0; k < s->count; k++) {
    if (s->all[k].overturned) *least = fmin(*least, s->all[k].factor);
  }
  return isfinite(*least);
}

/* ---- the grids ---------------------------------------------------------------------------------
 */

/* From the weakest up; what is told are the factors that were decided. */
static tp_status scan_range(scan *s, double from, double to, size_t count) {
  tp_overturning_grid *grid = s->found->overturning_tried + s->found->overturning_tried_count;
  bool went_on = true;
  tp_status status = TP_OK;
  *grid = (tp_overturning_grid){.least = from, .most = from};
  for (size_t k = 0; k < count && went_on && status == TP_OK; k++) {
    const double factor =
        k + 1 == count ? to : from * pow(to / from, (double)k / (double)(count - 1));
    status = try_factor(s, factor, &went_on);
    if (!went_on) break;
    grid->most = factor;
    grid->count++;
  }
  if (grid->count > 0) s->found->overturning_tried_count++;
  return status;
}

/* Below the least that overturns, from there down. */
static tp_status scan_below(scan *s) {
  tp_overturning_grid *grid = s->found->overturning_tried + s->found->overturning_tried_count;
  const double step = exp2(-1.0 / FINE_AN_OCTAVE);
  double least = 0;
  bool went_on = true;
  tp_status status = TP_OK;
  if (!s->found->converged || !least_overturning(&least, s)) return TP_OK;
  *grid = (tp_overturning_grid){.least = least, .most = least, .count = 1};
  for (;;) {
    const double factor = grid->most * pow(step, (double)grid->count);
    if (factor < weakest || factor < 0.499 * least) break;
    status = try_factor(s, factor, &went_on);
    if (!went_on) break;
    if (s->all[s->count - 1].overturned) least = factor;
    grid->least = factor;
    grid->count++;
  }
  if (grid->count > 1) s->found->overturning_tried_count++;
  return status;
}

/* ---- ranges ------------------------------------------------------------------------------------
 */

/* Halves what lies between any two neighbours of which one spares it, until all are narrow. */
static tp_status narrow(scan *s) {
  tp_status status = TP_OK;
  bool wide = true, went_on = s->found->converged;
  while (wide && went_on && status == TP_OK) {
    const long known = s->count;
    wide = false;
    for (long k = 0; k + 1 < known && went_on && status == TP_OK; k++) {
      const double low = s->all[k].factor, high = s->all[k + 1].factor;
      if (s->all[k].overturned == s->all[k + 1].overturned) continue;
      if (high - low <= tolerance * high) continue;
      wide = true;
      status = try_factor(s, 0.5 * (low + high), &went_on);
    }
    qsort(s->all, (size_t)s->count, sizeof *s->all, by_factor);
  }
  return status;
}

static tp_status take_ranges(scan *s) {
  tp_tilt_case *own = s->found;
  own->overturning_ranges = calloc((size_t)s->count + 1, sizeof *own->overturning_ranges);
  if (own->overturning_ranges == NULL) return tp_fail_memory(s->message, "what overturns");
  for (long k = 0; k < s->count; k++) {
    if (!s->all[k].overturned) continue;
    tp_overturning_range *range = own->overturning_ranges + own->overturning_range_count++;
    *range = (tp_overturning_range){k > 0 ? s->all[k - 1].factor : NAN, s->all[k].factor,
                                    s->all[k].factor, NAN};
    while (k < s->count && s->all[k].overturned) range->most = s->all[k++].factor;
    if (k < s->count) range->spared_above = s->all[k].factor;
  }
  own->has_overturning = own->overturning_range_count > 0;
  if (own->has_overturning) {
    const tp_overturning_range *first = own->overturning_ranges;
    own->spared_by = isnan(first->spared_below) ? 0 : first->spared_below;
    own->overturned_by = first->least;
  }
  return TP_OK;
}

tp_status tp_overturning_check(const tp_tilt_options *options, tp_message *message) {
  enum { MOST = 100000 };
  const double from = options->overturning_from, to = options->overturning_to;
  const size_t count = options->overturning_count;
  if (options->smaller_count > MOST) {
    return tp_refuse(message, TP_FAULT_RANGE, (tp_place){0},
                     "smaller factors on the shaking are at most %d", MOST);
  }
  if (count == 0 && from == 0 && to == 0) return TP_OK;
  if (from > 0 && from < to && isfinite(to) && count >= 2 && count <= MOST) return TP_OK;
  return tp_refuse(message, TP_FAULT_RANGE, (tp_place){0},
                   "the factors on the shaking are 2 to %d, from one above 0 to a larger one; all "
                   "three 0 for those of the default",
                   MOST);
}

tp_status tp_tilting_overturning(tp_tilting *tilting, tp_base_shaking *shaking) {
  const tp_tilt_options *o = tilting->options;
  scan s = {.own = {tilting, shaking}, .found = tilting->own, .message = tilting->message};
  const bool given = o->overturning_count > 0;
  s.found->overturning_scanned = true;
  tilting->search = tp_tilting_search_budgets(o->overturning_count);
  tp_status status =
      given ? scan_range(&s, o->overturning_from, o->overturning_to, o->overturning_count)
            : scan_range(&s, weakest, strongest, COARSE);
  if (status == TP_OK && !given) status = scan_below(&s);
  if (s.count > 0) qsort(s.all, (size_t)s.count, sizeof *s.all, by_factor);
  if (status == TP_OK) status = narrow(&s);
  if (status == TP_OK) status = take_ranges(&s);
  shaking->factor = 1;
  free(s.all);
  return status;
}

tp_status tp_tilting_overturning_below(tp_tilting *tilting, tp_base_shaking *shaking) {
  scan s = {.own = {tilting, shaking}, .found = tilting->own, .message = tilting->message};
  tp_overturning_grid *grid = s.found->overturning_tried;
  bool went_on = true;
  tried *first = tp_grow(s.all, s.count, &s.room, sizeof *s.all);
  if (first == NULL) return tp_fail_memory(s.message, "the factors tried");
  s.all = first;
  s.all[s.count++] = (tried){1, false}; /* that was run */
  s.found->overturning_scanned = true;
  tilting->search = 2; /* budgets: the grid fits into one */
  *grid = (tp_overturning_grid){.least = 1, .most = 1, .count = 1};
  tp_status status = TP_OK;
  const size_t count =
      (size_t)fmin((double)tilting->options->smaller_count, tp_tilting_runs_left(tilting));
  for (size_t k = 1; k <= count && went_on && status == TP_OK; k++) {
    const double factor = exp2(-(double)k / (double)count);
    status = try_factor(&s, factor, &went_on);
    if (!went_on) break;
    grid->least = factor;
    grid->count++;
  }
  s.found->overturning_tried_count = 1;
  qsort(s.all, (size_t)s.count, sizeof *s.all, by_factor);
  if (status == TP_OK) status = narrow(&s);
  if (status == TP_OK) status = take_ranges(&s);
  s.found->converged = true; /* the run of the scene's own shaking was decided */
  shaking->factor = 1;
  free(s.all);
  return status;
}
