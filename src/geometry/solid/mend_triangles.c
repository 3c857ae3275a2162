/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Points merged, triangles dropped. */

#include "solid/mend_steps.h"
#include "solid/sides.h"

#include <math.h>
#include <stdlib.h>

/* ---- near points -------------------------------------------------------------------------------
 */

typedef struct place {
  double at[3];
  int vertex;
} place;

static int compare_places(const void *one, const void *other) {
  const place *a = one, *b = other;
  if (a->at[0] != b->at[0]) return a->at[0] < b->at[0] ? -1 : 1;
  return (a->vertex > b->vertex) - (a->vertex < b->vertex);
}

/* In the order of x, each becomes the nearest within reach of those before it that stay. */
static void find_stays(int *stays, const place *places, long count, double reach, tp_mending *m) {
  const double step = tp_mending_step(m->surface);
  for (long k = 0; k < count; k++) {
    double least = reach;
    stays[places[k].vertex] = places[k].vertex;
    for (long n = k - 1; n >= 0 && places[n].at[0] >= places[k].at[0] - reach; n--) {
      if (stays[places[n].vertex] != places[n].vertex) continue;
      double sum = 0;
      for (int c = 0; c < 3; c++) sum += pow(places[k].at[c] - places[n].at[c], 2);
      if (!(sqrt(sum) <= least)) continue;
      least = sqrt(sum);
      stays[places[k].vertex] = places[n].vertex;
    }
    if (stays[places[k].vertex] == places[k].vertex) continue;
    m->record->merged_points++;
    m->record->farthest_merged = fmax(m->record->farthest_merged, least * step);
  }
}

bool tp_mending_merge(tp_mending *m, double within) {
  const long count = m->surface->vertex_count;
  place *places = malloc((size_t)count * sizeof *places);
  int *stays = malloc((size_t)count * sizeof *stays);
  bool *dropped = calloc((size_t)m->count, sizeof *dropped);
  const bool done = places != NULL && stays != NULL && dropped != NULL;
  if (done) {
    for (long v = 0; v < count; v++) {
      const double *at = m->surface->near + 3 * v;
      places[v] = (place){{at[0], at[1], at[2]}, (int)v};
    }
    qsort(places, (size_t)count, sizeof *places, compare_places);
    find_stays(stays, places, count, within / tp_mending_step(m->surface), m);
    for (long k = 0; k < 3 * m->count; k++) m->triangles[k] = stays[m->triangles[k]];
    for (long t = 0; t < m->count; t++) {
      const int *own = m->triangles + 3 * t;
      dropped[t] = own[0] == own[1] || own[1] == own[2] || own[2] == own[0];
      m->record->merged_triangles += dropped[t];
    }
    tp_mending_keep(m, dropped);
  }
  free(places);
  free(stays);
  free(dropped);
  return done;
}

/* ---- duplicates --------------------------------------------------------------------------------
 */

static int third(const tp_mending *m, const tp_side *side, int vertex) {
  const int *own = m->triangles + 3L * side->triangle;
  for (int c = 0; c < 3; c++) {
    if (own[c] != vertex && own[c] != side->other) return own[c];
  }
  return own[0];
}

/* Of the sides of one edge. */
static void mark_duplicates(bool *dropped, const tp_mending *m, int vertex, const tp_side *sides,
                            long count) {
  for (long k = 1; k < count; k++) {
    for (long n = 0; n < k && !dropped[sides[k].triangle]; n++) {
      if (dropped[sides[n].triangle]) continue;
      dropped[sides[k].triangle] = third(m, sides + k, vertex) == third(m, sides + n, vertex);
    }
  }
}

bool tp_mending_drop_duplicates(tp_mending *m) {
  tp_sides sides;
  bool *dropped = calloc((size_t)m->count + 1, sizeof *dropped);
  const bool done =
      tp_sides_init(&sides, m->triangles, m->count, m->surface->vertex_count) && dropped != NULL;
  for (int v = 0; done && v < m->surface->vertex_count; v++) {
    long next = 0;
    for (long k = sides.starts[v]; k < sides.starts[v + 1]; k = next) {
      for (next = k; next < sides.starts[v + 1]; next++) {
        if (sides.items[next].other != sides.items[k].other) break;
      }
      mark_duplicates(dropped, m, v, sides.items + k, next - k);
    }
  }
  for (long t = 0; done && t < m->count; t++) {
    if (!dropped[t]) continue;
    if (m->record->duplicate_triangles++ == 0) {
      m->record->first_duplicate = tp_mending_number(m, t);
    }
  }
  if (done) tp_mending_keep(m, dropped);
  tp_sides_clear(&sides);
  free(dropped);
  return done;
}

/* ---- pieces ------------------------------------------------------------------------------------
 */

static double area(const tp_mending *m, long t) {
  const double *p[3];
  double sum = 0;
  for (int c = 0; c < 3; c++) p[c] = m->surface->near + 3L * m->triangles[3 * t + c];
  for (int k = 0; k < 3; k++) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    const double own =
        (p[1][i] - p[0][i]) * (p[2][j] - p[0][j]) - (p[1][j] - p[0][j]) * (p[2][i] - p[0][i]);
    sum += own * own;
  }
  return sqrt(sum) / 2;
}

/* Triangles that share an edge are of one piece. */
static bool find_leaders(int *leaders, const tp_mending *m) {
  tp_sides sides;
  const bool done = tp_sides_init(&sides, m->triangles, m->count, m->surface->vertex_count);
  for (long t = 0; t < m->count; t++) leaders[t] = (int)t;
  for (long v = 0; done && v < m->surface->vertex_count; v++) {
    for (long k = sides.starts[v] + 1; k < sides.starts[v + 1]; k++) {
      if (sides.items[k].other != sides.items[k - 1].other) continue;
      tp_sides_join(leaders, sides.items[k - 1].triangle, sides.items[k].triangle);
    }
  }
  tp_sides_clear(&sides);
  return done;
}

bool tp_mending_drop_pieces(tp_mending *m, double share) {
  const size_t count = (size_t)m->count + 1;
  int *leaders = malloc(count * sizeof *leaders);
  double *areas = calloc(count, sizeof *areas), all = 0;
  bool *dropped = calloc(count, sizeof *dropped);
  const bool done = leaders != NULL && areas != NULL && dropped != NULL && find_leaders(leaders, m);
  for (long t = 0; done && t < m->count; t++) {
    areas[tp_sides_leader(leaders, (int)t)] += area(m, t);
    all += area(m, t);
  }
  for (long t = 0; done && t < m->count; t++) {
    const int leader = tp_sides_leader(leaders, (int)t);
    dropped[t] = areas[leader] < share * all;
    if (!dropped[t]) continue;
    m->record->dropped_triangles++;
    if (leader != t) continue;
    m->record->dropped_pieces++;
    m->record->dropped_area_share += areas[leader] / all;
  }
  if (done) tp_mending_keep(m, dropped);
  free(leaders);
  free(areas);
  free(dropped);
  return done;
}
