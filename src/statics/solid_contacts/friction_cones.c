/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Columns, motions and signs of cones. */

#include "solid_contacts/friction_cones.h"

#include <math.h>
#include <stdlib.h>

bool tp_friction_cones_init(tp_friction_cones *cones, long count) {
  *cones = (tp_friction_cones){.cones = calloc((size_t)count + 1, sizeof *cones->cones)};
  if (cones->cones == NULL) return false;
  for (; cones->count < count; cones->count++) {
    for (int k = 0; k < 3; k++) {
      fmpq_init(cones->cones[cones->count].at + k);
      fmpq_init(cones->cones[cones->count].normal + k);
    }
  }
  return true;
}

void tp_friction_cones_clear(tp_friction_cones *cones) {
  for (long n = 0; n < cones->count; n++) {
    for (int k = 0; k < 3; k++) {
      fmpq_clear(cones->cones[n].at + k);
      fmpq_clear(cones->cones[n].normal + k);
    }
  }
  free(cones->cones);
  *cones = (tp_friction_cones){.count = 0};
}

static tp_near rounded(const fmpq_t number) {
  const double value = fmpq_get_d(number);
  return fmpq_is_zero(number) ? (tp_near){0, 0} : tp_near_of(value, fabs(value) * DBL_EPSILON);
}

/* A normal may be of any length: a power of two brings it to about one. */
static void settle_normal(tp_friction_cone *cone) {
  fmpq_t part;
  slong most = WORD_MIN;
  fmpq_init(part);
  for (int k = 0; k < 3; k++) {
    const fmpq *own = cone->normal + k;
    if (fmpq_is_zero(own)) continue;
    const slong bits = (slong)fmpz_bits(fmpq_numref(own)) - (slong)fmpz_bits(fmpq_denref(own));
    if (bits > most) most = bits;
  }
  double length = 0;
  for (int k = 0; k < 3; k++) {
    if (most >= 0) {
      fmpq_div_2exp(part, cone->normal + k, (ulong)most);
    } else {
      fmpq_mul_2exp(part, cone->normal + k, (ulong)-most);
    }
    cone->near_normal[k] = rounded(part);
    length = hypot(length, cone->near_normal[k].value);
  }
  for (int k = 0; k < 3; k++) cone->unit[k] = cone->near_normal[k].value / length;
  fmpq_clear(part);
}

void tp_friction_cone_settle(tp_friction_cone *cone, tp_near friction) {
  for (int k = 0; k < 3; k++) cone->near_at[k] = rounded(cone->at + k);
  settle_normal(cone);
  cone->friction = friction;
}

void tp_friction_cone_column(double column[TP_WRENCH], const tp_friction_cone *cone,
                             const double force[3]) {
  for (int k = 0; k < 3; k++) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    column[k] = force[k];
    column[3 + k] = cone->near_at[i].value * force[j] - cone->near_at[j].value * force[i];
  }
}

void tp_friction_cone_motion(double motion[3], const tp_friction_cone *cone,
                             const double twist[TP_WRENCH]) {
  for (int k = 0; k < 3; k++) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    motion[k] =
        twist[k] + twist[3 + i] * cone->near_at[j].value - twist[3 + j] * cone->near_at[i].value;
  }
}

double tp_friction_cone_worst(double force[3], const tp_friction_cone *cone, const double motion[3],
                              double friction) {
  const double *n = cone->unit;
  const double along = motion[0] * n[0] + motion[1] * n[1] + motion[2] * n[2];
  double slip[3];
  for (int k = 0; k < 3; k++) slip[k] = motion[k] - along * n[k];
  const double speed = sqrt(slip[0] * slip[0] + slip[1] * slip[1] + slip[2] * slip[2]);
  const double mu = speed > 0 ? friction * cone->friction.value : 0;
  for (int k = 0; k < 3; k++) force[k] = n[k] - (speed > 0 ? mu * slip[k] / speed : 0);
  return along - mu * speed;
}

/* ---- signs -------------------------------------------------------------------------------------
 */

static tp_near dot(const tp_near a[3], const tp_near b[3]) {
  return tp_near_plus(tp_near_plus(tp_near_times(a[0], b[0]), tp_near_times(a[1], b[1])),
                      tp_near_times(a[2], b[2]));
}

static void cross(tp_near product[3], const tp_near a[3], const tp_near b[3]) {
  for (int k = 0; k < 3; k++) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    product[k] = tp_near_minus(tp_near_times(a[i], b[j]), tp_near_times(a[j], b[i]));
  }
}

/* Is p^2 (n . x)^2 - q^2 |n x x|^2 certainly not below zero, and n . x not? */
static bool is_within(const tp_near n[3], const tp_near x[3], tp_near p, tp_near q) {
  tp_near across[3];
  cross(across, n, x);
  const tp_near along = tp_near_times(p, dot(n, x));
  const tp_near reach = tp_near_times(tp_near_times(q, q), dot(across, across));
  const tp_near rest = tp_near_minus(tp_near_times(along, along), reach);
  return along.value >= along.error && rest.value >= rest.error;
}

bool tp_friction_cone_holds(const tp_friction_cone *cone, const tp_near force[3], tp_near share) {
  return is_within(cone->near_normal, force, tp_near_times(cone->friction, share), (tp_near){1, 0});
}

bool tp_friction_cone_lets(const tp_friction_cone *cone, const double twist[TP_WRENCH],
                           tp_near share) {
  tp_near turn[3], motion[3];
  for (int k = 0; k < 3; k++) turn[k] = (tp_near){twist[3 + k], 0};
  cross(motion, turn, cone->near_at);
  for (int k = 0; k < 3; k++) motion[k] = tp_near_plus(motion[k], (tp_near){twist[k], 0});
  return is_within(cone->near_normal, motion, (tp_near){1, 0},
                   tp_near_times(cone->friction, share));
}
