/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The order of contact points by the lines of their normals: by axis, by sense, by t . q, and on
 * one line by site. Inner header of motion/normals_*.c. */

#ifndef TP_MOTION_NORMALS_ORDER_H
#define TP_MOTION_NORMALS_ORDER_H

#include "motion/normals.h"

#include <stdint.h>

/* What doubles and words do not tell of a point. */
typedef struct tp_normal_place {
  fmpz axis_x, axis_y; /* t times its sense */
  arb_t along;         /* t . q */
} tp_normal_place;

/* What is sorted: most comparisons end within it. Three words, which qsort moves and does not point
 * to. Of axes of short numbers, below 2^25, no two slopes are closer than 2^-50 of themselves, so
 * that in doubles one slope is one axis. */
typedef struct tp_normal_entry {
  double slope; /* of the axis, rounded: another one is another axis */
  union {
    int64_t whole; /* t . q */
    double rounded;
  } along;
  int32_t site;
  uint32_t tag; /* 4 point + 2 is_short + is_against */
} tp_normal_entry;

static inline long tp_normal_entry_point(const tp_normal_entry *e) {
  return (long)(e->tag >> 2);
}

static inline bool tp_normal_entry_is_short(const tp_normal_entry *e) {
  return (e->tag & 2) != 0;
}

/* Is t against its axis? */
static inline bool tp_normal_entry_is_against(const tp_normal_entry *e) {
  return (e->tag & 1) != 0;
}

typedef struct tp_normals_order {
  long count;
  bool is_whole; /* all t . q are whole numbers within a word, and all t short */
  tp_normal_entry *entries;
  tp_normal_place *places; /* by point, unless it is whole */
} tp_normals_order;

/* t of a point without common divisor. */
void tp_normals_order_direction(fmpz *tx, fmpz *ty, const tp_cones *cones, long point);

/* The points of cones in order; false when memory is exhausted. */
TP_MUST_USE bool tp_normals_order_init(tp_normals_order *order, const tp_cones *cones,
                                       long precision);
/* Sorts entries where all is whole; false, with nothing done, when memory is exhausted. */
TP_MUST_USE bool tp_normals_order_by_families(tp_normals_order *order);
void tp_normals_order_clear(tp_normals_order *order);

/* Do two entries lie along one axis; of one family, on one line: 1, 0, or TP_OPEN_SIGN? */
bool tp_normals_order_same_axis(const tp_normals_order *order, long k, long other);
int tp_normals_order_same_line(const tp_normals_order *order, long k, long other,
                               const tp_judge *judge);

/* h of an entry in doubles. */
void tp_normals_order_near(double near[3], const tp_normals_order *order, long k,
                           const tp_contact_family *family);

#endif
