/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Sweeps from left to right: over corners within reach of each other in x, and over edges that are
 * open where a corner is. */

#define _GNU_SOURCE /* qsort_r */
#include "assemblage/corner_search.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

void tp_corner_search_clear(tp_corner_search *s) {
  free(s->corners);
  free(s->by_x);
  memset(s, 0, sizeof *s);
}

static int compare_x(const void *first, const void *second, void *corners) {
  const tp_outline_corner *c = corners;
  const long a = *(const long *)first, b = *(const long *)second;
  if (c[a].x != c[b].x) return c[a].x < c[b].x ? -1 : 1;
  return (a > b) - (a < b);
}

static void set_corners(tp_corner_search *s, const tp_given_block *given, long count) {
  fmpq_t difference;
  fmpq_init(difference);
  const tp_polyline *origin = given[0].section->rings;
  long at = 0;
  for (long b = 0; b < count; b++) {
    const tp_polyline *ring = given[b].section->rings;
    for (long k = 0; k < ring->count; k++, at++) {
      tp_outline_corner *own = s->corners + at;
      fmpq_sub(difference, ring->x + k, origin->x);
      own->x = fmpq_get_d(difference);
      fmpq_sub(difference, ring->y + k, origin->y);
      own->y = fmpq_get_d(difference);
      own->block = b;
      own->vertex = k;
      own->next = k + 1 < ring->count ? at + 1 : at - k;
      s->by_x[at] = at;
    }
  }
  fmpq_clear(difference);
}

tp_status tp_corner_search_init(tp_corner_search *s, const tp_given_block *given, long count,
                                tp_message *message) {
  memset(s, 0, sizeof *s);
  for (long b = 0; b < count; b++) s->count += given[b].section->rings->count;
  s->corners = calloc((size_t)s->count + 1, sizeof *s->corners);
  s->by_x = calloc((size_t)s->count + 1, sizeof *s->by_x);
  if (s->corners == NULL || s->by_x == NULL) {
    tp_corner_search_clear(s);
    return tp_fail_memory(message, "the corners of blocks");
  }
  set_corners(s, given, count);
  qsort_r(s->by_x, (size_t)s->count, sizeof *s->by_x, compare_x, s->corners);
  return TP_OK;
}

tp_status tp_near_corners_each(const tp_corner_search *s, double reach, tp_near_corner_call *call,
                               void *context, tp_message *message) {
  tp_status status = TP_OK;
  for (long k = 0; k < s->count && status == TP_OK; k++) {
    const tp_outline_corner *own = s->corners + s->by_x[k];
    for (long n = k + 1; n < s->count && status == TP_OK; n++) {
      const tp_outline_corner *other = s->corners + s->by_x[n];
      if (other->x - own->x > reach) break;
      const double distance = hypot(other->x - own->x, other->y - own->y);
      if (distance > reach || own->block == other->block) continue;
      const tp_near_corner near = {s->by_x[k], s->by_x[n], 0, distance};
      status = call(context, &near, message);
    }
  }
  return status;
}

/* ---- edges -------------------------------------------------------------------------------------
 */

static double left_end(const tp_corner_search *s, long edge) {
  return fmin(s->corners[edge].x, s->corners[s->corners[edge].next].x);
}

static double right_end(const tp_corner_search *s, long edge) {
  return fmax(s->corners[edge].x, s->corners[s->corners[edge].next].x);
}

static int compare_left_ends(const void *first, const void *second, void *search) {
  const double a = left_end(search, *(const long *)first);
  const double b = left_end(search, *(const long *)second);
  return (a > b) - (a < b);
}

static bool is_near(tp_near_corner *near, const tp_corner_search *s, double reach) {
  const tp_outline_corner *c = s->corners + near->corner, *p = s->corners + near->other;
  const tp_outline_corner *q = s->corners + p->next;
  if (c->block == p->block) return false;
  const double dx = q->x - p->x, dy = q->y - p->y, square = dx * dx + dy * dy;
  near->along = ((c->x - p->x) * dx + (c->y - p->y) * dy) / square;
  if (!(near->along > 0 && near->along < 1)) return false;
  near->distance = fabs((c->y - p->y) * dx - (c->x - p->x) * dy) / sqrt(square);
  return near->distance <= reach;
}

/* The corner with the edges that are open, of which those that end before it are dropped. */
static tp_status meet_open(const tp_corner_search *s, long corner, double reach, long *open,
                           long *open_count, tp_near_corner_call *call, void *context,
                           tp_message *message) {
  tp_status status = TP_OK;
  long kept = 0;
  for (long o = 0; o < *open_count; o++) {
    if (right_end(s, open[o]) + reach < s->corners[corner].x) continue;
    tp_near_corner near = {.corner = corner, .other = open[o]};
    if (status == TP_OK && is_near(&near, s, reach)) status = call(context, &near, message);
    open[kept++] = open[o];
  }
  *open_count = kept;
  return status;
}

tp_status tp_near_edges_each(const tp_corner_search *s, double reach, tp_near_corner_call *call,
                             void *context, tp_message *message) {
  long *edges = calloc((size_t)s->count + 1, sizeof *edges);
  long *open = calloc((size_t)s->count + 1, sizeof *open), open_count = 0, next = 0;
  tp_status status =
      edges != NULL && open != NULL ? TP_OK : tp_fail_memory(message, "the corners of blocks");
  if (status == TP_OK) {
    for (long k = 0; k < s->count; k++) edges[k] = k;
    qsort_r(edges, (size_t)s->count, sizeof *edges, compare_left_ends, (void *)s);
  }
  for (long k = 0; k < s->count && status == TP_OK; k++) {
    const long corner = s->by_x[k];
    while (next < s->count && left_end(s, edges[next]) - reach <= s->corners[corner].x) {
      open[open_count++] = edges[next++];
    }
    status = meet_open(s, corner, reach, open, &open_count, call, context, message);
  }
  free(edges);
  free(open);
  return status;
}
