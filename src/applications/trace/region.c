/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A cut-out reduced to at most half a million pixels, GrabCut from the rough polygon
 * (geom/segment.h), flood fill of the largest connected part, and its contour followed along pixel
 * edges. */

#include "trace/region.h"

#include "common/grow.h"
#include "geom/segment.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_PIXELS = 500000, ROUNDS = 6, LEAST_PIXELS = 100 };

/* The rough polygon as much smaller is rather inside the block, the rest of it rather outside: a
 * rectangle about an ellipse has a fifth of its area outside. */
static const double core = 0.75;

/* The picture that is worked on: a cutting of the whole, each of its pixels the mean of step by
 * step. */
typedef struct work {
  int left, top, step, width, height;
  unsigned char *rgb, *rough, *mask;
  int *stack; /* of pixels, for floods */
} work;

bool tp_trace_ring_add(tp_trace_ring *ring, tp_trace_point point) {
  tp_trace_point *points = tp_grow(ring->points, ring->count, &ring->room, sizeof *points);
  if (points == NULL) return false;
  ring->points = points;
  points[ring->count++] = point;
  return true;
}

void tp_trace_ring_clear(tp_trace_ring *ring) {
  free(ring->points);
  *ring = (tp_trace_ring){0};
}

double tp_trace_ring_area(const tp_trace_ring *ring) {
  double twice = 0;
  for (long k = 0, last = ring->count - 1; k < ring->count; last = k++) {
    const tp_trace_point p = ring->points[last], q = ring->points[k];
    twice += p.x * q.y - q.x * p.y;
  }
  return twice / 2;
}

double tp_trace_ring_length(const tp_trace_ring *ring) {
  double length = 0;
  for (long k = 0, last = ring->count - 1; k < ring->count; last = k++) {
    length +=
        hypot(ring->points[k].x - ring->points[last].x, ring->points[k].y - ring->points[last].y);
  }
  return length;
}

/* ---- the cutting -------------------------------------------------------------------------------
 */

/* The box of the rough polygon and an eighth of its size around it, where colours of the outside
 * are learnt. */
static void place(work *w, const tp_trace_picture *picture, const tp_trace_ring *rough) {
  double low[2] = {rough->points[0].x, rough->points[0].y}, high[2] = {low[0], low[1]};
  for (long k = 1; k < rough->count; k++) {
    low[0] = fmin(low[0], rough->points[k].x);
    low[1] = fmin(low[1], rough->points[k].y);
    high[0] = fmax(high[0], rough->points[k].x);
    high[1] = fmax(high[1], rough->points[k].y);
  }
  const double margin = fmax(high[0] - low[0], high[1] - low[1]) / 8 + 4;
  w->left = (int)fmax(0, floor(low[0] - margin));
  w->top = (int)fmax(0, floor(low[1] - margin));
  const int right = (int)fmin(picture->width, ceil(high[0] + margin));
  const int bottom = (int)fmin(picture->height, ceil(high[1] + margin));
  const double pixels = (double)(right - w->left) * (bottom - w->top);
  w->step = (int)fmax(1, ceil(sqrt(pixels / MOST_PIXELS)));
  w->width = (right - w->left) / w->step;
  w->height = (bottom - w->top) / w->step;
}

static void shrink(work *w, const tp_trace_picture *picture) {
  const unsigned area = (unsigned)w->step * (unsigned)w->step;
  for (int y = 0; y < w->height; y++) {
    for (int x = 0; x < w->width; x++) {
      unsigned sums[3] = {area / 2, area / 2, area / 2};
      for (int k = 0; k < w->step * w->step; k++) {
        const int row = w->top + y * w->step + k / w->step;
        const int column = w->left + x * w->step + k % w->step;
        const unsigned char *from =
            picture->rgb + 3 * ((size_t)row * (size_t)picture->width + (size_t)column);
        for (int c = 0; c < 3; c++) sums[c] += from[c];
      }
      for (int c = 0; c < 3; c++) {
        w->rgb[3 * (y * w->width + x) + c] = (unsigned char)(sums[c] / area);
      }
    }
  }
}

static bool is_within(const tp_trace_ring *rough, tp_trace_point p) {
  bool within = false;
  for (long k = 0, last = rough->count - 1; k < rough->count; last = k++) {
    const tp_trace_point a = rough->points[last], b = rough->points[k];
    if ((a.y <= p.y) == (b.y <= p.y)) continue;
    if (a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x) > p.x) within = !within;
  }
  return within;
}

/* Which of its middles lie within the polygon, 1, and within it as its core, 2. */
static void mark_rough(const work *w, const tp_trace_ring *rough) {
  tp_trace_point middle = {0, 0};
  for (long k = 0; k < rough->count; k++) {
    middle.x += rough->points[k].x / (double)rough->count;
    middle.y += rough->points[k].y / (double)rough->count;
  }
  for (int k = 0; k < w->width * w->height; k++) {
    const int x = k % w->width, y = k / w->width;
    const tp_trace_point p = {w->left + (x + 0.5) * w->step, w->top + (y + 0.5) * w->step};
    const tp_trace_point far = {middle.x + (p.x - middle.x) / core,
                                middle.y + (p.y - middle.y) / core};
    w->rough[k] = (unsigned char)(is_within(rough, p) ? 1 + is_within(rough, far) : 0);
  }
}

/* ---- the largest part --------------------------------------------------------------------------
 */

/* All pixels of the value `from` that hang together by their sides with this one get `to`; how many
 * there are. */
static int flood(work *w, int start, unsigned char from, unsigned char to) {
  int count = 0, top = 0;
  w->stack[top++] = start;
  w->mask[start] = to;
  while (top > 0) {
    const int at = w->stack[--top], x = at % w->width, y = at / w->width;
    const int next[] = {x > 0 ? at - 1 : -1, x + 1 < w->width ? at + 1 : -1,
                        y > 0 ? at - w->width : -1, y + 1 < w->height ? at + w->width : -1};
    count++;
    for (int k = 0; k < 4; k++) {
      if (next[k] < 0 || w->mask[next[k]] != from) continue;
      w->mask[next[k]] = to;
      w->stack[top++] = next[k];
    }
  }
  return count;
}

/* It alone becomes 1, with its holes, all else 0. Its pixels. */
static int keep_largest(work *w) {
  enum { OUTSIDE, INSIDE, SEEN, AROUND };
  const int count = w->width * w->height;
  int best = -1, most = 0;
  for (int k = 0; k < count; k++) {
    if (w->mask[k] != INSIDE) continue;
    const int own = flood(w, k, INSIDE, SEEN);
    if (own > most) best = k, most = own;
  }
  if (best < 0) return 0;
  (void)flood(w, best, SEEN, INSIDE);
  for (int k = 0; k < count; k++) w->mask[k] = w->mask[k] == INSIDE ? INSIDE : OUTSIDE;
  for (int k = 0; k < count; k++) {
    const int x = k % w->width, y = k / w->width;
    const bool edge = x == 0 || y == 0 || x == w->width - 1 || y == w->height - 1;
    if (edge && w->mask[k] == OUTSIDE) (void)flood(w, k, OUTSIDE, AROUND);
  }
  most = 0;
  for (int k = 0; k < count; k++) {
    w->mask[k] = w->mask[k] != AROUND;
    most += w->mask[k];
  }
  return most;
}

/* ---- its contour -------------------------------------------------------------------------------
 */

static bool is_inside(const work *w, const unsigned char *of, int x, int y) {
  return x >= 0 && y >= 0 && x < w->width && y < w->height && of[y * w->width + x] != 0;
}

/* Along the edges of its pixels, the part on the right hand: clockwise as it is seen. */
static tp_status follow(tp_picture_region *region, const work *w, tp_message *message) {
  /* to the right, down, to the left, up; and from the corner that is reached the pixels on either
   * side of the next edge that way */
  static const int dx[] = {1, 0, -1, 0}, dy[] = {0, 1, 0, -1};
  static const int right_x[] = {0, -1, -1, 0}, right_y[] = {0, 0, -1, -1};
  static const int left_x[] = {0, 0, -1, -1}, left_y[] = {-1, 0, 0, -1};
  int first = 0;
  while (w->mask[first] == 0) first++;
  const int start_x = first % w->width, start_y = first / w->width;
  int x = start_x, y = start_y, way = 0;
  long touching = 0;
  do {
    const tp_trace_point corner = {w->left + (double)x * w->step, w->top + (double)y * w->step};
    if (!tp_trace_ring_add(&region->contour, corner)) return tp_fail_memory(message, "an outline");
    touching += !is_inside(w, w->rough, x + left_x[way], y + left_y[way]);
    x += dx[way];
    y += dy[way];
    if (!is_inside(w, w->mask, x + right_x[way], y + right_y[way])) {
      way = (way + 1) % 4;
    } else if (is_inside(w, w->mask, x + left_x[way], y + left_y[way])) {
      way = (way + 3) % 4;
    }
  } while (x != start_x || y != start_y || way != 0);
  region->touching = (double)touching / (double)region->contour.count;
  return TP_OK;
}

static tp_status segment(tp_picture_region *region, work *w, const char *name,
                         tp_message *message) {
  const int count = w->width * w->height;
  int rough = 0;
  for (int k = 0; k < count; k++) rough += w->rough[k] != 0;
  memcpy(w->mask, w->rough, (size_t)count);
  if (rough < LEAST_PIXELS || rough == count) {
    return tp_refuse(message, TP_FAULT_GEOMETRY, (tp_place){name, 0, 0},
                     rough == count ? "the rough polygon fills the picture; something of what lies "
                                      "around the block must be seen"
                                    : "the rough polygon holds too few pixels of the picture");
  }
  const tp_segment_status done = tp_segment(w->mask, w->rgb, w->width, w->height, ROUNDS);
  if (done == TP_SEGMENT_NO_MEMORY) return tp_fail_memory(message, "a picture");
  if (done == TP_SEGMENT_FAILED) {
    return tp_fail(message, TP_DEPENDENCY_FAILED, (tp_place){name, 0, 0},
                   "OpenCV failed to find the block");
  }
  const int found = keep_largest(w);
  if (found >= LEAST_PIXELS && found < rough * 0.998) return follow(region, w, message);
  return tp_fail(message, TP_NO_ANSWER, (tp_place){name, 0, 0},
                 "nothing within the rough polygon is unlike what lies around it; draw the polygon "
                 "nearer to the block, or trace a picture of more contrast");
}

tp_status tp_region_find(tp_picture_region *region, const tp_trace_picture *picture,
                         const tp_trace_ring *rough, const char *name, tp_message *message) {
  work w = {0};
  *region = (tp_picture_region){0};
  place(&w, picture, rough);
  const size_t count = (size_t)(w.width > 0 ? w.width : 0) * (size_t)(w.height > 0 ? w.height : 0);
  region->step = w.step;
  w.rgb = malloc(3 * count + 1);
  w.rough = malloc(count + 1);
  w.mask = malloc(count + 1);
  w.stack = malloc((count + 1) * sizeof *w.stack);
  tp_status status = TP_OK;
  if (w.rgb == NULL || w.rough == NULL || w.mask == NULL || w.stack == NULL) {
    status = tp_fail_memory(message, "a picture");
  }
  if (status == TP_OK) {
    if (count > 0) shrink(&w, picture);
    mark_rough(&w, rough);
    status = segment(region, &w, name, message);
  }
  free(w.rgb);
  free(w.rough);
  free(w.mask);
  free(w.stack);
  if (status != TP_OK) tp_trace_ring_clear(&region->contour);
  return status;
}
