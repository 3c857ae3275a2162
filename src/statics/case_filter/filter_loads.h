/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What the base has to bear of the loads that turn with the tilt as the weight does (the weight
 * itself, an earthquake, water that stands along the face, its uplift, surcharges) and of those
 * that stay with the block (anchors, supports, pressures, water of a site). Over the weight and
 * cos(tilt) each is at + t rise + s fixed with t = tan(tilt), s = 1 / cos(tilt), as (f_x, f_y,
 * moment) about the centroid in the unit of the shape (shape.h), the opposite of what acts on the
 * block (load/wrench.h). */

#ifndef TP_CASE_FILTER_FILTER_LOADS_H
#define TP_CASE_FILTER_FILTER_LOADS_H

#include "case_filter/contact_rest.h"
#include "case_filter/shape.h"
#include "case_filter/tilt_form.h"

enum { TP_FILTER_LOADS = 12 };

/* Numbers of a scene that loads depend on. */
typedef enum tp_load_number {
  TP_NUMBER_HORIZONTAL, /* shares of the weight */
  TP_NUMBER_VERTICAL,
  TP_NUMBER_WATER_HEIGHT, /* scene lengths */
  TP_NUMBER_WATER_WEIGHT, /* kN/m3 */
  TP_NUMBER_UNIT_WEIGHT,  /* of the block */
  TP_NUMBER_BOLT_FORCE,   /* of the first anchor, kN */
  TP_NUMBER_COHESION,     /* kPa */
  TP_NUMBER_BOND,
  TP_LOAD_NUMBERS
} tp_load_number;

/* On which side a load counts as driving loads are multiplied (onset/onset_driving.c). */
typedef enum tp_filter_side {
  TP_FILTER_GRAVITY,    /* by its components along the base and across */
  TP_FILTER_EARTHQUAKE, /* it drives */
  TP_FILTER_WATER,      /* all of it as one, by its direction */
  TP_FILTER_PUSH,       /* by its direction */
  TP_FILTER_SUPPORT     /* it rests, or, active, is taken from what drives */
} tp_filter_side;

/* Anchors and supports: what an `active` one holds back is taken from what overturns, what a
 * `passive` one does is resistance (load/loads.h). */
typedef struct tp_filter_load {
  tp_near at[3], rise[3], fixed[3];
  bool active, passive;
  tp_filter_side side;
} tp_filter_load;

typedef struct tp_filter_loads {
  bool called_for; /* any besides the weight */
  bool turns;      /* their moment about the centroid is not zero throughout */
  bool stays;      /* some stay with the block */
  int count;       /* the weight first */
  tp_filter_load items[TP_FILTER_LOADS], sum;
} tp_filter_loads;

/* The weight alone. */
void tp_filter_loads_init(tp_filter_loads *loads);
/* One more; false where there is no room for it. */
TP_MUST_USE bool tp_filter_loads_add(tp_filter_loads *loads, const tp_filter_load *load);

/* All of them at a tilt: (t, 1, 0) of the weight alone. */
static inline void tp_filter_loads_at(tp_near force[3], const tp_filter_loads *loads,
                                      tp_near tangent) {
  const tp_filter_load *sum = &loads->sum;
  force[0] = tangent;
  force[1] = sum->at[1];
  force[2] = sum->at[2];
  for (int k = 0; k < 3 && loads->called_for; k++) {
    force[k] = tp_near_plus(sum->at[k], tp_near_times(tangent, sum->rise[k]));
  }
  if (!loads->stays) return;
  const tp_near secant = tp_tilt_secant(tangent);
  for (int k = 0; k < 3; k++) {
    force[k] = tp_near_plus(force[k], tp_near_times(secant, sum->fixed[k]));
  }
}

/* Where the tangents meet of the arc of sines and cosines between two tilts, of which both have to
 * be at least level or either side of it: what holds at both and there holds between, as all of the
 * arc lies between the three (docs/mechanics.md section 6). */
void tp_filter_loads_apex(tp_near force[3], const tp_filter_loads *loads, tp_near low,
                          tp_near high);

/* Their power on a twist. */
static inline void tp_filter_loads_power(tp_tilt_form *power, const tp_filter_loads *loads,
                                         const tp_near twist[3]) {
  power->level = loads->called_for ? tp_sparse_dot(twist, loads->sum.at) : twist[1];
  power->rise = loads->called_for ? tp_sparse_dot(twist, loads->sum.rise) : twist[0];
  power->fixed = loads->stays ? tp_sparse_dot(twist, loads->sum.fixed) : (tp_near){0, 0};
}

/* Moment about a point that holds the block back, the point from the centroid. */
void tp_filter_load_moment(tp_tilt_form *moment, const tp_filter_load *load, tp_near x, tp_near y);

/* A case with the numbers of a sample. */
typedef struct tp_filter_case {
  const tp_contact_plan *plan;
  const tp_case_shape *shape;
  const tp_contact_rest *rest; /* what the plan leaves out */
  const tp_filter_loads *loads;
  const struct tp_filter_capacities *capacities;
  tp_near friction; /* tan(phi) */
} tp_filter_case;

#endif
