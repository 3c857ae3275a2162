/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The mean plane is the line of least squares across the line between both ends, as of a contact
 * (base/mean_plane.h): with a along that line and b normal to it b = m a + c with the least
 * integral of its squared distance over |da|. It is found in doubles, and these, u and v, are the
 * direction by definition: x' = (u x + v y) / h, y' = (u y - v x) / h, h = sqrt(u^2 + v^2). In
 * units u of roundoff: u / h is off by 4, a difference of coordinates by 3 and, scaled, by 4,
 * products and sum by 2 more, of a size up to |x| + |y|: 12 in all. */

#include "roughness/turn.h"

#include "number/binary.h"

#include <math.h>

typedef struct sums {
  double length, a, b, aa, ab; /* of |da| times 1, a, b, a^2, a b */
} sums;

static void add(sums *s, double a0, double b0, double a1, double b1) {
  const double run = fabs(a1 - a0);
  s->length += run;
  s->a += run * (a0 + a1) / 2;
  s->b += run * (b0 + b1) / 2;
  s->aa += run * (a0 * a0 + a0 * a1 + a1 * a1) / 3;
  s->ab += run * (2 * a0 * b0 + a0 * b1 + a1 * b0 + 2 * a1 * b1) / 6;
}

/* Of the points in doubles: unlike 0 where they have one. */
static void find_direction(double *u, double *v, const tp_course *p) {
  const size_t last = p->count - 1;
  const double far = hypot(p->x[last], p->y[last]);
  const double along = p->x[last] / far, up = p->y[last] / far;
  sums s = {0};
  for (size_t k = 1; k < p->count && far > 0; k++) {
    add(&s, along * p->x[k - 1] + up * p->y[k - 1], along * p->y[k - 1] - up * p->x[k - 1],
        along * p->x[k] + up * p->y[k], along * p->y[k] - up * p->x[k]);
  }
  const double m = far > 0 ? (s.ab - s.a * s.b / s.length) / (s.aa - s.a * s.a / s.length) : NAN;
  *u = along - m * up;
  *v = up + m * along;
}

/* False where a coordinate is out of range. */
static bool turn(tp_course *p, double u, double v) {
  const double h = sqrt(u * u + v * v), along = u / h, up = v / h;
  double far = 0;
  for (size_t k = 0; k < p->count; k++) {
    const double x = p->x[k], y = p->y[k];
    p->x[k] = along * x + up * y;
    p->y[k] = along * y - up * x;
    far = tp_larger(far, fabs(x) + fabs(y));
  }
  p->x_error = p->y_error = 12 * tp_roundoff * far * tp_room;
  return isfinite(far);
}

static tp_status check(const tp_course *p, const tp_polyline *chain, double angle_deg,
                       tp_message *message) {
  for (size_t k = 1; k < p->count; k++) {
    if (p->x[k] - p->x[k - 1] > 4 * p->x_error) continue;
    return tp_refuse(
        message, TP_FAULT_GEOMETRY, tp_polyline_place(chain, (long)k),
        "turned onto its mean plane, by %.4g°, the profile folds back or steps upright: "
        "point %zu does not lie right of point %zu along it",
        angle_deg, k + 1, k);
  }
  return TP_OK;
}

tp_status tp_course_turned(tp_course *course, tp_bounded *turned_deg, const tp_polyline *chain,
                           double scale, tp_message *message) {
  *course = (tp_course){0};
  if (chain->count < 2) {
    return tp_refuse(message, TP_FAULT_RANGE, tp_polyline_place(chain, -1),
                     "a profile needs at least two points");
  }
  if (!tp_course_init(course, (size_t)chain->count)) return tp_fail_memory(message, "the profile");
  tp_course_convert(course, chain, scale);
  double u = 0, v = 0;
  find_direction(&u, &v, course);
  tp_status status = TP_OK;
  if (!(u > 0) || !isfinite(v / u) || !turn(course, u, v)) {
    status = tp_refuse(message, TP_FAULT_GEOMETRY, tp_polyline_place(chain, -1),
                       "the profile has no mean plane that runs from left to right, or is out of "
                       "the range of doubles");
  } else {
    *turned_deg = tp_bounded_atan_deg(tp_bounded_of(v / u, tp_roundoff * fabs(v / u)));
    status = check(course, chain, turned_deg->value, message);
  }
  if (status == TP_OK) {
    tp_course_measure(course);
  } else {
    tp_course_clear(course);
  }
  return status;
}
