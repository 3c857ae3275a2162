/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Triangles turned to agree, and outwards; what was closed, by sums with bounds. */

#include "solid/mend_steps.h"
#include "solid/sides.h"

#include <float.h>
#include <stdlib.h>

/* ---- orientation -------------------------------------------------------------------------------
 */

static void turn(tp_mending *m, long t) {
  int *own = m->triangles + 3 * t;
  const int kept = own[1];
  own[1] = own[2];
  own[2] = kept;
  m->turned[t] = !m->turned[t];
}

enum { UNSEEN, KEPT, TURNED };

/* The neighbour over the side c of t, where there is one; the ways of t and of it. */
static void see_neighbour(const tp_mending *m, const tp_sides *sides, long t, int c, char *ways,
                          long *queue, long *end, bool *one_sided) {
  long count = 0;
  const int *own = m->triangles + 3 * t;
  const tp_side *edge = tp_sides_edge(&count, sides, own[c], own[(c + 1) % 3]);
  if (count != 2) return;
  const long other = edge[0].triangle == t ? edge[1].triangle : edge[0].triangle;
  const bool agrees = edge[0].is_ahead != edge[1].is_ahead;
  const char way = (char)(agrees ? ways[t] : ways[t] == KEPT ? TURNED : KEPT);
  if (ways[other] == UNSEEN) {
    ways[other] = way;
    queue[(*end)++] = other;
  }
  if (ways[other] != way) *one_sided = true;
}

/* All that is reached from a triangle; the fewer of both ways are turned. */
static void orient_from(tp_mending *m, const tp_sides *sides, long first, char *ways, long *queue,
                        bool *one_sided) {
  long end = 1, turned = 0;
  queue[0] = first;
  ways[first] = KEPT;
  for (long k = 0; k < end; k++) {
    turned += ways[queue[k]] == TURNED;
    for (int c = 0; c < 3; c++) {
      see_neighbour(m, sides, queue[k], c, ways, queue, &end, one_sided);
    }
  }
  const char way = (char)(2 * turned > end ? KEPT : TURNED);
  for (long k = 0; k < end && !*one_sided; k++) {
    if (ways[queue[k]] == way) turn(m, queue[k]);
  }
}

bool tp_mending_orient(tp_mending *m, bool *one_sided) {
  tp_sides sides;
  char *ways = calloc((size_t)m->count + 1, sizeof *ways);
  long *queue = malloc(((size_t)m->count + 1) * sizeof *queue);
  const bool done = tp_sides_init(&sides, m->triangles, m->count, m->surface->vertex_count) &&
                    ways != NULL && queue != NULL;
  for (long t = 0; done && t < m->count && !*one_sided; t++) {
    if (ways[t] == UNSEEN) orient_from(m, &sides, t, ways, queue, one_sided);
  }
  tp_sides_clear(&sides);
  free(ways);
  free(queue);
  return done;
}

/* ---- outwards, and what gaps have --------------------------------------------------------------
 */

/* The volume between the origin and a triangle, six times. */
static tp_near under(const tp_mending *m, long t, const tp_near apex[3]) {
  tp_near v[3][3], sum = {0, 0};
  for (int c = 0; c < 3; c++) {
    for (int k = 0; k < 3; k++) {
      v[c][k] = tp_near_sub(tp_surface_near(m->surface, m->triangles[3 * t + c], k), apex[k]);
    }
  }
  for (int k = 0; k < 3; k++) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    sum = tp_near_add(sum, tp_near_mul(v[0][k], tp_near_sub(tp_near_mul(v[1][i], v[2][j]),
                                                            tp_near_mul(v[1][j], v[2][i]))));
  }
  return sum;
}

static tp_near bounded_area(const tp_mending *m, long t) {
  const int *own = m->triangles + 3 * t;
  tp_near e[2][3], squares = {0, 0};
  for (int c = 0; c < 2; c++) {
    for (int k = 0; k < 3; k++) {
      e[c][k] = tp_near_sub(tp_surface_near(m->surface, own[c + 1], k),
                            tp_surface_near(m->surface, own[0], k));
    }
  }
  for (int k = 0; k < 3; k++) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    const tp_near n = tp_near_sub(tp_near_mul(e[0][i], e[1][j]), tp_near_mul(e[0][j], e[1][i]));
    squares = tp_near_add(squares, tp_near_mul(n, n));
  }
  return tp_near_mul(tp_near_sqrt(squares), (tp_near){0.5, 0});
}

/* The middle of the volume, to measure from; nothing depends on its bound. */
static tp_near find_middle(tp_near apex[3], const tp_mending *m) {
  const tp_near origin[3] = {{0, 0}, {0, 0}, {0, 0}};
  tp_near volume = {0, 0};
  double sums[3] = {0};
  for (long t = 0; t < m->count; t++) {
    const tp_near own = under(m, t, origin);
    volume = tp_near_add(volume, own);
    for (int k = 0; k < 3; k++) {
      for (int c = 0; c < 3; c++) {
        sums[k] += own.value * m->surface->near[3L * m->triangles[3 * t + c] + k];
      }
    }
  }
  for (int k = 0; k < 3; k++) apex[k] = (tp_near){sums[k] / (4 * volume.value), 0};
  return volume;
}

static tp_bounded share_of(tp_near part, tp_near all) {
  const tp_near own = tp_near_div(part, all);
  return (tp_bounded){.value = own.value, .error = own.error};
}

void tp_mending_measure(tp_mending *m) {
  tp_solid_repair *record = m->record;
  const double step = tp_mending_step(m->surface);
  tp_near apex[3], all = {0, 0}, closed = {0, 0}, below = {0, 0};
  tp_near volume = find_middle(apex, m);
  if (tp_near_sign(volume) < 0) {
    for (long t = 0; t < m->count; t++) turn(m, t);
    volume = tp_near_neg(volume);
  }
  for (long t = 0; t < m->count; t++) {
    const tp_near own = bounded_area(m, t);
    all = tp_near_add(all, own);
    if (m->faces[t] >= 0) continue;
    tp_solid_gap *gap = record->gaps + (-1 - m->faces[t]);
    const tp_near size = tp_near_mul(own, (tp_near){step * step, step * step * 4 * DBL_EPSILON});
    gap->triangles++;
    gap->area_m2.value += size.value;
    gap->area_m2.error += size.error + gap->area_m2.value * DBL_EPSILON;
    closed = tp_near_add(closed, own);
    below = tp_near_add(below, under(m, t, apex));
  }
  record->closed_area_share = share_of(closed, all);
  record->closed_volume_share = share_of(below, volume);
}
