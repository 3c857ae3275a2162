/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The axis of a twist, and which contacts it leaves where they are. */

#include "solid_tilt/contact_motion.h"

#include "solid/tilting.h"

#include <math.h>

static double length(const double v[3]) {
  return sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

/* Of all motion, what counts for none: a motion is found to the root of the bound of its limit. */
static const double still = 1e-4;

static int count_still(const tp_friction_cones *cones, const double twist[TP_WRENCH]) {
  double most = length(twist);
  int count = 0;
  for (int pass = 0; pass < 2; pass++) {
    for (long n = 0; n < cones->count; n++) {
      double motion[3];
      tp_friction_cone_motion(motion, cones->cones + n, twist);
      if (pass == 0) most = fmax(most, length(motion));
      if (pass == 1) count += length(motion) <= still * most;
    }
  }
  return count;
}

/* Zero, where it is that for doubles of a size. */
static double settled(double number, double size) {
  static const double digits = 1e-11;
  return fabs(number) <= digits * size ? 0 : number;
}

void tp_contact_motion(tp_solid_motion *own, const tp_contact_points *points,
                       const tp_surface *surface, const fmpq_t metres_per_unit,
                       const double twist[TP_WRENCH]) {
  const double *v = twist, *turn = twist + 3;
  const double speed = length(v), rate = length(turn);
  *own = (tp_solid_motion){.mechanism = TP_SLIDES, .turns = rate > still * speed};
  for (int k = 0; k < 3; k++) {
    own->axis[k] = settled(own->turns ? turn[k] / rate : v[k] / speed, 1);
  }
  if (!own->turns) return;
  own->mechanism = count_still(&points->cones, twist) > 1 ? TP_TOPPLES : TP_SLIDES_AND_TOPPLES;
  double foot[3];
  for (int k = 0; k < 3; k++) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    foot[k] = (turn[i] * v[j] - turn[j] * v[i]) / (rate * rate);
    own->pitch_m += turn[k] * v[k] / (rate * rate) * points->metres;
  }
  own->pitch_m = settled(own->pitch_m, points->metres);
  tp_contact_points_given(own->at, points, surface, foot);
  const double size = points->metres / tp_surface_nearest(metres_per_unit);
  for (int k = 0; k < 3; k++) own->at[k] = settled(own->at[k], size);
}
