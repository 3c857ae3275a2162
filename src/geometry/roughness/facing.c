/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The facets that a block must climb, and Grasselli's measure of them in two dimensions (Tatone and
 * Grasselli, Int. J. Rock Mech. Min. Sci. 47 (2010) 1391-1400). The share of the length along the
 * profile whose angle against the slide is theta or more is fitted by
 *   L(theta) = L(0) (1 - theta / theta*max)^C,
 * C >= 0 of least squares over 200 thresholds, amid as many equal parts of 0 ... theta*max. The
 * integral of L is the mean angle of facing facets; of the fit it is L(0) theta*max / (C + 1), so
 * that this measure is a mean angle where the fit is good, and i of teeth, where C = 0. C is a zero
 * of the derivative, by number/root.h; it is a fit, and has no bound but what it leaves. */

#include "number/binary.h"
#include "number/root.h"
#include "roughness/slopes.h"

enum { THRESHOLDS = 200, MOST_SAMPLES = 200 };
static const double largest_exponent = 1000;

typedef struct shares {
  double at[THRESHOLDS]; /* of the threshold amid each part, over L(0) */
} shares;

typedef struct facing_sums {
  tp_bounded_sum rise, run, length;
  double steepest, at_least, at_most; /* a slope */
  size_t facets;
} facing_sums;

/* A facet that is level but for its bound may face either side, and counts as an error of both. One
 * whose rise is lost in rounding altogether is level. */
static void add_open(facing_sums sums[2], double rise, double run, double length) {
  for (int d = 0; d < 2; d++) {
    sums[d].rise.error += rise;
    sums[d].run.error += run;
    sums[d].length.error += length;
  }
}

static void sum_facing(facing_sums sums[2], const tp_course *p) {
  for (size_t k = 1; k < p->count; k++) {
    const double dx = p->x[k] - p->x[k - 1], up = p->y[k] - p->y[k - 1], dy = fabs(up);
    if (dy == 0) continue;
    facing_sums *s = sums + (up > 0 ? TP_TOWARDS_RIGHT : TP_TOWARDS_LEFT);
    const double of_dx = 2 * p->x_error + tp_roundoff * dx;
    const double of_dy = 2 * p->y_error + tp_roundoff * dy, length = sqrt(dx * dx + dy * dy);
    const double slope = dy / dx;
    const double of_slope = (of_dy + slope * of_dx) / (dx - of_dx) + tp_roundoff * slope;
    tp_bounded_add(&s->rise, dy, of_dy);
    tp_bounded_add(&s->run, dx, of_dx);
    tp_bounded_add(&s->length, length, of_dx + of_dy + 3 * tp_roundoff * length);
    s->steepest = tp_larger(s->steepest, slope);
    s->at_least = tp_larger(s->at_least, slope - of_slope);
    s->at_most = tp_larger(s->at_most, slope + of_slope);
    s->facets++;
    if (dy <= of_dy) add_open(sums, dy, dx, length);
  }
}

/* Each facet counts for the thresholds that its angle reaches: these lie at parts of `widest`. */
static void find_shares(shares own[2], const tp_course *p, const facing_sums sums[2]) {
  double reached[2][THRESHOLDS + 1] = {{0}};
  const double parts[2] = {THRESHOLDS / atan(sums[0].steepest),
                           THRESHOLDS / atan(sums[1].steepest)};
  for (size_t k = 1; k < p->count; k++) {
    const double dx = p->x[k] - p->x[k - 1], up = p->y[k] - p->y[k - 1];
    if (up == 0) continue;
    const int side = up > 0 ? TP_TOWARDS_RIGHT : TP_TOWARDS_LEFT;
    const double at = atan(fabs(up) / dx) * parts[side] + 0.5;
    const size_t count = at < THRESHOLDS ? (size_t)at : THRESHOLDS;
    reached[side][count] += sqrt(dx * dx + up * up);
  }
  for (int side = 0; side < 2; side++) {
    double above = 0;
    for (int j = THRESHOLDS - 1; j >= 0; j--) {
      above += reached[side][j + 1];
      own[side].at[j] = above / sums[side].length.sum;
    }
  }
}

/* Half the derivative of the sum of (l - t^C)^2 by C, t = 1 - theta / theta*max. */
static bool derivative(double *value, void *context, double exponent) {
  const shares *own = context;
  *value = 0;
  for (int j = 0; j < THRESHOLDS; j++) {
    const double t = 1 - (j + 0.5) / THRESHOLDS, fitted = pow(t, exponent);
    *value -= (own->at[j] - fitted) * fitted * log(t);
  }
  return true;
}

static double fit(shares *own, double *left) {
  const tp_root_search search = {
      .value = derivative, .context = own, .width = 1e-12, .most = MOST_SAMPLES};
  tp_root_end low = {.x = 0}, high = {.x = largest_exponent};
  tp_root root = {0, 0, true};
  double exponent = 0, squares = 0;
  (void)derivative(&low.value, own, low.x);
  (void)derivative(&high.value, own, high.x);
  /* the sum falls from 0 on, but where all facets are alike, and 0 is best */
  if (tp_root_find(&root, &search, low, high)) {
    exponent = root.low + (root.high - root.low) / 2;
  } else if (high.value < 0) {
    exponent = largest_exponent;
  }
  for (int j = 0; j < THRESHOLDS; j++) {
    const double away = own->at[j] - pow(1 - (j + 0.5) / THRESHOLDS, exponent);
    squares += away * away;
  }
  *left = sqrt(squares / THRESHOLDS);
  return exponent;
}

void tp_slopes_facing(tp_profile_facing facing[2], const tp_course *p, tp_bounded along) {
  facing_sums sums[2] = {{.facets = 0}, {.facets = 0}};
  shares own[2];
  sum_facing(sums, p);
  find_shares(own, p, sums);
  for (int d = 0; d < 2; d++) {
    const facing_sums *s = sums + d;
    tp_profile_facing *f = facing + d;
    *f = (tp_profile_facing){.facets = s->facets,
                             .share = tp_bounded_over(tp_bounded_total(s->length), along)};
    if (s->facets == 0) continue;
    f->angle_deg =
        tp_bounded_atan_deg(tp_bounded_over(tp_bounded_total(s->rise), tp_bounded_total(s->run)));
    f->steepest_deg = tp_bounded_atan_deg(
        tp_bounded_of(s->steepest, fmax(s->at_most - s->steepest, s->steepest - s->at_least)));
    double left;
    f->exponent = fit(own + d, &left);
    f->fit_rms = left * f->share.value;
    f->roughness_deg = f->steepest_deg.value / (f->exponent + 1);
  }
}
