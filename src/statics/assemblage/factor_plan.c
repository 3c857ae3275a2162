/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Behind a part come the later blocks that its own touch, and those behind the parts that hang on
 * it. What these leave is on a stack: of parts that come one after another, as all that hang on one
 * do, each behind all that hang on itself. */

#include "assemblage/factor_plan.h"

#include "common/grow.h"

#include <stdlib.h>

static bool make_room(tp_factor_plan *p, long more) {
  while (p->behind_count + more > p->behind_room) {
    long *grown = tp_grow(p->behind, p->behind_room, &p->behind_room, sizeof *grown);
    if (grown == NULL) return false;
    p->behind = grown;
  }
  return true;
}

static int compare_places(const void *first, const void *second) {
  const long a = *(const long *)first, b = *(const long *)second;
  return a < b ? -1 : a > b;
}

/* Of blocks that come later each is told once. */
static void add_behind(tp_factor_plan *p, long *marked, long part, long place) {
  if (place < p->dissection.parts[part].end || marked[place] == part) return;
  marked[place] = part;
  p->behind[p->behind_count++] = place;
}

static bool add_neighbours(tp_factor_plan *p, long *marked, long part) {
  const tp_dissection *d = &p->dissection;
  for (long k = d->parts[part].first; k < d->parts[part].end; k++) {
    const long from = d->first[d->order[k]], end = d->first[d->order[k] + 1];
    if (!make_room(p, end - from)) return false;
    for (long e = from; e < end; e++) add_behind(p, marked, part, d->place[d->neighbours[e]]);
  }
  return true;
}

static bool add_children(tp_factor_plan *p, long *marked, long part) {
  for (long c = p->last_child[part]; c >= 0; c = p->child_before[c]) {
    const tp_factor_front *of = p->fronts + c;
    const long count = (of->rows - of->own) / TP_BLOCK_ROWS;
    if (!make_room(p, count)) return false;
    for (long k = 0; k < count; k++) add_behind(p, marked, part, p->behind[of->behind + k]);
  }
  return true;
}

static bool set_front(tp_factor_plan *p, long *marked, long part) {
  const tp_dissected_part *own = p->dissection.parts + part;
  tp_factor_front *f = p->fronts + part;
  f->behind = p->behind_count;
  if (!add_neighbours(p, marked, part) || !add_children(p, marked, part)) return false;
  const long behind = p->behind_count - f->behind;
  if (behind > 0) {
    qsort(p->behind + f->behind, (size_t)behind, sizeof *p->behind, compare_places);
  }
  f->own = TP_BLOCK_ROWS * (own->end - own->first);
  f->rows = f->own + TP_BLOCK_ROWS * behind;
  f->columns = p->entries;
  p->entries += f->rows * f->own;
  if (f->rows > p->most_rows) p->most_rows = f->rows;
  return true;
}

static void find_children(tp_factor_plan *p) {
  const tp_dissection *d = &p->dissection;
  for (long k = 0; k < d->part_count; k++) p->last_child[k] = -1;
  for (long k = 0; k < d->part_count; k++) {
    const long parent = d->parts[k].parent;
    p->child_before[k] = parent < 0 ? -1 : p->last_child[parent];
    if (parent >= 0) p->last_child[parent] = k;
  }
}

static long rest_of(const tp_factor_front *f) {
  return (f->rows - f->own) * (f->rows - f->own);
}

/* What a part leaves is put behind that of its children, and then in their place. */
static void find_rest_room(tp_factor_plan *p) {
  long now = 0;
  for (long k = 0; k < p->dissection.part_count; k++) {
    const long own = rest_of(p->fronts + k);
    if (now + own > p->rest_room) p->rest_room = now + own;
    now += own;
    for (long c = p->last_child[k]; c >= 0; c = p->child_before[c]) now -= rest_of(p->fronts + c);
  }
}

bool tp_factor_plan_init(tp_factor_plan *p, const tp_force_program *program) {
  *p = (tp_factor_plan){.fronts = NULL};
  if (!tp_dissection_init(&p->dissection, program)) return false;
  const size_t parts = (size_t)p->dissection.part_count + 1;
  long *marked = calloc((size_t)p->dissection.block_count + 1, sizeof *marked);
  p->fronts = calloc(parts, sizeof *p->fronts);
  p->last_child = calloc(parts, sizeof *p->last_child);
  p->child_before = calloc(parts, sizeof *p->child_before);
  bool done =
      marked != NULL && p->fronts != NULL && p->last_child != NULL && p->child_before != NULL;
  for (long k = 0; k < p->dissection.block_count && done; k++) marked[k] = -1;
  if (done) find_children(p);
  for (long k = 0; k < p->dissection.part_count && done; k++) done = set_front(p, marked, k);
  if (done) find_rest_room(p);
  free(marked);
  return done;
}

void tp_factor_plan_clear(tp_factor_plan *p) {
  tp_dissection_clear(&p->dissection);
  free(p->fronts);
  free(p->behind);
  free(p->last_child);
  free(p->child_before);
  *p = (tp_factor_plan){.fronts = NULL};
}
