/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The moments of a solid at one level, doubles first, and as results have them. */

#ifndef TP_SOLID_TILT_SOLID_MOMENTS_H
#define TP_SOLID_TILT_SOLID_MOMENTS_H

#include "solid/centre.h"

#include <arb.h>

/* Sums over what is inside a surface; with parts, by weight: with all of these times `excess`
 * added, their unit weight over that of the rock, less one. */
typedef struct tp_solid_moments {
  const tp_surface *surface; /* on whose lattice these numbers are, */
  const tp_surface *summed;  /* and that within which all is: the same, or with its vertices */
  tp_level level;
  tp_centre centre;
  tp_near near[TP_SOLID_SUM_COUNT];
  fmpz exact[TP_SOLID_SUM_COUNT]; /* at the level exact: */
  fmpz_t multiple;                /* so many times the sums */
  tp_near near_volume6;           /* without holes, whatever the weight; */
  fmpz_t exact_volume6;           /* at the level exact, likewise */
  long part_count;
  const struct tp_solid_part_moments *parts; /* borrowed */
} tp_solid_moments;

/* What lies inside a solid. */
typedef struct tp_solid_part_moments {
  const tp_solid_moments *own; /* of its surface alone */
  fmpq_t excess;               /* -1: a hole */
} tp_solid_part_moments;

void tp_solid_moments_init(tp_solid_moments *moments, const tp_surface *surface);
/* Of those of a surface alone, with parts, which must outlive them. */
void tp_solid_moments_weigh(tp_solid_moments *weighed, const tp_solid_moments *moments,
                            const tp_solid_part_moments *parts, long part_count);
void tp_solid_moments_climb(tp_solid_moments *moments); /* to the level exact */
/* Sums of a surface for another one on its lattice, in place of it. */
void tp_solid_moments_lie_on(tp_solid_moments *moments, const tp_surface *surface);
void tp_solid_moments_clear(tp_solid_moments *moments);

/* Refuses a surface that encloses no volume, or that is oriented inwards, which exact sums tell
 * where doubles do not. */
TP_MUST_USE tp_status tp_solid_moments_check(tp_solid_moments *moments, tp_message *message);

/* Are volume, centroid and inertia certain to ten digits, of the size of the solid? */
bool tp_solid_moments_told(const tp_solid_moments *moments);

/* Without holes. */
tp_bounded tp_solid_moments_volume(const tp_solid_moments *moments, const fmpq_t metres_per_unit);

/* At the level exact: integrals of x x, y y, z z, y z, z x, x y about the centroid over the mass,
 * in steps of the surface. */
void tp_solid_moments_inertia(fmpq inertia[6], const tp_solid_moments *moments);

void tp_solid_moments_tell(tp_solid *solid, const tp_solid_moments *moments,
                           const fmpq_t metres_per_unit, const fmpq_t unit_weight);

#endif
