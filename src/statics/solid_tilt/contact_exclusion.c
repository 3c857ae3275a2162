/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Numbers are proven stretch by stretch from 1 on: first all up to the limit of what forces hold,
 * then half as much, until the programs that may be solved are used up. */

#include "solid_tilt/contact_exclusion.h"

#include "solid_contacts/solid_exclusion.h"

#include <math.h>
#include <stdlib.h>

/* Programs for the load as it is, and for each of the numbers. */
enum { PROGRAMS = 1500, FURTHER = 1500, TRIES = 10 };
static const double farthest = 10; /* no greater number is looked for */

typedef struct extending {
  tp_solid_exclusion exclusion;
  const tp_hold_load *rest, *way;
  bool divides;
} extending;

/* rest + multiple way */
static void set_load(tp_hold_load *load, const extending *x, double multiple) {
  fmpq_t own;
  fmpq_init(own);
  tp_hold_double(own, multiple);
  for (int k = 0; k < 3; k++) {
    fmpq_set(load->exact + k, x->rest->exact + k);
    fmpq_addmul(load->exact + k, x->way->exact + k, own);
    load->error[k] = (x->rest->error[k] + multiple * x->way->error[k]) * (1 + 4 * DBL_EPSILON);
  }
  tp_hold_load_settle(load);
  fmpq_clear(own);
}

/* With the friction of all contacts divided. */
static bool try_divided(tp_solid_exclusion *own, double divisor) {
  const tp_friction_cones *given = own->cones;
  tp_friction_cones weaker = {.count = given->count,
                              .cones = calloc((size_t)given->count + 1, sizeof *weaker.cones)};
  if (weaker.cones == NULL) return false;
  for (long n = 0; n < given->count; n++) {
    weaker.cones[n] = given->cones[n];
    weaker.cones[n].friction.value /= divisor;
  }
  own->cones = &weaker;
  const bool done = tp_solid_exclusion_find(own);
  free(weaker.cones);
  return done;
}

static bool try_stretch(extending *x, double from, double to) {
  tp_solid_exclusion own = x->exclusion;
  bool done;
  if (x->divides) {
    own.divisor = to / from;
    done = try_divided(&own, from);
  } else {
    set_load(x->exclusion.loads, x, from);
    set_load(x->exclusion.loads + 1, x, to);
    for (int k = 0; k < 2; k++) own.loads[k] = x->exclusion.loads[k];
    own.way = x->way;
    done = tp_solid_exclusion_find(&own);
  }
  x->exclusion.most = own.most;
  x->exclusion.is_excluded = own.is_excluded;
  return done;
}

/* From `start` on, of which nothing has to be known. */
static bool extend(double *reached, extending *x, double start, double limit) {
  static const double least_step = 1e-3;
  *reached = start;
  const double end = fmin(limit, farthest);
  double step = end - start;
  for (int k = 0; k < TRIES && step > least_step && x->exclusion.most > 0; k++) {
    const double to = fmin(end, *reached + step);
    if (!try_stretch(x, *reached, to)) return false;
    if (x->exclusion.is_excluded) *reached = to;
    step = fmin(step / 2, end - *reached);
  }
  return true;
}

static double lower_end(tp_near number) {
  return number.value - number.error;
}

bool tp_contact_exclusion_find(tp_contact_exclusion *found, const tp_contact_work *w,
                               const tp_weak_side *weak) {
  *found = (tp_contact_exclusion){.stands = false, .driving = 1, .strength = 1};
  if (weak->side != TP_HOLD_HOLDS || !(weak->least > 0)) return true;
  extending x = {.exclusion = {.cones = &w->points.cones,
                               .inertia = w->points.inertia,
                               .loads = {weak->load, weak->load},
                               .divisor = 1,
                               .most = PROGRAMS},
                 .rest = &weak->rest,
                 .way = &weak->way,
                 .divides = true};
  if (!tp_solid_exclusion_find(&x.exclusion)) return false;
  found->stands = x.exclusion.is_excluded;
  if (!found->stands) return true;
  x.exclusion.most = FURTHER;
  const double strength = weak->kind == TP_HOLD_FACTOR        ? lower_end(weak->factor)
                          : weak->kind == TP_HOLD_FACTOR_OPEN ? 1
                                                              : INFINITY;
  if (!extend(&found->strength, &x, 1, strength)) return false;
  if (!weak->drives || weak->limit.is_open) return true;
  for (int k = 0; k < 2; k++) tp_hold_load_init(x.exclusion.loads + k);
  x.divides = false;
  x.exclusion.most = FURTHER;
  const bool done =
      extend(&found->driving, &x, 1, weak->limit.is_endless ? INFINITY : lower_end(weak->limit.t));
  for (int k = 0; k < 2; k++) tp_hold_load_clear(x.exclusion.loads + k);
  return done;
}

bool tp_contact_exclusion_from(double *reached, const tp_contact_work *w, const tp_hold_load *load,
                               const tp_hold_load *way, double limit) {
  extending x = {.exclusion = {.cones = &w->points.cones,
                               .inertia = w->points.inertia,
                               .divisor = 1,
                               .most = FURTHER},
                 .rest = load,
                 .way = way};
  for (int k = 0; k < 2; k++) tp_hold_load_init(x.exclusion.loads + k);
  const bool done = extend(reached, &x, 0, limit);
  for (int k = 0; k < 2; k++) tp_hold_load_clear(x.exclusion.loads + k);
  return done;
}
