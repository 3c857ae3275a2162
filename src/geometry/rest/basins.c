/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Settles the block at evenly spaced shifts, and narrows each border between different endings by
 * bisection and by events (rest/events.h), within a budget of work. */

#include "rest/basins.h"

#include "common/budget.h"
#include "common/grow.h"
#include "common/message.h"
#include "rest/events.h"

#include <stdlib.h>
#include <string.h>

/* Budgets of work: with one spent borders are narrowed no more; with all, it is given up. */
static const double all_budgets = 1.5;

/* Starting positions: as many as make the spacing 1/64 of the block's width, within bounds. */
enum { LOG2_TO_A_WIDTH = 6, LOG2_FEWEST = 8, LOG2_MOST = 11 };

/* Shifts between two neighbours that wait for those left of them: each lies in the one half of its
 * interval, or next to an event; where so many wait, borders stay as wide as they are. */
enum { WAITING = 128 };

typedef struct settled_shift {
  fmpq_t x;
  long ending;
} settled_shift;

typedef struct tracer {
  tp_basins *basins;
  tp_settling *settling;
  fmpq_t beside; /* how far from an event it is tried on both sides */
  settled_shift left, waiting[WAITING];
  int count;
} tracer;

static void tracer_init(tracer *t, tp_basins *basins, tp_settling *settling) {
  *t = (tracer){.basins = basins, .settling = settling};
  fmpq_init(t->beside);
  fmpq_div_2exp(t->beside, basins->narrow, 2);
  fmpq_init(t->left.x);
  for (int k = 0; k < WAITING; k++) fmpq_init(t->waiting[k].x);
}

static void tracer_clear(tracer *t) {
  fmpq_clear(t->beside);
  fmpq_clear(t->left.x);
  for (int k = 0; k < WAITING; k++) fmpq_clear(t->waiting[k].x);
}

static tp_status settle_at(settled_shift *shift, tracer *t, tp_message *message) {
  tp_status status = tp_settle_from(t->settling, shift->x, message);
  t->basins->settlings++;
  if (status != TP_OK) return status;
  if (t->settling->how == TP_SETTLED_TOO_BLIND) {
    return tp_settle_fail_blind(t->settling->asked, message);
  }
  if (t->settling->how == TP_SETTLED_TOO_DEAR) {
    return tp_refuse(
        message, TP_FAULT_GEOMETRY, t->settling->asked,
        "to set the block down %ld times takes too long, on a profile of %ld points with "
        "%ld vertices of its own: give the profile fewer points, a longer 'step', or set "
        "the block down once, by 'place: rest'",
        t->basins->settlings, t->settling->bodies.profile_count, t->settling->bodies.own.count);
  }
  return tp_endings_note(&shift->ending, &t->basins->endings, t->settling, message);
}

static tp_status begin_basin(tp_basins *b, const settled_shift *shift, tp_message *message) {
  tp_basin_found *room = tp_grow(b->items, b->count, &b->capacity, sizeof *room);
  if (room == NULL) return tp_fail_memory(message, "the basins");
  b->items = room;
  tp_basin_found *own = b->items + b->count++;
  own->ending = shift->ending;
  fmpq_init(&own->first);
  fmpq_init(&own->last);
  fmpq_set(&own->first, shift->x);
  fmpq_set(&own->last, shift->x);
  return TP_OK;
}

static bool is_narrow(const tracer *t, const fmpq_t left, const fmpq_t right) {
  fmpq_t width;
  fmpq_init(width);
  fmpq_sub(width, right, left);
  const bool narrow = fmpq_cmp(width, t->basins->narrow) <= 0;
  fmpq_clear(width);
  return narrow;
}

/* Where to look next between the two, which are farther apart than `narrow`. */
static void split(fmpq_t x, const tracer *t, const fmpq_t left, const fmpq_t right) {
  if (!tp_event_within(x, &t->settling->bodies, left, right)) {
    fmpq_add(x, left, right);
    fmpq_div_2exp(x, x, 1);
    return;
  }
  fmpq_sub(x, x, t->beside);
  if (fmpq_cmp(x, left) > 0) return;
  fmpq_add(x, x, t->beside);
  fmpq_add(x, x, t->beside);
}

/* From t->left to the only one that waits: what lies between joins the basin on the left, or is the
 * next one. */
static tp_status trace(tracer *t, tp_message *message) {
  tp_status status = TP_OK;
  while (t->count > 0 && status == TP_OK) {
    tp_basins *b = t->basins;
    settled_shift *right = t->waiting + t->count - 1;
    const bool alike = right->ending == t->left.ending;
    if (!alike && t->count < WAITING && b->settlings < TP_BASIN_SETTLINGS &&
        t->settling->work < TP_BUDGET_REST_PAIRS && !is_narrow(t, t->left.x, right->x)) {
      settled_shift *between = t->waiting + t->count++;
      split(between->x, t, t->left.x, right->x);
      status = settle_at(between, t, message);
      continue;
    }
    if (alike) {
      fmpq_set(&b->items[b->count - 1].last, right->x);
    } else {
      status = begin_basin(b, right, message);
    }
    fmpq_set(t->left.x, right->x);
    t->left.ending = right->ending;
    t->count--;
  }
  return status;
}

/* Off the middle of its place, so that blocks and profiles of round numbers are not met where they
 * balance; the first and the last next to the ends. */
static void sample(fmpq_t x, const tp_basins *b, long k, long count) {
  enum { PLACES = 65536, PLACE = 31883 };
  if (k < 0) {
    fmpq_add(x, b->low, b->narrow);
  } else if (k >= count) {
    fmpq_sub(x, b->high, b->narrow);
  } else {
    fmpq_set_si(x, k * PLACES + PLACE, PLACES);
    fmpq_mul(x, x, b->spacing);
    fmpq_add(x, x, b->low);
  }
}

static tp_status trace_all(tracer *t, long count, tp_message *message) {
  sample(t->left.x, t->basins, -1, count);
  tp_status status = settle_at(&t->left, t, message);
  if (status == TP_OK) status = begin_basin(t->basins, &t->left, message);
  for (long k = 0; k <= count && status == TP_OK; k++) {
    settled_shift *next = t->waiting;
    sample(next->x, t->basins, k, count);
    status = settle_at(next, t, message);
    t->count = 1;
    if (status == TP_OK) status = trace(t, message);
  }
  return status;
}

static void clear_items(tp_basins *b, long from) {
  for (long k = from; k < b->count; k++) {
    fmpq_clear(&b->items[k].first);
    fmpq_clear(&b->items[k].last);
  }
  b->count = from < b->count ? from : b->count;
}

/* Does it lie between neighbours as close as a border has them: a single position, as where the
 * block balances? */
static bool is_single(const tp_basins *b, long k) {
  if (k == 0 || k + 1 >= b->count) return false;
  fmpq_t width, most;
  fmpq_init(width);
  fmpq_init(most);
  fmpq_sub(width, &b->items[k + 1].first, &b->items[k - 1].last);
  fmpq_mul_si(most, b->narrow, 4);
  const bool single = fmpq_cmp(width, most) <= 0;
  fmpq_clear(width);
  fmpq_clear(most);
  return single;
}

/* Leave single positions out, and join what they parted. */
static void join(tp_basins *b) {
  long kept = 0;
  for (long k = 0; k < b->count; k++) {
    if (is_single(b, k)) continue;
    tp_basin_found *own = b->items + kept, *next = b->items + k;
    if (kept > 0 && own[-1].ending == next->ending) {
      fmpq_set(&own[-1].last, &next->last);
      continue;
    }
    own->ending = next->ending;
    fmpq_set(&own->first, &next->first);
    fmpq_set(&own->last, &next->last);
    kept++;
  }
  clear_items(b, kept);
}

/* The shifts at which it stands over the profile, and how many are tried. */
static long set_range(tp_basins *b, const tp_bodies *bodies) {
  const fmpq *x = bodies->own.x;
  long least = 0, most = 0;
  for (long k = 1; k < bodies->own.count; k++) {
    if (fmpq_cmp(x + k, x + least) < 0) least = k;
    if (fmpq_cmp(x + k, x + most) > 0) most = k;
  }
  fmpq_t width;
  fmpq_init(width);
  fmpq_sub(width, x + most, x + least);
  fmpq_div_2exp(b->narrow, width, TP_BASIN_BITS);
  fmpq_sub(b->low, bodies->base.x + bodies->profile_count - 1, x + most);
  fmpq_sub(b->high, bodies->base.x, x + least);
  fmpq_sub(b->spacing, b->high, b->low);
  int log2_count = LOG2_FEWEST;
  fmpq_div_2exp(width, width, LOG2_TO_A_WIDTH);
  fmpq_div_2exp(b->spacing, b->spacing, LOG2_FEWEST);
  while (log2_count < LOG2_MOST && fmpq_cmp(b->spacing, width) > 0) {
    log2_count++;
    fmpq_div_2exp(b->spacing, b->spacing, 1);
  }
  fmpq_clear(width);
  return 1L << log2_count;
}

void tp_basins_border(fmpq_t middle, fmpq_t half, const tp_basins *b, long before) {
  const fmpq *left = before > 0 ? &b->items[before - 1].last : b->low;
  const fmpq *right = before < b->count ? &b->items[before].first : b->high;
  if (before == 0) right = left;
  if (before == b->count) left = right;
  fmpq_add(middle, left, right);
  fmpq_div_2exp(middle, middle, 1);
  fmpq_sub(half, right, left);
  fmpq_div_2exp(half, half, 1);
}

void tp_basins_clear(tp_basins *b) {
  clear_items(b, 0);
  free(b->items);
  tp_endings_clear(&b->endings);
  fmpq_clear(b->low);
  fmpq_clear(b->high);
  fmpq_clear(b->spacing);
  fmpq_clear(b->narrow);
  memset(b, 0, sizeof *b);
}

tp_status tp_basins_find(tp_basins *basins, tp_settling *settling, tp_message *message) {
  tracer t;
  memset(basins, 0, sizeof *basins);
  fmpq_init(basins->low);
  fmpq_init(basins->high);
  fmpq_init(basins->spacing);
  fmpq_init(basins->narrow);
  const long count = set_range(basins, &settling->bodies);
  settling->work_allowed = all_budgets * TP_BUDGET_REST_PAIRS;
  tracer_init(&t, basins, settling);
  const tp_status status = trace_all(&t, count, message);
  tracer_clear(&t);
  if (status == TP_OK) {
    join(basins);
  } else {
    tp_basins_clear(basins);
  }
  return status;
}
