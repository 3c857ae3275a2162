/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The forces that a base can exert on a block (docs/mechanics.md section 6).
 *
 * Contact points are both ends of every facet, each with its facet's direction t, up-dip, and
 * normal n, into the block. The friction cone of a point is spanned by its edges n + t tan(phi) and
 * n - t tan(phi). A force counts as the column (f_x, f_y, moment about the origin). Cohesion lets a
 * straight line of facets carry a shear of either sense along it, a bond a facet a pull at its
 * middle, both up to a bound. phi is one for all points but those of facets that have their own.
 * Any one unit of length and force; x mirrored towards the right, so that down-dip is -x. */

#ifndef TP_LINEAR_PROGRAM_CONES_H
#define TP_LINEAR_PROGRAM_CONES_H

#include "load/wrench.h"
#include "plane/contact_rows.h"

#include <flint/fmpz.h>
#include <stdbool.h>
#include <stdint.h>

typedef struct tp_cone_point {
  int32_t site;  /* the same for columns at one point of the plane */
  int32_t facet; /* the caller's */
} tp_cone_point;

/* An edge of the friction cone of a point: n + t tan(phi), or n - t tan(phi) `against` t. */
typedef struct tp_cone_edge {
  long point;
  bool against;
} tp_cone_edge;

/* Two successive points: the ends of a facet that a bond acts on, or the first on a line that
 * cohesion does. */
typedef struct tp_capacity {
  long point;        /* its first end */
  arb_t shear, pull; /* bounds of the factor on t and on -n */
} tp_capacity;

typedef struct tp_cones {
  long count;
  tp_cone_point *points;
  double *whole_x, *whole_y; /* where they lie, if all are whole numbers that doubles hold; */
  arb_ptr x, y;              /* else NULL, and these */
  fmpz *tx, *ty;             /* t in whole numbers of any length */
  arb_t friction;            /* tan(phi) */
  long own_count;            /* no two of these are the same, nor the same as `friction` */
  arb_ptr own_friction;
  int32_t *owns; /* by point: 0, `friction`; else the one before this of `own_friction`; NULL: 0 */
  signed char *senses; /* by point: 1 or -1: it bears while it sticks, or slips along t or against
                          it, alone; NULL, 0: however it slips */
  long beside_count;   /* the last of the points are of no facet, but beside one */
  int32_t *lines; /* by point: the straight line of its facet, the same for all on it; NULL: each
                     facet's own; needed for capacities */
  long capacity_count;
  tp_capacity *capacities;
} tp_cones;

/* Room for `count` points, for frictions of their own and for capacities, zeros all; false when
 * memory is exhausted: without points there is nothing to clear. */
bool tp_cones_init(tp_cones *cones, long count);
TP_MUST_USE bool tp_cones_take_own(tp_cones *cones, long own_count);
TP_MUST_USE bool tp_cones_take_lines(tp_cones *cones);
TP_MUST_USE bool tp_cones_take_senses(tp_cones *cones);
bool tp_cones_allow(tp_cones *cones, long capacity_count);
void tp_cones_clear(tp_cones *cones);

/* A point's place, which is its own from then on; in whole numbers. */
void tp_cones_set_place(tp_cones *cones, long point, const arb_t x, const arb_t y);
void tp_cones_set_whole(tp_cones *cones, long point, const fmpz_t x, const fmpz_t y);

/* It, borrowed: not to be changed or cleared; exactly in doubles, or false; are all known exactly?
 */
arb_struct tp_cones_x(const tp_cones *cones, long point);
arb_struct tp_cones_y(const tp_cones *cones, long point);
bool tp_cones_in_double(double *x, double *y, const tp_cones *cones, long point);
bool tp_cones_to_double(double *value, const arb_t coordinate);
bool tp_cones_places_are_exact(const tp_cones *cones);

/* Columns 2 k and 2 k + 1 are the edges n + t tan(phi) and n - t tan(phi) of point k; after those
 * of all points come three for each capacity: shear along t, shear against it, the pull. */
enum { TP_CAPACITY_COLUMNS = 3 };
long tp_cones_column_count(const tp_cones *cones);
bool tp_cones_is_edge(const tp_cones *cones, long column);
bool tp_cones_is_shear(const tp_cones *cones, long column);

/* Which friction a point has, and tan(phi) of it. Is that known exactly at all points? */
long tp_cones_own(const tp_cones *cones, long point);
arb_srcptr tp_cones_friction(const tp_cones *cones, long point);
bool tp_cones_are_exact(const tp_cones *cones);

/* Does it bear while it slips so: 1 along t, -1 against it, 0 not at all? */
bool tp_cones_bears(const tp_cones *cones, long point, int slip);

/* The middle of a point and the next, the ends of a facet. */
void tp_cones_middle(arb_t x, arb_t y, const tp_cones *cones, long point, long bits);

/* The column, three balls; its bound, where it is no edge of a cone. */
void tp_cones_column(arb_ptr entries, const tp_cones *cones, long column, long bits);
void tp_cones_bound(arb_t most, const tp_cones *cones, long column);

/* The point whose force the column is, and a unit of force along it: for the report. */
long tp_cones_point_of(const tp_cones *cones, long column);

/* Is column `other` parallel to `column` by its facet alone? Are both forces at one point? Do both
 * pass through one point alone, that of an edge's point or of one on a sheared line? */
bool tp_cones_are_parallel(const tp_cones *cones, long column, long other);
/* Would both slip along one direction the same way, their forces at different angles to it? */
bool tp_cones_slip_unevenly(const tp_cones *cones, long column, long other);
bool tp_cones_meet(long *site, const tp_cones *cones, long column, long other);
bool tp_cones_share_site(const tp_cones *cones, long column, long other);

#endif
