/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Normals point into the slope where a set dips more than 45 degrees, else upwards. */

#include "jointing/joint_layout.h"

#include "generate/random.h"

static void set_angle(tp_joint_layout *l) {
  const tp_joint_set *set = l->set;
  const bool left = set->left != l->cuts->slope->right; /* that it dips to */
  fmpq_set(l->angle_deg, set->dip_deg.value);
  if (!left) fmpq_neg(l->angle_deg, l->angle_deg);
  tp_direction_of_degrees(&l->along, l->angle_deg);
  /* into the slope of steep sets, upwards of others */
  l->left = !left || fmpq_cmp_si(set->dip_deg.value, 45) <= 0;
  fmpq_set(l->normal.x, l->along.y);
  fmpq_set(l->normal.y, l->along.x);
  fmpq_neg(l->left ? l->normal.x : l->normal.y, l->left ? l->normal.x : l->normal.y);
}

void tp_joint_layout_init(tp_joint_layout *l, tp_cuts *cuts, long number, uint64_t seed) {
  *l = (tp_joint_layout){.cuts = cuts, .set = cuts->slope->sets + number, .number = number};
  const uint64_t stream = tp_random_stream(seed, TP_STREAM_JOINTS);
  for (int k = 0; k < TP_JOINT_RANDOMS; k++) {
    l->random[k] = tp_random_branch(stream, (uint64_t)(number * TP_JOINT_RANDOMS + k));
  }
  fmpq_init(l->angle_deg);
  tp_cut_point_init(&l->along);
  tp_cut_point_init(&l->normal);
  set_angle(l);
}

void tp_joint_layout_clear(tp_joint_layout *l) {
  fmpq_clear(l->angle_deg);
  tp_cut_point_clear(&l->along);
  tp_cut_point_clear(&l->normal);
}
