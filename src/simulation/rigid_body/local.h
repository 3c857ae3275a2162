/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Points of a problem in metres from the centroid of its block: subtracted before they are rounded,
 * so that a block far from the origin of its scene loses no digits. */

#ifndef TP_RIGID_BODY_LOCAL_H
#define TP_RIGID_BODY_LOCAL_H

#include "evaluation/evaluation.h"

typedef struct tp_xy {
  double x, y;
} tp_xy;

typedef struct tp_local {
  tp_evaluation e;
  arb_t x, y; /* the centroid, in lattice units */
} tp_local;

/* With bits that keep the moment sums of the lattice exact. */
void tp_local_init(tp_local *local, const tp_problem *problem);
void tp_local_clear(tp_local *local);

/* Of lattice units; of a point of the lattice; of a point of the outline. */
tp_xy tp_local_point(const tp_local *local, const arb_t x, const arb_t y);
tp_xy tp_local_lattice_point(const tp_local *local, long point);
tp_xy tp_local_outline_point(const tp_local *local, tp_outline_point at);

double tp_local_nearest(const arb_t ball);

static inline tp_xy tp_xy_minus(tp_xy p, tp_xy q) {
  return (tp_xy){p.x - q.x, p.y - q.y};
}

static inline tp_xy tp_xy_plus(tp_xy p, double t, tp_xy q) {
  return (tp_xy){p.x + t * q.x, p.y + t * q.y};
}

static inline double tp_xy_dot(tp_xy p, tp_xy q) {
  return p.x * q.x + p.y * q.y;
}

/* Above zero where q lies to the left of p. */
static inline double tp_xy_cross(tp_xy p, tp_xy q) {
  return p.x * q.y - p.y * q.x;
}

/* A quarter turn to the left. */
static inline tp_xy tp_xy_left(tp_xy p) {
  return (tp_xy){-p.y, p.x};
}

#endif
