/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A proof in doubles that an outline is simple.
 *
 * Method: two edges whose bounding boxes are apart do not meet, nor do those of which one lies on
 * one side of the line through the other. Edges are taken eight at a time: of groups whose boxes
 * are apart no pair is looked at, nor within groups, or between two that follow each other, in
 * which every edge goes to the right, or every one to the left. So an outline of n vertices costs
 * some n^2 / 128 comparisons of groups and those of a few edges. Neighbours meet in their common
 * vertex alone unless the second runs back over the first.
 *
 * Bound: an orientation (q - p) x (r - p) in doubles has four rounded differences, two products and
 * a difference, and errs by at most 4.2 w (|first product| + |second|), w = 2^-53; what underflows
 * is far less where that sum is at least 1e-280. Comparisons of coordinates are exact. */

#include "batch/simple.h"

#include <math.h>

enum { GROUP = 8, MOST_GROUPS = (TP_SIMPLE_MOST + GROUP - 1) / GROUP };

typedef struct box {
  double left, right, low, high;
} box;

typedef struct outline {
  const double *x, *y;
  long count;
} outline;

static double lesser(double a, double b) {
  return b < a ? b : a;
}

static double larger(double a, double b) {
  return a < b ? b : a;
}

static box box_of(const outline *o, long edge) {
  const double *x = o->x + edge, *y = o->y + edge;
  return (box){lesser(x[0], x[1]), larger(x[0], x[1]), lesser(y[0], y[1]), larger(y[0], y[1])};
}

static bool apart(const box *a, const box *b) {
  return a->right < b->left || b->right < a->left || a->high < b->low || b->high < a->low;
}

/* 1 or -1 where the sum of two products is certainly above or below zero, else 0. */
static int certain_sign(double one, double other) {
  const double sum = one + other, size = fabs(one) + fabs(other);
  if (!(size >= 1e-280 && size <= 1e300) || !(fabs(sum) > 0x1.4p-51 * size)) return 0;
  return sum > 0 ? 1 : -1;
}

/* On which side of the line through an edge the vertex lies; 0: not told. */
static int side(const outline *o, long edge, long vertex) {
  const double px = o->x[edge], py = o->y[edge];
  return certain_sign((o->x[edge + 1] - px) * (o->y[vertex] - py),
                      -(o->y[edge + 1] - py) * (o->x[vertex] - px));
}

/* Does all of an edge lie on one side of the line through another? */
static bool lies_beside(const outline *o, long edge, long line) {
  const int begins = side(o, line, edge);
  return begins != 0 && begins == side(o, line, edge + 1);
}

/* The edge and the one after it. */
static bool goes_on(const outline *o, long edge, long next) {
  const int ahead = certain_sign((o->x[edge + 1] - o->x[edge]) * (o->x[next + 1] - o->x[next]),
                                 (o->y[edge + 1] - o->y[edge]) * (o->y[next + 1] - o->y[next]));
  return ahead > 0 || side(o, edge, next + 1) != 0;
}

static bool keep_apart(const outline *o, long a, long b) {
  if (b == a + 1) return goes_on(o, a, b);
  if (a == 0 && b == o->count - 1) return goes_on(o, b, a);
  return lies_beside(o, b, a) || lies_beside(o, a, b);
}

typedef struct group {
  long first, end; /* edges */
  int runs;        /* 1: each to the right; -1: each to the left; else 0 */
  box all;
} group;

static group group_of(const outline *o, long first) {
  const long end = first + GROUP < o->count ? first + GROUP : o->count;
  const double *x = o->x, *y = o->y;
  box all = {x[first], x[first], y[first], y[first]};
  long right = 0, left = 0;
  for (long k = first + 1; k <= end; k++) {
    right += x[k] > x[k - 1];
    left += x[k] < x[k - 1];
    all = (box){lesser(all.left, x[k]), larger(all.right, x[k]), lesser(all.low, y[k]),
                larger(all.high, y[k])};
  }
  const int runs = right == end - first ? 1 : left == end - first ? -1 : 0;
  return (group){first, end, runs, all};
}

/* Edges of two groups, or of one and the same: of each those that reach into the other's box. */
static bool edges_keep_apart(const outline *o, const group *one, const group *other) {
  box boxes[GROUP];
  long edges[GROUP];
  int count = 0;
  for (long b = other->first; b < other->end; b++) {
    boxes[count] = box_of(o, b);
    edges[count] = b;
    if (!apart(boxes + count, &one->all)) count++;
  }
  for (long a = one->first; a < one->end && count > 0; a++) {
    const box own = box_of(o, a);
    if (apart(&own, &other->all)) continue;
    for (int k = 0; k < count; k++) {
      if (edges[k] > a && !apart(&own, boxes + k) && !keep_apart(o, a, edges[k])) return false;
    }
  }
  return true;
}

static bool groups_keep_apart(const outline *o, const group *one, const group *other) {
  if (apart(&one->all, &other->all)) return true;
  const bool run_on = one->runs != 0 && one->runs == other->runs && other - one <= 1;
  return run_on || edges_keep_apart(o, one, other);
}

bool tp_is_simple(const double *x, const double *y, long count) {
  if (count < 3 || count > TP_SIMPLE_MOST) return false;
  const outline o = {x, y, count};
  group groups[MOST_GROUPS];
  const long group_count = (count + GROUP - 1) / GROUP;
  for (long k = 0; k < group_count; k++) {
    groups[k] = group_of(&o, k * GROUP);
    for (long j = 0; j <= k; j++) {
      if (!groups_keep_apart(&o, groups + j, groups + k)) return false;
    }
  }
  return true;
}
