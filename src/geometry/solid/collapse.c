/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Each vertex that stays, then each other one in its turn, draws neighbours to it while it can: so
 * that vertices come to lie about a reach apart. At first triangles hardly turn by it, which leaves
 * edges of the rock where they are; then they may. Corners at a vertex are a list, from which those
 * of triangles that are gone are taken when it is walked. Time grows with the surface. */

#include "solid/collapse.h"

#include <stdlib.h>
#include <string.h>

/* Of lengths in doubles: coordinates are at most 1 in size and off by 2^-53 of it. */
static const double own_error = 4e-16, rounding = 1e-14;
/* cos^2 of the angle by which a triangle may turn; (height / longest side)^2 of a sliver. */
static const double least_turns[] = {0.95, 0.04}, least_height = 1e-6;

static int *first_of(const tp_collapse *c, int vertex) {
  return c->first_last + 2L * vertex;
}

static bool init(tp_collapse *c, const tp_surface *s) {
  const size_t vertices = (size_t)s->vertex_count, corners = 3 * (size_t)s->triangle_count;
  *c = (tp_collapse){.surface = s};
  c->triangles = malloc(corners * sizeof *c->triangles);
  c->next = malloc(corners * sizeof *c->next);
  c->first_last = malloc(2 * vertices * sizeof *c->first_last);
  c->moved = malloc(vertices * sizeof *c->moved);
  c->marks = calloc(vertices, sizeof *c->marks);
  if (c->triangles == NULL || c->next == NULL || c->first_last == NULL || c->moved == NULL ||
      c->marks == NULL) {
    return false;
  }
  memcpy(c->triangles, s->triangles, corners * sizeof *c->triangles);
  memset(c->first_last, -1, 2 * vertices * sizeof *c->first_last);
  memset(c->moved, -1, vertices * sizeof *c->moved);
  for (long k = 3 * s->triangle_count - 1; k >= 0; k--) {
    int *first = first_of(c, c->triangles[k]);
    c->next[k] = *first;
    *first = (int)k;
  }
  for (long v = 0; v < s->vertex_count; v++) c->first_last[2 * v + 1] = (int)v;
  return true;
}

void tp_collapse_clear(tp_collapse *c) {
  free(c->triangles);
  free(c->next);
  free(c->first_last);
  free(c->moved);
  free(c->marks);
  free(c->ring);
  *c = (tp_collapse){.surface = NULL};
}

/* ---- walking -----------------------------------------------------------------------------------
 */

/* The corner at `*link`, behind those of triangles that are gone, or -1. */
static int corner_at(const tp_collapse *c, int *link) {
  while (*link >= 0 && c->triangles[*link - *link % 3] < 0) *link = c->next[*link];
  return *link;
}

/* Of the triangle of a corner the other two, in its order. */
static int after(const tp_collapse *c, int corner) {
  return c->triangles[corner % 3 == 2 ? corner - 2 : corner + 1];
}

static int before(const tp_collapse *c, int corner) {
  return c->triangles[corner % 3 == 0 ? corner + 2 : corner - 1];
}

/* ---- may it move? ------------------------------------------------------------------------------
 */

static void set_way(double way[3], const tp_collapse *c, int from, int to) {
  const double *a = c->surface->near + 3L * from, *b = c->surface->near + 3L * to;
  for (int k = 0; k < 3; k++) way[k] = b[k] - a[k];
}

static double dot(const double a[3], const double b[3]) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* A bound of the distance of two vertices. */
static double distance(const tp_collapse *c, int from, int to) {
  double way[3];
  set_way(way, c, from, to);
  return sqrt(dot(way, way)) * (1 + rounding) + own_error;
}

static bool is_within(double *farthest, const tp_collapse *c, int from, int to, double reach) {
  for (int v = from; v >= 0; v = c->moved[v]) {
    const double own = distance(c, v, to);
    if (!(own <= reach)) return false;
    if (own > *farthest) *farthest = own;
  }
  return true;
}

static int common_neighbours(const tp_collapse *c, int vertex) {
  int count = 0;
  for (int *link = first_of(c, vertex); corner_at(c, link) >= 0; link = c->next + *link) {
    count += c->marks[after(c, *link)] == c->round;
  }
  return count;
}

static void set_normal(double normal[3], const double one[3], const double other[3]) {
  for (int k = 0; k < 3; k++) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    normal[k] = one[i] * other[j] - one[j] * other[i];
  }
}

/* Does a triangle keep its side and its shape where its corner `from` goes to `to`? */
static bool keeps(const tp_collapse *c, int from, int to, int a, int b, double least_turn) {
  double edges[4][3], side[3], was[3], is[3];
  set_way(edges[0], c, from, a);
  set_way(edges[1], c, from, b);
  set_way(edges[2], c, to, a);
  set_way(edges[3], c, to, b);
  set_way(side, c, a, b);
  set_normal(was, edges[0], edges[1]);
  set_normal(is, edges[2], edges[3]);
  const double longest =
      fmax(fmax(dot(edges[2], edges[2]), dot(edges[3], edges[3])), dot(side, side));
  const double old = dot(was, was), own = dot(is, is), turn = dot(was, is);
  if (!(own > least_height * longest * longest)) return false;
  return old == 0 || (turn > 0 && turn * turn > least_turn * old * own);
}

static bool may_turn(const tp_collapse *c, int from, int to, double least_turn) {
  for (int *link = first_of(c, from); corner_at(c, link) >= 0; link = c->next + *link) {
    const int a = after(c, *link), b = before(c, *link);
    if (a != to && b != to && !keeps(c, from, to, a, b, least_turn)) return false;
  }
  return true;
}

/* ---- moving ------------------------------------------------------------------------------------
 */

static bool add_to_ring(tp_collapse *c, long *count, int vertex) {
  c->marks[vertex] = c->round;
  if (*count == c->room) {
    const long room = 2 * c->room + 64;
    int *ring = realloc(c->ring, (size_t)room * sizeof *ring);
    if (ring == NULL) return false;
    c->ring = ring;
    c->room = room;
  }
  c->ring[(*count)++] = vertex;
  return true;
}

/* Its corners become those of `to`, its triangles with both go, its neighbours are neighbours. */
static bool move(tp_collapse *c, long *count, int from, int to) {
  int *first = first_of(c, from), *link = first, *target = first_of(c, to);
  bool done = true;
  while (corner_at(c, link) >= 0) {
    const int corner = *link, a = after(c, corner), b = before(c, corner);
    if (a != to && c->marks[a] != c->round) done = add_to_ring(c, count, a) && done;
    if (a == to || b == to) {
      c->triangles[corner - corner % 3] = -1;
      continue;
    }
    c->triangles[corner] = to;
    link = c->next + corner;
  }
  *link = *target;
  *target = *first;
  *first = -1;
  c->marks[from] = 0;
  c->moved[target[1]] = from;
  target[1] = first[1];
  return done;
}

/* Draws neighbours to a vertex until none comes; one that is too far is tried once. */
static bool draw(tp_collapse *c, int to, double reach, double least_turn, const bool *stay) {
  long count = 0;
  bool goes_on = true, done = true;
  c->round++;
  for (int *link = first_of(c, to); done && corner_at(c, link) >= 0; link = c->next + *link) {
    done = add_to_ring(c, &count, after(c, *link));
  }
  while (goes_on && done) {
    long kept = 0;
    goes_on = false;
    for (long k = 0; k < count && done; k++) {
      const int from = c->ring[k];
      double farthest = c->farthest;
      if (stay[from] || !is_within(&farthest, c, from, to, reach)) continue;
      if (common_neighbours(c, from) != 2 || !may_turn(c, from, to, least_turn)) {
        c->ring[kept++] = from;
        continue;
      }
      done = move(c, &count, from, to);
      c->farthest = farthest;
      goes_on = true;
    }
    count = kept;
  }
  return done;
}

bool tp_collapse_run(tp_collapse *c, const tp_surface *surface, double reach, const bool *stay) {
  bool done = init(c, surface);
  for (int way = 0; way < 4; way++) {
    for (int v = 0; done && v < surface->vertex_count; v++) {
      if (stay[v] != (way % 2 == 0) || *first_of(c, v) < 0) continue;
      done = draw(c, v, reach, least_turns[way / 2], stay);
    }
  }
  return done;
}
