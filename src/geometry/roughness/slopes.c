/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Sums over the facets from (x, y) to (x + dx, y + dy), L the sum of dx:
 *   Z2^2 = (1/L) sum dy^2/dx, Eq. (13) with its root (Myers 1962); mean size of the slope (1/L) sum
 *   |dy|; Rp = (1/L) sum sqrt(dx^2 + dy^2) (El-Soudani 1978); SF = (1/L) sum dy^2 dx (Sayles and
 *   Thomas 1977); RMS height^2 = (1/L) sum dx (a^2 + ab + b^2)/3, a and b the heights at both ends
 *   above the mean: the integral of the squared height over the chain itself.
 * With e and f the bounds of an abscissa and a height, dx is off by 2 e + u dx and dy by 2 f + u
 * |dy|; the terms' errors follow to second order, sums are bounded by bounded.h. */

#include "roughness/slopes.h"

/* A difference of two coordinates that are off by `error` each. */
static tp_bounded difference(double from, double to, double error) {
  const double value = to - from;
  return tp_bounded_of(value, 2 * error + tp_roundoff * fabs(value));
}

typedef struct facet_sums {
  tp_bounded_sum along, absolute, squares, sf, area;
  double low, high;
} facet_sums;

static facet_sums sum_facets(const tp_course *p) {
  facet_sums s = {.low = p->y[0], .high = p->y[0]};
  for (size_t k = 1; k < p->count; k++) {
    const tp_bounded dx = difference(p->x[k - 1], p->x[k], p->x_error);
    const tp_bounded dy = difference(p->y[k - 1], p->y[k], p->y_error);
    const double rise = fabs(dy.value), square = rise * rise;
    const double of_square = (2 * rise + dy.error) * dy.error + tp_roundoff * square;
    const double steep = square / dx.value, least = dx.value - dx.error;
    const double length = sqrt(dx.value * dx.value + square);
    tp_bounded_add(&s.along, length, dx.error + dy.error + 3 * tp_roundoff * length);
    tp_bounded_add(&s.absolute, rise, dy.error);
    tp_bounded_add(&s.squares, steep, (of_square + steep * dx.error) / least + tp_roundoff * steep);
    tp_bounded_add(&s.sf, square * dx.value,
                   of_square * (dx.value + dx.error) + square * dx.error +
                       tp_roundoff * square * dx.value);
    const double middle = (p->y[k - 1] + p->y[k]) / 2;
    tp_bounded_add(&s.area, dx.value * middle,
                   dx.value * p->y_error + fabs(middle) * dx.error + dx.error * p->y_error +
                       3 * tp_roundoff * dx.value * fabs(middle));
    s.low = fmin(s.low, p->y[k]);
    s.high = fmax(s.high, p->y[k]);
  }
  return s;
}

static tp_bounded rms_height(const tp_course *p, tp_bounded mean, tp_bounded length) {
  const double off = p->y_error + mean.error;
  tp_bounded_sum sum = {0, 0};
  for (size_t k = 1; k < p->count; k++) {
    const tp_bounded dx = difference(p->x[k - 1], p->x[k], p->x_error);
    const double a = p->y[k - 1] - mean.value, b = p->y[k] - mean.value;
    const double size = fabs(a) + fabs(b), each = off + tp_roundoff * size;
    const double third = (a * a + a * b + b * b) / 3;
    const double of_third = (size + each) * each + 4 * tp_roundoff * size * size;
    tp_bounded_add(&sum, dx.value * third,
                   (dx.value + dx.error) * of_third + third * dx.error +
                       tp_roundoff * dx.value * third);
  }
  return tp_bounded_root(tp_bounded_over(tp_bounded_total(sum), length));
}

tp_slopes tp_slopes_measure(const tp_course *p) {
  const size_t last = p->count - 1;
  const facet_sums sums = sum_facets(p);
  tp_slopes s;
  s.length = tp_bounded_of(p->x[last], p->x_error);
  s.along = tp_bounded_total(sums.along);
  s.amplitude =
      tp_bounded_of(sums.high - sums.low, 2 * p->y_error + tp_roundoff * (sums.high - sums.low));
  s.mean_height = tp_bounded_over(tp_bounded_total(sums.area), s.length);
  s.rms_height = rms_height(p, s.mean_height, s.length);
  s.mean_slope = tp_bounded_over(difference(p->y[0], p->y[last], p->y_error), s.length);
  s.absolute_slope = tp_bounded_over(tp_bounded_total(sums.absolute), s.length);
  s.z2 = tp_bounded_root(tp_bounded_over(tp_bounded_total(sums.squares), s.length));
  s.effective_angle_deg = tp_bounded_atan_deg(s.absolute_slope);
  s.rp = tp_bounded_over(s.along, s.length);
  s.sf = tp_bounded_over(tp_bounded_total(sums.sf), s.length);
  return s;
}
