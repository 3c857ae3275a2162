/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Cohesion along every straight line of contact, and a bond on every facet: the pressure times the
 * length, over the length of t, which is the unit of the columns of cones. */

#include "static_limit/limit_capacities.h"

#include "load/setting.h"
#include "static_limit/limit_lines.h"

#include <stdlib.h>

static void add_length(arb_t length, const tp_cones *cones, long point, long bits) {
  arb_t dx, dy;
  arb_init(dx);
  arb_init(dy);
  const arb_struct x0 = tp_cones_x(cones, point), x1 = tp_cones_x(cones, point + 1);
  const arb_struct y0 = tp_cones_y(cones, point), y1 = tp_cones_y(cones, point + 1);
  arb_sub(dx, &x1, &x0, bits);
  arb_sub(dy, &y1, &y0, bits);
  arb_hypot(dx, dx, dy, bits);
  arb_add(length, length, dx, bits);
  arb_clear(dx);
  arb_clear(dy);
}

/* kPa on a length and the thickness, over the length of t. */
static void set_strength(arb_t bound, const arb_t length, const tp_quantity *kpa,
                         const tp_evaluation *e, const tp_cones *cones, long point) {
  const long bits = e->rung.bits;
  fmpq_t factor;
  arb_t x, y;
  fmpq_init(factor);
  arb_init(x);
  arb_init(y);
  tp_problem_thickness(factor, e->problem);
  fmpq_mul(factor, factor, kpa->value);
  fmpq_mul_ui(factor, factor, TP_KILO);
  arb_mul_fmpz(bound, length, fmpq_numref(factor), bits);
  arb_div_fmpz(bound, bound, fmpq_denref(factor), bits);
  arb_set_fmpz(x, cones->tx + point);
  arb_set_fmpz(y, cones->ty + point);
  arb_hypot(x, x, y, bits);
  arb_div(bound, bound, x, bits);
  fmpq_clear(factor);
  arb_clear(x);
  arb_clear(y);
}

static bool begins_facet(const tp_cones *cones, long point) {
  const tp_cone_point *own = cones->points + point;
  return own->facet >= 0 && point + 1 < cones->count && own[1].facet == own->facet;
}

static bool begins_line(const tp_cones *cones, long point) {
  return cones->lines[point] == cones->points[point].facet;
}

/* Where there is no bond, a capacity for each line alone. */
static bool has_capacity(const tp_cones *cones, long point, bool bonded) {
  return begins_facet(cones, point) && (bonded || begins_line(cones, point));
}

static long count_capacities(const tp_cones *cones, bool bonded) {
  long count = 0;
  for (long k = 0; k < cones->count; k++) count += has_capacity(cones, k, bonded);
  return count;
}

/* `lengths`, one for each facet of the contact, are zeros: those of lines are summed there. */
static void fill_capacities(tp_cones *cones, const tp_evaluation *e, arb_ptr lengths) {
  const tp_loads_description *loads = &e->problem->scene->loads;
  const bool bonded = !fmpq_is_zero(loads->bond_kpa.value);
  const long bits = e->rung.bits;
  for (long k = 0; k < cones->count; k++) {
    if (begins_facet(cones, k)) add_length(lengths + cones->lines[k], cones, k, bits);
  }
  arb_t length;
  arb_init(length);
  long own = 0;
  for (long k = 0; k < cones->count; k++) {
    if (!has_capacity(cones, k, bonded)) continue;
    tp_capacity *a = cones->capacities + own++;
    a->point = k;
    if (begins_line(cones, k)) {
      set_strength(a->shear, lengths + cones->lines[k], &loads->cohesion_kpa, e, cones, k);
    }
    if (!bonded) continue;
    arb_zero(length);
    add_length(length, cones, k, bits);
    set_strength(a->pull, length, &loads->bond_kpa, e, cones, k);
  }
  arb_clear(length);
}

bool tp_limit_capacities_add(tp_cones *cones, const tp_evaluation *e) {
  const tp_loads_description *loads = &e->problem->scene->loads;
  const bool bonded = !fmpq_is_zero(loads->bond_kpa.value);
  /* strength of nothing adds no forces, and no ties of mechanisms that hold them */
  if (e->loaded == NULL || !(bonded || !fmpq_is_zero(loads->cohesion_kpa.value))) return true;
  const long facets = e->problem->contact.facet_count;
  long *lines = calloc((size_t)facets + 1, sizeof *lines);
  if (lines == NULL) return false;
  bool done = tp_limit_lines_find(lines, e->problem) && tp_cones_take_lines(cones);
  for (long k = 0; k < cones->count && done; k++) {
    const long facet = cones->points[k].facet;
    if (facet >= 0) cones->lines[k] = (int32_t)lines[facet];
  }
  free(lines);
  done = done && tp_cones_allow(cones, count_capacities(cones, bonded));
  if (!done) return false;
  arb_ptr lengths = _arb_vec_init(facets);
  fill_capacities(cones, e, lengths);
  _arb_vec_clear(lengths, facets);
  return true;
}
