/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Area, centroid and second moments of one outline in doubles, with a proven bound.
 *
 * Method: the sums of block/ring_sums.h about an origin o amid the outline, in a scale s, a power
 * of two: with A2, X6, … and q = X6 / A2, r = Y6 / A2
 *     area = |A2| / (2 s^2),   centroid = o + (q, r) / (3 s),
 *     Jxx = |XX12 / 12 - q X6 / 18| / s^4, Jyy likewise, Jxy = ±(XY24 / 24 - q Y6 / 18) / s^4.
 *
 * Bound (w = 2^-53), with e_A the error of A2, e_X of X6 …: a quotient n / d of what is known to
 * within e_n and e_d < |d| lies within (e_n + |n / d| e_d) / (|d| - e_d) of the truth, and its own
 * rounding adds w |n / d|. A product of factors known to within e and f errs by |a| f + |b| e + e
 * f, and by w of itself. Every error is estimated in a few operations, each rounded, and taken with
 * a margin of 1e-12 of itself; powers of two are exact. */

#include "batch/area.h"

#include <math.h>

static const double unit = 0x1p-53, margin = 1 + 1e-12;

static tp_bounded bounded(double value, double error) {
  return (tp_bounded){.value = value, .error = margin * error};
}

static tp_bounded quotient(tp_bounded n, tp_bounded d) {
  const double value = n.value / d.value, size = fabs(value);
  return bounded(value, (n.error + size * d.error) / (fabs(d.value) - d.error) + 2 * unit * size);
}

static tp_bounded product(tp_bounded a, tp_bounded b) {
  const double value = a.value * b.value;
  return bounded(value, fabs(a.value) * b.error + fabs(b.value) * a.error + a.error * b.error +
                            unit * fabs(value));
}

/* a / divisor - b / 18. */
static tp_bounded about_centroid(tp_bounded a, double divisor, tp_bounded b) {
  const double first = a.value / divisor, second = b.value / 18, value = first - second;
  return bounded(value, a.error / divisor + b.error / 18 +
                            unit * (fabs(first) + fabs(second) + fabs(value)));
}

/* Times a power of two, and the sign of the way round. */
static tp_bounded scaled(tp_bounded number, double factor) {
  return (tp_bounded){.value = number.value * factor, .error = number.error * fabs(factor)};
}

/* offset / (3 scale), and that from an origin. */
static tp_bounded third(tp_bounded offset, double scale) {
  const double value = offset.value / 3 / scale;
  return bounded(value, offset.error / 3 / scale + unit * fabs(value));
}

static tp_bounded placed(double origin, tp_bounded offset) {
  const double value = origin + offset.value;
  return bounded(value, offset.error + unit * fabs(value));
}

static bool is_in_range(const tp_area_moments *m) {
  return isfinite(m->second_moment_xx.value + m->second_moment_xx.error) &&
         isfinite(m->second_moment_yy.value + m->second_moment_yy.error) &&
         isfinite(m->second_moment_xy.value + m->second_moment_xy.error);
}

/* The origin of the centre is that of the scan. */
static tp_status take(tp_area_moments *moments, tp_area_centre *centre, const tp_scan *scan,
                      double scale) {
  double sums[TP_SUM_COUNT], errors[TP_SUM_COUNT];
  tp_bounded own[TP_SUM_COUNT];
  tp_ring_sums_double_first(sums, errors, scan->u, scan->v, scan->count, false,
                            (tp_sums_plan){.sum_count = TP_SUM_COUNT, .threads = 1});
  for (int k = 0; k < TP_SUM_COUNT; k++) own[k] = (tp_bounded){sums[k], errors[k], NULL};
  if (!(fabs(sums[TP_A2]) > 1e6 * errors[TP_A2])) return TP_UNDECIDED;
  const double sign = sums[TP_A2] > 0 ? 1 : -1, area_scale = sign / scale / scale;
  const double second_scale = area_scale / scale / scale;
  const tp_bounded x = quotient(own[TP_X6], own[TP_A2]), y = quotient(own[TP_Y6], own[TP_A2]);
  const tp_bounded xx = about_centroid(own[TP_XX12], 12, product(x, own[TP_X6]));
  const tp_bounded yy = about_centroid(own[TP_YY12], 12, product(y, own[TP_Y6]));
  const tp_bounded xy = about_centroid(own[TP_XY24], 24, product(x, own[TP_Y6]));
  centre->x = third(x, scale);
  centre->y = third(y, scale);
  *moments = (tp_area_moments){.area = scaled(own[TP_A2], area_scale / 2),
                               .centroid_x = placed(centre->origin_x, centre->x),
                               .centroid_y = placed(centre->origin_y, centre->y),
                               .second_moment_xx = scaled(xx, second_scale),
                               .second_moment_yy = scaled(yy, second_scale),
                               .second_moment_xy = scaled(xy, second_scale)};
  return is_in_range(moments) ? TP_OK : TP_UNDECIDED;
}

/* Is a power of it far from the ends of the range of doubles? */
static bool is_moderate(double scale) {
  return scale >= 1e-60 && scale <= 1e60;
}

tp_status tp_area_filter(tp_area_moments *moments, tp_area_centre *centre, tp_workspace *workspace,
                         tp_vertices vertices, const tp_scan_kernel *kernel, tp_message *message) {
  if (vertices.count < 3) return TP_UNDECIDED;
  tp_scan scan;
  if (!tp_scan_read(&scan, workspace, vertices, kernel)) {
    return tp_fail_memory(message, "the vertices");
  }
  const double scale = tp_scan_scale(&scan);
  if (!is_moderate(scale)) return TP_UNDECIDED;
  centre->origin_x = scan.least_x + (scan.most_x - scan.least_x) / 2;
  centre->origin_y = scan.least_y + (scan.most_y - scan.least_y) / 2;
  tp_scan_shift(&scan, centre->origin_x, centre->origin_y, scale, kernel);
  return take(moments, centre, &scan, scale);
}
