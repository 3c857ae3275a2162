/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Colour profiles normal to the contour, projected on the axis from inside to outside; the half-way
 * crossing is the edge, the width of the change its uncertainty (docs/trace.md). */

#include "trace/refine.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Points on either side of the contour at which colours are read, half a pixel of the picture that
 * was worked on from one to the next; and how many neighbours smooth. */
enum { REACH = 8, SAMPLES = 2 * REACH + 1, SMOOTH = 3, MEDIAN = 5 };

static const double least_contrast = 12; /* of 441, the length of black to white */

/* ---- the contour, evenly -----------------------------------------------------------------------
 */

static long wrap(long k, long count) {
  return ((k % count) + count) % count;
}

/* Means of neighbours take the stairs out of it: they shift it by less than a pixel at corners. */
static tp_status smooth(tp_trace_ring *ring, const tp_picture_region *region, tp_message *message) {
  const tp_trace_ring *from = &region->contour;
  for (long k = 0; k < from->count; k++) {
    tp_trace_point sum = {0, 0};
    for (long n = -SMOOTH; n <= SMOOTH; n++) {
      const tp_trace_point p = from->points[wrap(k + n, from->count)];
      sum.x += p.x / (2 * SMOOTH + 1);
      sum.y += p.y / (2 * SMOOTH + 1);
    }
    if (!tp_trace_ring_add(ring, sum)) return tp_fail_memory(message, "an outline");
  }
  return TP_OK;
}

/* Outwards: to the left of a clockwise chain, as it is seen. */
static tp_trace_point normal(const tp_trace_ring *ring, long k) {
  const tp_trace_point a = ring->points[wrap(k - SMOOTH, ring->count)];
  const tp_trace_point b = ring->points[wrap(k + SMOOTH, ring->count)];
  const double length = hypot(b.x - a.x, b.y - a.y);
  return length > 0 ? (tp_trace_point){(b.y - a.y) / length, (a.x - b.x) / length}
                    : (tp_trace_point){0, 0};
}

/* ---- across the edge ---------------------------------------------------------------------------
 */

/* The colour at a place, between the middles of four pixels; at the border that of the border. */
static void colour_at(double colour[3], const tp_trace_picture *picture, tp_trace_point at) {
  const double x = fmin(fmax(at.x - 0.5, 0), picture->width - 1);
  const double y = fmin(fmax(at.y - 0.5, 0), picture->height - 1);
  const int left = (int)x, top = (int)y;
  const int right = left + 1 < picture->width ? left + 1 : left;
  const int bottom = top + 1 < picture->height ? top + 1 : top;
  const double u = x - left, v = y - top;
  for (int c = 0; c < 3; c++) {
    const size_t w = (size_t)picture->width;
    const double upper = (1 - u) * picture->rgb[3 * (top * w + left) + c] +
                         u * picture->rgb[3 * (top * w + right) + c];
    const double lower = (1 - u) * picture->rgb[3 * (bottom * w + left) + c] +
                         u * picture->rgb[3 * (bottom * w + right) + c];
    colour[c] = (1 - v) * upper + v * lower;
  }
}

/* Where between inside (0) and outside (1) each sample lies. False: they are too much alike. */
static bool read_profile(double profile[SAMPLES], const tp_trace_picture *picture,
                         tp_trace_point at, tp_trace_point out, double step) {
  double colours[SAMPLES][3], axis[3], inside[3] = {0}, size = 0;
  for (int k = 0; k < SAMPLES; k++) {
    const double way = (k - REACH) * step;
    colour_at(colours[k], picture, (tp_trace_point){at.x + way * out.x, at.y + way * out.y});
  }
  for (int c = 0; c < 3; c++) {
    axis[c] = 0;
    for (int k = 0; k < REACH / 2; k++) {
      inside[c] += colours[k][c] / (REACH / 2.0);
      axis[c] += colours[SAMPLES - 1 - k][c] / (REACH / 2.0);
    }
    axis[c] -= inside[c];
    size += axis[c] * axis[c];
  }
  if (size < least_contrast * least_contrast) return false;
  for (int k = 0; k < SAMPLES; k++) {
    profile[k] = 0;
    for (int c = 0; c < 3; c++) profile[k] += (colours[k][c] - inside[c]) * axis[c] / size;
  }
  return true;
}

/* Where the profile passes a level, in samples from the contour, nearest to it; NAN: nowhere. */
static double passes(const double profile[SAMPLES], double level) {
  double best = NAN;
  for (int k = 0; k + 1 < SAMPLES; k++) {
    const double a = profile[k], b = profile[k + 1];
    if ((a < level) == (b < level)) continue;
    const double at = k - REACH + (level - a) / (b - a);
    if (isnan(best) || fabs(at) < fabs(best)) best = at;
  }
  return best;
}

/* ---- the whole outline -------------------------------------------------------------------------
 */

static int compare(const void *a, const void *b) {
  const double one = *(const double *)a, other = *(const double *)b;
  return (one > other) - (one < other);
}

static double median(double *values, long count) {
  qsort(values, (size_t)count, sizeof *values, compare);
  return count == 0 ? 0 : values[count / 2];
}

/* Each by the median of itself and its neighbours: a speck of the picture moves nothing. */
static void move_points(tp_refined *refined, const double *middles, const tp_trace_point *normals) {
  tp_trace_ring *ring = &refined->ring;
  double squares = 0;
  for (long k = 0; k < ring->count; k++) {
    double near[2 * MEDIAN + 1];
    for (long n = -MEDIAN; n <= MEDIAN; n++) {
      near[n + MEDIAN] = middles[wrap(k + n, ring->count)];
    }
    const double own = median(near, 2 * MEDIAN + 1);
    ring->points[k].x += own * normals[k].x;
    ring->points[k].y += own * normals[k].y;
    squares += own * own;
  }
  refined->shift_px = sqrt(squares / (double)ring->count);
}

static void find_edges(tp_refined *refined, const tp_trace_picture *picture, double step,
                       double *middles, tp_trace_point *normals) {
  const tp_trace_ring *ring = &refined->ring;
  long found = 0;
  for (long k = 0; k < ring->count; k++) {
    double profile[SAMPLES];
    normals[k] = normal(ring, k);
    middles[k] = 0;
    if (!read_profile(profile, picture, ring->points[k], normals[k], step)) continue;
    const double middle = passes(profile, 0.5);
    if (isnan(middle)) continue;
    middles[k] = middle * step;
    found++;
  }
  refined->weak = 1 - (double)found / (double)ring->count;
}

/* Half of the way from 16 to 84 per cent of the change in the mean of all profiles about the
 * outline as it was moved, in which noise falls away: one standard deviation where the blur is
 * Gaussian. */
static void find_spread(tp_refined *refined, const tp_trace_picture *picture, double step,
                        const tp_trace_point *normals) {
  const tp_trace_ring *ring = &refined->ring;
  double sum[SAMPLES] = {0}, profile[SAMPLES];
  long count = 0;
  for (long k = 0; k < ring->count; k++) {
    if (!read_profile(profile, picture, ring->points[k], normals[k], step)) continue;
    for (int n = 0; n < SAMPLES; n++) sum[n] += profile[n];
    count++;
  }
  for (int n = 0; n < SAMPLES && count > 0; n++) sum[n] /= (double)count;
  const double spread = count > 0 ? fabs(passes(sum, 0.8413) - passes(sum, 0.1587)) / 2 : NAN;
  /* where nothing changes the edge may be anywhere within reach */
  refined->edge_px = step * (isnan(spread) ? REACH : spread);
}

tp_status tp_refine(tp_refined *refined, const tp_picture_region *region,
                    const tp_trace_picture *picture, tp_message *message) {
  const size_t count = (size_t)region->contour.count;
  *refined = (tp_refined){0};
  tp_status status = smooth(&refined->ring, region, message);
  double *middles = calloc(count, sizeof *middles);
  tp_trace_point *normals = calloc(count, sizeof *normals);
  if (status == TP_OK && (middles == NULL || normals == NULL)) {
    status = tp_fail_memory(message, "an outline");
  }
  if (status == TP_OK) {
    find_edges(refined, picture, region->step / 2.0, middles, normals);
    move_points(refined, middles, normals);
    find_spread(refined, picture, region->step / 2.0, normals);
  } else {
    tp_trace_ring_clear(&refined->ring);
  }
  free(middles);
  free(normals);
  return status;
}
