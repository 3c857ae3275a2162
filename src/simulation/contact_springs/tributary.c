/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Half of the common length of the two straight pieces that are most nearly antiparallel at a
 * contact, or the least length. */

#include "contact_springs/tributary.h"

#include <math.h>

/* A straight piece of the block, turned to where it is. */
static tp_feature placed(const tp_feature *piece, const tp_placing *placing) {
  tp_feature own = *piece;
  own.from = tp_xy_plus(placing->moved, 1, tp_placing_turn(placing, piece->from));
  own.tangent = tp_placing_turn(placing, piece->tangent);
  return own;
}

/* Half of the common length along the base of a piece of each. */
static double common(const tp_feature *of_block, const tp_feature *of_base,
                     const tp_placing *placing) {
  const tp_feature own = placed(of_block, placing);
  const tp_xy end = tp_xy_plus(own.from, own.length, own.tangent);
  const double first = tp_xy_dot(tp_xy_minus(own.from, of_base->from), of_base->tangent);
  const double last = tp_xy_dot(tp_xy_minus(end, of_base->from), of_base->tangent);
  const double low = fmax(0, fmin(first, last)), high = fmin(of_base->length, fmax(first, last));
  return fmax(0, high - low) / 2;
}

static bool is_straight(const tp_feature *f) {
  return f->kind == TP_FEATURE_STRAIGHT;
}

static long beside(const tp_features *features, long feature, long step) {
  return (feature + features->count + step) % features->count;
}

/* The piece itself, or the two beside a disc: NULL where those are none. */
static const tp_feature *piece_at(const tp_features *features, long feature, int side) {
  const tp_feature *own = features->items + feature;
  if (is_straight(own)) return side == 0 ? own : NULL;
  const tp_feature *other = features->items + beside(features, feature, side == 0 ? -1 : 1);
  return is_straight(other) ? other : NULL;
}

double tp_tributary_length(const tp_features *of_block, long block_feature,
                           const tp_features *of_base, long base_feature, const tp_placing *placing,
                           double least_m) {
  double length = 0, best = 2; /* the cosine between the two: -1 where they lie on each other */
  for (int k = 0; k < 4; k++) {
    const tp_feature *own = piece_at(of_block, block_feature, k % 2);
    const tp_feature *base = piece_at(of_base, base_feature, k / 2);
    if (own == NULL || base == NULL) continue;
    const double cosine = tp_xy_dot(tp_placing_turn(placing, own->tangent), base->tangent);
    if (cosine >= best) continue;
    best = cosine;
    length = common(own, base, placing);
  }
  return fmax(length, least_m);
}
