/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* All of a ground is drawn, or where it is much larger than the rock what lies in a box about that,
 * wider by a share of its longest side. Triangles and lines are clipped at one side of the box
 * after the other (Sutherland and Hodgman 1974). */

#include "figure/solid_surroundings.h"

#include <math.h>
#include <string.h>

/* In shares of the longest side of the rock's box: what a ground has around it that is cut, and
 * what it may have on all sides to be drawn as a whole. */
#define BESIDE 0.3
#define BELOW 0.5
#define ABOVE 0.05
#define AS_A_WHOLE 0.6

static bool holds(const tp_surroundings *box, const double point[3]) {
  for (int k = 0; k < 3; k++) {
    const double at = tp_solid_dot(box->axes[k], point);
    if (at < box->low[k] || at > box->high[k]) return false;
  }
  return true;
}

static bool hold(const tp_surroundings *box, const tp_solid_mesh *mesh) {
  for (long v = 0; v < mesh->vertex_count; v++) {
    if (!holds(box, mesh->points + 3 * v)) return false;
  }
  return true;
}

static tp_surroundings widened(const tp_surroundings *box, double beside, double below,
                               double above) {
  tp_surroundings wide = *box;
  double longest = 0;
  for (int k = 0; k < 3; k++) longest = fmax(longest, box->high[k] - box->low[k]);
  for (int k = 0; k < 3; k++) {
    wide.low[k] -= (k < 2 ? beside : below) * longest;
    wide.high[k] += (k < 2 ? beside : above) * longest;
  }
  return wide;
}

tp_surroundings tp_surroundings_of(const tp_solid_mesh *rock, const tp_solid_mesh *ground,
                                   const tp_solid_view *view) {
  const double level = hypot(view->right[0], view->right[1]);
  const double along[2] = {level > 0 ? view->right[0] / level : 1,
                           level > 0 ? view->right[1] / level : 0};
  tp_surroundings box = {.axes = {{along[0], along[1], 0}, {-along[1], along[0], 0}, {0, 0, 1}},
                         .low = {INFINITY, INFINITY, INFINITY},
                         .high = {-INFINITY, -INFINITY, -INFINITY}};
  for (long v = 0; v < rock->vertex_count; v++) {
    for (int k = 0; k < 3; k++) {
      const double at = tp_solid_dot(box.axes[k], rock->points + 3 * v);
      box.low[k] = fmin(box.low[k], at);
      box.high[k] = fmax(box.high[k], at);
    }
  }
  const tp_surroundings wide = widened(&box, AS_A_WHOLE, AS_A_WHOLE, AS_A_WHOLE);
  if (hold(&wide, ground)) return wide;
  box = widened(&box, BESIDE, BELOW, ABOVE);
  box.cuts = true;
  return box;
}

/* ---- triangles ---------------------------------------------------------------------------------
 */

/* How far a point is within a side: 0 to 2 the low ones, 3 to 5 the high ones. */
static double within(const tp_surroundings *box, int side, const double point[3]) {
  const double at = tp_solid_dot(box->axes[side % 3], point);
  return side < 3 ? at - box->low[side] : box->high[side % 3] - at;
}

static int clip_at(double (*to)[3], const tp_surroundings *box, int side, double (*from)[3],
                   int count) {
  int left = 0;
  for (int k = 0; k < count; k++) {
    const double *p = from[k], *q = from[(k + 1) % count];
    const double at_p = within(box, side, p), at_q = within(box, side, q);
    if (at_p >= 0) memcpy(to[left++], p, sizeof *to);
    if ((at_p >= 0) == (at_q >= 0)) continue;
    const double share = at_p / (at_p - at_q);
    for (int i = 0; i < 3; i++) to[left][i] = p[i] + share * (q[i] - p[i]);
    left++;
  }
  return left;
}

int tp_surroundings_clip(double polygon[TP_CLIPPED_CORNERS][3], const tp_surroundings *box,
                         const tp_solid_mesh *mesh, long triangle) {
  double other[TP_CLIPPED_CORNERS][3];
  bool all = true;
  int count = 3;
  for (int k = 0; k < 3; k++) {
    const double *corner = mesh->points + 3L * mesh->triangles[3 * triangle + k];
    memcpy(polygon[k], corner, sizeof *polygon);
    all = all && holds(box, corner);
  }
  for (int side = 0; side < 6 && !all && count > 0; side++) {
    count = clip_at(other, box, side, polygon, count);
    memcpy(polygon, other, (size_t)count * sizeof *other);
  }
  return count;
}

/* ---- lines -------------------------------------------------------------------------------------
 */

bool tp_surroundings_clip_line(double ends[2][3], const tp_surroundings *box, const double from[3],
                               const double to[3]) {
  double begin = 0, end = 1;
  for (int side = 0; side < 6; side++) {
    const double p = within(box, side, from), q = within(box, side, to);
    if (p < 0 && q < 0) return false;
    if (p < 0) begin = fmax(begin, p / (p - q));
    if (q < 0) end = fmin(end, p / (p - q));
  }
  for (int i = 0; i < 3; i++) {
    ends[0][i] = from[i] + begin * (to[i] - from[i]);
    ends[1][i] = from[i] + end * (to[i] - from[i]);
  }
  return begin < end;
}
