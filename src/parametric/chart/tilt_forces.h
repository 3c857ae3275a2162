/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Reactions of a tilt test by facet, as a chart needs them: which facets there are, which of them
 * bear most, and what each bears at every moment that is drawn. */

#ifndef TP_CHART_TILT_FORCES_H
#define TP_CHART_TILT_FORCES_H

#include "chart/chart.h"

enum { TP_FORCES = 2, TP_FACETS_COLOURED = 6 }; /* normal and shear */

/* A facet of the base, in any of the cases. */
typedef struct tp_force_facet {
  long number;
  double most_n; /* of its normal forces */
  int colour;    /* from left to right; -1: it is drawn with the others */
  double x0_m, x1_m;
} tp_force_facet;

typedef struct tp_force_facets {
  const tp_tilt_test *test;
  bool by_tilt; /* else by time */
  size_t count;
  tp_force_facet *items; /* by their numbers */
  bool has_others;       /* without a colour, that bear something */
} tp_force_facets;

/* False when memory is exhausted. */
TP_MUST_USE bool tp_force_facets_init(tp_force_facets *facets, const tp_tilt_test *test);
void tp_force_facets_clear(tp_force_facets *facets);

/* Where a number stands, or would. */
size_t tp_force_facets_find(const tp_force_facets *facets, long number);

/* Forces of a case: facet by facet the moments that are drawn. */
typedef struct tp_tilt_forces {
  const tp_tilt_case *own;
  bool by_tilt;
  size_t count; /* of the moments */
  double *of[TP_FORCES];
} tp_tilt_forces;

TP_MUST_USE bool tp_tilt_forces_init(tp_tilt_forces *forces, const tp_force_facets *facets,
                                     const tp_tilt_case *own);
void tp_tilt_forces_clear(tp_tilt_forces *forces);

/* How many moments are drawn: on a table that tilts those before the block begins to move. */
size_t tp_tilt_forces_shown(const tp_force_facets *facets, const tp_tilt_case *own);

/* The tilt or the time of a moment. */
double tp_tilt_forces_at(const tp_tilt_forces *forces, size_t moment);

#endif
