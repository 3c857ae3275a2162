/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The direction of a vector in double arithmetic.
 *
 * Method: of the sizes a <= b of the two, c is the multiple of 1/16 nearest to a / b; then
 * atan(a / b) = atan(c) + atan(r), r = (a - c b) / (b + c a), |r| <= 1/31, by a table and by the
 * odd series up to r^11.
 *
 * Bound (w = 2^-53): the numerator errs by w c b + w |a - c b|, so r by w c + 4.1 w |r|; of the
 * series' own roundings 1.2 w |r| are left, and r^13 / 13 is below 0.001 w |r|. With half a unit of
 * the table, w atan(c), and that of the sum, w atan(a / b), all of it is at most w (c + atan(c) +
 * 5.4 |r| + atan(a / b)). For c = 0 that is 6.4 w atan(a / b); else atan(a / b) >= atan(c - 1/32),
 * and it is at most 11 w atan(a / b), the most where c = 1/16. Degrees take a product and the
 * rounding of 180 / pi, 2.1 w; the quadrant two subtractions, from 90 and from 180, each of which
 * leaves no less than it takes off: w each. All together 16 w = 2^-49. Underflow: between 2^-450
 * and 2^450 none but of what is lost beside far larger terms. */

#include "number/arctangent.h"

#include <math.h>

/* atan of the multiples of 1/16. */
static const double of_sixteenths[] = {0x0.0p+0,
                                       0x1.ff55bb72cfdeap-5,
                                       0x1.fd5ba9aac2f6ep-4,
                                       0x1.7b97b4bce5b02p-3,
                                       0x1.f5b75f92c80ddp-3,
                                       0x1.362773707ebccp-2,
                                       0x1.6f61941e4def1p-2,
                                       0x1.a64eec3cc23fdp-2,
                                       0x1.dac670561bb4fp-2,
                                       0x1.0657e94db30d0p-1,
                                       0x1.1e00babdefeb4p-1,
                                       0x1.345f01cce37bbp-1,
                                       0x1.4978fa3269ee1p-1,
                                       0x1.5d58987169b18p-1,
                                       0x1.700a7c5784634p-1,
                                       0x1.819d0b7158a4dp-1,
                                       0x1.921fb54442d18p-1};

static const double degrees_per_radian = 0x1.ca5dc1a63c1f8p+5;

/* atan(r) for |r| <= 1/31. */
static double of_small(double r) {
  const double z = r * r;
  return r - r * z * (1. / 3 - z * (1. / 5 - z * (1. / 7 - z * (1. / 9 - z * (1. / 11)))));
}

double tp_arctangent_degrees(double y, double x) {
  const double up = fabs(y), along = fabs(x);
  const double a = up < along ? up : along, b = up < along ? along : up;
  const int sixteenth = (int)(16 * (a / b) + 0.5);
  const double c = sixteenth / 16.;
  const double r = (a - c * b) / (b + c * a);
  double degrees = (of_sixteenths[sixteenth] + of_small(r)) * degrees_per_radian;
  if (up > along) degrees = 90 - degrees;
  if (x < 0) degrees = 180 - degrees;
  return copysign(degrees, y);
}
