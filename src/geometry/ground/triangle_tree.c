/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A node of the range [low, high) of the order has its children in the halves of it; nodes are
 * numbered as those of a full binary tree, the root 1. */

#include "ground/triangle_tree.h"

#include "solid/triangle_distance.h"

#include <stdint.h>
#include <stdlib.h>

enum { LEAF = 4, CURVE_BITS = 21 };

typedef struct place {
  uint64_t code;
  int triangle;
} place;

/* ---- building ----------------------------------------------------------------------------------
 */

static int compare(const void *one, const void *other) {
  const place *a = one, *b = other;
  if (a->code != b->code) return a->code < b->code ? -1 : 1;
  return (a->triangle > b->triangle) - (a->triangle < b->triangle);
}

/* Where on the curve: bits of all three coordinates, which are at most 1 in size, in turn. */
static uint64_t code_of(const tp_surface *s, long triangle) {
  uint64_t code = 0, whole[3];
  for (int k = 0; k < 3; k++) {
    double middle = 0;
    for (int c = 0; c < 3; c++) middle += s->near[3L * s->triangles[3 * triangle + c] + k];
    const double share = fmin(1, fmax(0, (middle / 3 + 1) / 2));
    whole[k] = (uint64_t)(share * ((1 << CURVE_BITS) - 1));
  }
  for (int bit = CURVE_BITS - 1; bit >= 0; bit--) {
    for (int k = 0; k < 3; k++) code = code << 1 | (whole[k] >> bit & 1);
  }
  return code;
}

/* Coordinates are off by a rounding of at most 1. */
static void hold(tp_triangle_node *node, const tp_surface *s, long triangle) {
  for (int c = 0; c < 3; c++) {
    for (int k = 0; k < 3; k++) {
      const double at = s->near[3L * s->triangles[3 * triangle + c] + k];
      node->low[k] = fmin(node->low[k], at - DBL_EPSILON);
      node->high[k] = fmax(node->high[k], at + DBL_EPSILON);
    }
  }
}

static const tp_triangle_node nothing = {{INFINITY, INFINITY, INFINITY},
                                         {-INFINITY, -INFINITY, -INFINITY}};

static tp_triangle_node box_of(const tp_triangle_tree *tree, long triangle) {
  tp_triangle_node own = nothing;
  hold(&own, tree->surface, triangle);
  return own;
}

static void fill(tp_triangle_tree *tree, long node, long low, long high) {
  tp_triangle_node *own = tree->nodes + node;
  *own = nothing;
  if (high - low <= LEAF) {
    for (long k = low; k < high; k++) hold(own, tree->surface, tree->order[k]);
    return;
  }
  const long middle = low + (high - low) / 2;
  fill(tree, 2 * node, low, middle);
  fill(tree, 2 * node + 1, middle, high);
  for (int k = 0; k < 3; k++) {
    own->low[k] = fmin(own[node].low[k], own[node + 1].low[k]);
    own->high[k] = fmax(own[node].high[k], own[node + 1].high[k]);
  }
}

bool tp_triangle_tree_init(tp_triangle_tree *tree, const tp_surface *surface) {
  const long count = surface->triangle_count;
  *tree = (tp_triangle_tree){.surface = surface, .count = count};
  size_t nodes = 2;
  for (long most = count; most > LEAF; most = (most + 1) / 2) nodes *= 2;
  place *places = malloc((size_t)count * sizeof *places);
  tree->order = malloc((size_t)count * sizeof *tree->order);
  tree->nodes = malloc(nodes * sizeof *tree->nodes);
  const bool done = places != NULL && tree->order != NULL && tree->nodes != NULL;
  for (long k = 0; done && k < count; k++) places[k] = (place){code_of(surface, k), (int)k};
  if (done) {
    qsort(places, (size_t)count, sizeof *places, compare);
    for (long k = 0; k < count; k++) tree->order[k] = places[k].triangle;
    fill(tree, 1, 0, count);
  }
  free(places);
  return done;
}

void tp_triangle_tree_clear(tp_triangle_tree *tree) {
  free(tree->order);
  free(tree->nodes);
  *tree = (tp_triangle_tree){0};
}

/* ---- pairs -------------------------------------------------------------------------------------
 */

/* Part of a tree. */
typedef struct part {
  const tp_triangle_tree *tree;
  long node, low, high;
} part;

static bool is_leaf(part p) {
  return p.high - p.low <= LEAF;
}

static part half(part p, int which) {
  const long middle = p.low + (p.high - p.low) / 2;
  return which == 0 ? (part){p.tree, 2 * p.node, p.low, middle}
                    : (part){p.tree, 2 * p.node + 1, middle, p.high};
}

static part whole(const tp_triangle_tree *tree) {
  return (part){tree, 1, 0, tree->count};
}

static bool is_within(const tp_triangle_node *a, const tp_triangle_node *b, double reach) {
  for (int k = 0; k < 3; k++) {
    if (a->low[k] - b->high[k] > reach || b->low[k] - a->high[k] > reach) return false;
  }
  return true;
}

typedef struct search {
  double reach;
  tp_triangle_pair_visit *visit;
  void *of;
} search;

static bool visit_leaves(const search *s, part a, part b) {
  for (long i = a.low; i < a.high; i++) {
    const tp_triangle_node own = box_of(a.tree, a.tree->order[i]);
    if (!is_within(&own, b.tree->nodes + b.node, s->reach)) continue;
    for (long j = b.low; j < b.high; j++) {
      const tp_triangle_node other = box_of(b.tree, b.tree->order[j]);
      if (!is_within(&own, &other, s->reach)) continue;
      if (!s->visit(s->of, a.tree->order[i], b.tree->order[j])) return false;
    }
  }
  return true;
}

static bool visit_parts(const search *s, part a, part b) {
  if (!is_within(a.tree->nodes + a.node, b.tree->nodes + b.node, s->reach)) return true;
  if (is_leaf(a) && is_leaf(b)) return visit_leaves(s, a, b);
  const bool first = is_leaf(b) || (!is_leaf(a) && a.high - a.low >= b.high - b.low);
  for (int k = 0; k < 2; k++) {
    if (!visit_parts(s, first ? half(a, k) : a, first ? b : half(b, k))) return false;
  }
  return true;
}

bool tp_triangle_tree_pairs(const tp_triangle_tree *one, const tp_triangle_tree *other,
                            double reach, tp_triangle_pair_visit *visit, void *of) {
  const search s = {reach + 4 * DBL_EPSILON, visit, of};
  return visit_parts(&s, whole(one), whole(other));
}

/* ---- the nearest -------------------------------------------------------------------------------
 */

static double box_distance(part a, part b) {
  const tp_triangle_node *p = a.tree->nodes + a.node, *q = b.tree->nodes + b.node;
  double sum = 0;
  for (int k = 0; k < 3; k++) {
    const double apart = fmax(0, fmax(p->low[k] - q->high[k], q->low[k] - p->high[k]));
    sum += apart * apart;
  }
  return sqrt(sum);
}

static void take_corners(double corners[3][3], const tp_surface *s, long triangle) {
  for (int k = 0; k < 9; k++) {
    corners[k / 3][k % 3] = s->near[3L * s->triangles[3 * triangle + k / 3] + k % 3];
  }
}

static void nearest_of_leaves(tp_nearest_pair *best, part a, part b) {
  double p[3][3], q[3][3], points[2][3];
  for (long i = a.low; i < a.high; i++) {
    take_corners(p, a.tree->surface, a.tree->order[i]);
    for (long j = b.low; j < b.high; j++) {
      take_corners(q, b.tree->surface, b.tree->order[j]);
      const double own = tp_triangle_distance(points, p, q);
      if (own >= best->distance) continue;
      *best = (tp_nearest_pair){.distance = own, .triangles = {a.tree->order[i], b.tree->order[j]}};
      for (int k = 0; k < 6; k++) best->points[k / 3][k % 3] = points[k / 3][k % 3];
    }
  }
}

static void nearest_of_parts(tp_nearest_pair *best, part a, part b) {
  if (box_distance(a, b) >= best->distance) return;
  if (is_leaf(a) && is_leaf(b)) {
    nearest_of_leaves(best, a, b);
    return;
  }
  const bool first = is_leaf(b) || (!is_leaf(a) && a.high - a.low >= b.high - b.low);
  const part parts[2] = {first ? half(a, 0) : half(b, 0), first ? half(a, 1) : half(b, 1)};
  const part rest = first ? b : a;
  const int nearer = box_distance(parts[1], rest) < box_distance(parts[0], rest);
  for (int k = 0; k < 2; k++) {
    const part own = parts[k == 0 ? nearer : 1 - nearer];
    nearest_of_parts(best, first ? own : a, first ? b : own);
  }
}

tp_nearest_pair tp_triangle_tree_nearest(const tp_triangle_tree *one,
                                         const tp_triangle_tree *other) {
  tp_nearest_pair best = {.distance = INFINITY};
  nearest_of_parts(&best, whole(one), whole(other));
  return best;
}

static double point_distance(part a, const double point[3]) {
  const tp_triangle_node *p = a.tree->nodes + a.node;
  double sum = 0;
  for (int k = 0; k < 3; k++) {
    const double apart = fmax(0, fmax(p->low[k] - point[k], point[k] - p->high[k]));
    sum += apart * apart;
  }
  return sqrt(sum);
}

static void nearest_to_point(tp_nearest_pair *best, part a, const double point[3]) {
  if (point_distance(a, point) >= best->distance) return;
  if (!is_leaf(a)) {
    const part parts[2] = {half(a, 0), half(a, 1)};
    const int nearer = point_distance(parts[1], point) < point_distance(parts[0], point);
    nearest_to_point(best, parts[nearer], point);
    nearest_to_point(best, parts[1 - nearer], point);
    return;
  }
  for (long k = a.low; k < a.high; k++) {
    double corners[3][3], foot[3];
    take_corners(corners, a.tree->surface, a.tree->order[k]);
    const double own = tp_point_triangle_distance(foot, point, corners);
    if (own >= best->distance) continue;
    best->distance = own;
    best->triangles[0] = a.tree->order[k];
  }
}

double tp_triangle_tree_point(long *triangle, const tp_triangle_tree *tree, const double point[3]) {
  tp_nearest_pair best = {.distance = INFINITY};
  nearest_to_point(&best, whole(tree), point);
  *triangle = best.triangles[0];
  return best.distance;
}
