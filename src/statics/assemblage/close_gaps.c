/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Corners within reach of each other are grouped, and each group goes to the corner of ground, else
 * of the first block, in it. A group without ground that lies near an edge goes to the foot on that
 * edge, rounded to 2^-20 of the reach; the edge then takes it in as a corner of its own, unless it
 * is on it exactly. So whatever else moves, what meets is one point of all that meet there. All is
 * done twice, and edges take in corners the second time: two corners next to one of an edge may
 * have come within reach of each other by then. */

#include "assemblage/close_gaps.h"

#include "assemblage/corner_search.h"
#include "common/grow.h"
#include "common/outside.h"
#include "number/between.h"
#include "number/grid.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { GRID_BITS = 20 };

/* A corner on an edge. */
typedef struct taken {
  long edge, corner;
  double along, distance;
} taken;

typedef struct work {
  tp_closing *closing;
  tp_section *sections;
  const tp_given_block *given;
  tp_corner_search search;
  double reach;
  long *group; /* of a corner: one of its group, in the end the one that all go to */
  fmpq *x, *y; /* where the group of that corner goes */
  taken *taken;
  long taken_count, taken_room;
  bool last;     /* time: edges take in corners */
  double *shift; /* dx and dy of each corner until now */
} work;

static bool is_fixed(const work *w, long corner) {
  return w->given[w->search.corners[corner].block].fixed;
}

static long find_group(work *w, long corner) {
  while (w->group[corner] != corner) {
    w->group[corner] = w->group[w->group[corner]];
    corner = w->group[corner];
  }
  return corner;
}

/* Ground stays, else the block that comes first. */
static tp_status join(void *context, const tp_near_corner *near, tp_message *message) {
  (void)message;
  work *w = context;
  const long a = find_group(w, near->corner), b = find_group(w, near->other);
  const bool first = is_fixed(w, a) != is_fixed(w, b) ? is_fixed(w, a) : a < b;
  w->group[first ? b : a] = first ? a : b;
  return TP_OK;
}

static tp_status take(void *context, const tp_near_corner *near, tp_message *message) {
  work *w = context;
  const long group = find_group(w, near->corner);
  if (find_group(w, near->other) == group ||
      find_group(w, w->search.corners[near->other].next) == group) {
    return TP_OK; /* an end of the edge is there */
  }
  taken *all = tp_grow(w->taken, w->taken_count, &w->taken_room, sizeof *all);
  if (all == NULL) return tp_fail_memory(message, "the corners of blocks");
  w->taken = all;
  all[w->taken_count++] = (taken){near->other, group, near->along, near->distance};
  return TP_OK;
}

/* ---- where groups go ---------------------------------------------------------------------------
 */

/* To the foot on an edge, whose ends are where their groups go; on its line it stays. */
static void move_to_edge(work *w, long group, long edge) {
  const long p = find_group(w, edge), q = find_group(w, w->search.corners[edge].next);
  if (tp_points_turn(w->x + p, w->y + p, w->x + q, w->y + q, w->x + group, w->y + group) == 0) {
    return;
  }
  fmpq n[4]; /* dx, dy, the share, and a part of it */
  for (int k = 0; k < 4; k++) fmpq_init(n + k);
  fmpq_sub(n, w->x + q, w->x + p);
  fmpq_sub(n + 1, w->y + q, w->y + p);
  fmpq_sub(n + 3, w->x + group, w->x + p);
  fmpq_mul(n + 2, n + 3, n);
  fmpq_sub(n + 3, w->y + group, w->y + p);
  fmpq_addmul(n + 2, n + 3, n + 1);
  fmpq_mul(n + 3, n, n);
  fmpq_addmul(n + 3, n + 1, n + 1);
  fmpq_div(n + 2, n + 2, n + 3);
  fmpq_mul(w->x + group, n + 2, n);
  fmpq_add(w->x + group, w->x + group, w->x + p);
  fmpq_mul(w->y + group, n + 2, n + 1);
  fmpq_add(w->y + group, w->y + group, w->y + p);
  tp_round_to_grid(w->x + group, ilogb(w->reach) - GRID_BITS);
  tp_round_to_grid(w->y + group, ilogb(w->reach) - GRID_BITS);
  for (int k = 0; k < 4; k++) fmpq_clear(n + k);
}

/* By the corner that is taken in; of one, that of ground first, then the nearest. */
static int compare_by_corner(const void *first, const void *second) {
  const taken *a = first, *b = second;
  if (a->corner != b->corner) return a->corner < b->corner ? -1 : 1;
  if (a->distance != b->distance) return a->distance < b->distance ? -1 : 1;
  return (a->edge > b->edge) - (a->edge < b->edge);
}

static int compare_by_edge(const void *first, const void *second) {
  const taken *a = first, *b = second;
  if (a->edge != b->edge) return a->edge < b->edge ? -1 : 1;
  return (a->along > b->along) - (a->along < b->along);
}

static void place_groups(work *w) {
  for (long c = 0; c < w->search.count; c++) {
    const tp_outline_corner *own = w->search.corners + c;
    const tp_polyline *ring = w->sections[own->block].rings;
    fmpq_set(w->x + c, ring->x + own->vertex);
    fmpq_set(w->y + c, ring->y + own->vertex);
  }
  if (w->taken_count == 0) return;
  qsort(w->taken, (size_t)w->taken_count, sizeof *w->taken, compare_by_corner);
  for (long k = 0; k < w->taken_count;) {
    const long group = w->taken[k].corner;
    long best = k, end = k;
    for (; end < w->taken_count && w->taken[end].corner == group; end++) {
      if (!is_fixed(w, w->taken[best].edge) && is_fixed(w, w->taken[end].edge)) best = end;
    }
    if (!is_fixed(w, group)) move_to_edge(w, group, w->taken[best].edge);
    k = end;
  }
  qsort(w->taken, (size_t)w->taken_count, sizeof *w->taken, compare_by_edge);
}

/* ---- outlines ----------------------------------------------------------------------------------
 */

static tp_status count_move(work *w, long corner, tp_message *message) {
  const tp_outline_corner *own = w->search.corners + corner;
  const tp_polyline *ring = w->sections[own->block].rings;
  const long group = find_group(w, corner);
  double *shift = w->shift + 2 * corner;
  shift[0] += tp_ratio_apart(w->x + group, ring->x + own->vertex);
  shift[1] += tp_ratio_apart(w->y + group, ring->y + own->vertex);
  const double by = hypot(shift[0], shift[1]);
  if (by > 2 * w->reach) {
    return tp_refuse(message, TP_FAULT_GEOMETRY, w->given[own->block].place,
                     "corners lie in a chain from block '%s' to '%s', each within the tolerance of "
                     "the next one: give a smaller 'within'",
                     tp_quote_all(w->given[own->block].name).text,
                     tp_quote_all(w->given[w->search.corners[group].block].name).text);
  }
  if (!w->last || by == 0) return TP_OK;
  w->closing->moved++;
  if (by > w->closing->most) {
    w->closing->most = by;
    w->closing->block = own->block;
  }
  return TP_OK;
}

/* Is the last corner the same as another one? */
static tp_status check_last(const tp_polyline *ring, long other, tp_message *message) {
  const long last = ring->count - 1;
  if (other < 0 || other == last || !fmpq_equal(ring->x + last, ring->x + other) ||
      !fmpq_equal(ring->y + last, ring->y + other)) {
    return TP_OK;
  }
  return tp_refuse(message, TP_FAULT_GEOMETRY, tp_polyline_place(ring, last),
                   "an edge of this block is no longer than the tolerance 'within' about it: leave "
                   "out one of its ends, or give a smaller tolerance");
}

static tp_status append(work *w, tp_polyline *ring, long corner, tp_mark mark,
                        tp_message *message) {
  const long group = find_group(w, corner);
  if (!tp_polyline_append(ring, w->x + group, w->y + group, mark)) {
    return tp_fail_memory(message, "the blocks");
  }
  return w->last ? check_last(ring, ring->count - 2, message) : TP_OK;
}

/* The corners that an edge takes in, but those that are on it exactly. */
static tp_status append_taken(work *w, tp_polyline *ring, long edge, tp_mark mark, long *next,
                              tp_message *message) {
  const long p = find_group(w, edge), q = find_group(w, w->search.corners[edge].next);
  tp_status status = TP_OK;
  long last = -1;
  for (; *next < w->taken_count && w->taken[*next].edge == edge && status == TP_OK; ++*next) {
    const long own = w->taken[*next].corner;
    if (own == last ||
        tp_points_turn(w->x + p, w->y + p, w->x + q, w->y + q, w->x + own, w->y + own) == 0) {
      continue;
    }
    status = append(w, ring, own, mark, message);
    w->closing->taken_in++;
    last = own;
  }
  return status;
}

static tp_status set_rings(work *w, long count, tp_message *message) {
  tp_status status = TP_OK;
  long corner = 0, next = 0;
  for (long c = 0; c < w->search.count && status == TP_OK; c++) status = count_move(w, c, message);
  for (long b = 0; b < count && status == TP_OK; b++) {
    tp_polyline *ring = w->sections[b].rings;
    tp_polyline closed = {.file = ring->file, .mark = ring->mark};
    for (long k = 0; k < ring->count && status == TP_OK; k++, corner++) {
      const tp_mark mark = ring->marks != NULL ? ring->marks[k] : ring->mark;
      status = append(w, &closed, corner, mark, message);
      if (status == TP_OK && w->last) {
        status = append_taken(w, &closed, corner, mark, &next, message);
      }
    }
    if (status == TP_OK && w->last) status = check_last(&closed, 0, message);
    if (status == TP_OK) {
      tp_polyline_clear(ring);
      *ring = closed;
    } else {
      tp_polyline_clear(&closed);
    }
  }
  return status;
}

static tp_status make_room(work *w, tp_message *message) {
  const size_t room = (size_t)w->search.count + 1;
  w->group = calloc(room, sizeof *w->group);
  w->x = calloc(room, sizeof *w->x);
  w->y = calloc(room, sizeof *w->y);
  if (w->group == NULL || w->x == NULL || w->y == NULL) {
    return tp_fail_memory(message, "the corners of blocks");
  }
  for (long c = 0; c < w->search.count; c++) {
    w->group[c] = c;
    fmpq_init(w->x + c);
    fmpq_init(w->y + c);
  }
  return TP_OK;
}

static void clear(work *w) {
  for (long c = 0; c < w->search.count; c++) {
    if (w->x != NULL) fmpq_clear(w->x + c);
    if (w->y != NULL) fmpq_clear(w->y + c);
  }
  free(w->group);
  free(w->x);
  free(w->y);
  free(w->taken);
  tp_corner_search_clear(&w->search);
}

static tp_status close_once(work *w, long count, tp_message *message) {
  tp_status status = tp_corner_search_init(&w->search, w->given, count, message);
  if (status != TP_OK) return status;
  status = make_room(w, message);
  if (status == TP_OK) status = tp_near_corners_each(&w->search, w->reach, join, w, message);
  if (status == TP_OK) status = tp_near_edges_each(&w->search, w->reach, take, w, message);
  if (status == TP_OK) {
    place_groups(w);
    status = set_rings(w, count, message);
  }
  clear(w);
  return status;
}

tp_status tp_close_gaps(tp_closing *closing, tp_section *sections, const tp_given_block *given,
                        long count, const fmpq_t within, tp_message *message) {
  memset(closing, 0, sizeof *closing);
  long corners = 0;
  for (long b = 0; b < count; b++) corners += sections[b].rings->count;
  double *shift = calloc(2 * (size_t)corners + 1, sizeof *shift);
  tp_status status = shift != NULL ? TP_OK : tp_fail_memory(message, "the corners of blocks");
  for (int last = 0; last < 2 && status == TP_OK; last++) {
    work w = {.closing = closing,
              .sections = sections,
              .given = given,
              .reach = fmpq_get_d(within),
              .last = last == 1,
              .shift = shift};
    status = close_once(&w, count, message);
  }
  free(shift);
  return status;
}
