/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Lines cross in so many points an area: the sum of sin / (spacing spacing) over pairs of sets,
 * each times its persistence; and every crossing begins a cell. */

#include "jointing/joint_count.h"

#include "jointing/joint_layout.h"

#include <math.h>

static const double most_blocks = 1e5;

static double area_of(const tp_cuts *cuts) {
  double twice = 0;
  for (long k = 0; k < cuts->corner_count; k++) {
    const long n = (k + 1) % cuts->corner_count;
    twice += cuts->x[n] * cuts->y[k] - cuts->x[k] * cuts->y[n];
  }
  return twice / 2;
}

static double expected_blocks(tp_cuts *cuts) {
  const tp_jointed_slope *slope = cuts->slope;
  const double area = area_of(cuts);
  double count = 0;
  for (long i = 0; i < slope->set_count; i++) {
    tp_joint_layout l;
    double least = 0, most = 0;
    tp_joint_layout_init(&l, cuts, i, 0);
    tp_cuts_reach(cuts, &l.normal, &least, &most);
    const double own = fmpq_get_d(l.set->persistence.value) / fmpq_get_d(l.set->spacing.value);
    const double c = fmpq_get_d(l.along.x), s = fmpq_get_d(l.along.y);
    count += (most - least) / fmpq_get_d(l.set->spacing.value);
    if (l.set->length.given) count += area * own / fmpq_get_d(l.set->length.value);
    for (long j = 0; j < i; j++) {
      tp_joint_layout m;
      tp_joint_layout_init(&m, cuts, j, 0);
      const double sine = c * fmpq_get_d(m.along.y) - s * fmpq_get_d(m.along.x);
      count += area * fabs(sine) * own * fmpq_get_d(m.set->persistence.value) /
               fmpq_get_d(m.set->spacing.value);
      tp_joint_layout_clear(&m);
    }
    tp_joint_layout_clear(&l);
  }
  return count;
}

tp_status tp_joints_check_count(tp_cuts *cuts, tp_message *message) {
  const double count = expected_blocks(cuts);
  if (count <= most_blocks) return TP_OK;
  return tp_refuse(message, TP_FAULT_RANGE, cuts->slope->sets[0].spacing.place,
                   "joints at these spacings part the section into up to %.2g pieces, and %.0f are "
                   "the most: give wider spacings, or a smaller section",
                   count, most_blocks);
}
