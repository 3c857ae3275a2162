/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The verdicts of stability/mechanism.c, of a block that has a limit at an angle. Tangents rise
 * with tilts, so that the order of the two is the same. */

#include "case_filter/factor_filter.h"
#include "case_filter/moments_filter.h"
#include "case_filter/sliding_filter.h"
#include "stability/static_state.h"

#include "number/near_angle.h"

static tp_near tangent_of(tp_near degrees) {
  tp_near sine, cosine;
  if (tp_near_is_zero(degrees)) return degrees;
  tp_near_sin_cos(&sine, &cosine, degrees);
  if (tp_near_sign(cosine) <= 0) return (tp_near){0, INFINITY};
  return tp_near_div(sine, cosine);
}

/* ---- by moments --------------------------------------------------------------------------------
 */

/* The admissible pivot with the least critical angle, or the only one where it has none. On each it
 * must stand level. */
static bool find_pivot(tp_case_told *told) {
  const tp_case_filter *f = told->filter;
  tp_filter_turning least = {.never = true};
  told->pivot = NULL;
  for (int k = 0; k < f->pivot_count; k++) {
    tp_filter_turning own;
    if (!f->pivots[k].admissible) continue;
    if (!tp_filter_turns(&own, &told->of, f->pivots + k)) return false;
    int order = told->pivot == NULL ? -1 : (int)own.never - (int)least.never;
    if (order == 0 && !own.never) order = tp_near_sign(tp_near_sub(own.tangent, least.tangent));
    if (order == 0) return false;
    if (order > 0) continue;
    least = own;
    told->pivot = f->pivots + k;
  }
  told->never_topples = least.never;
  if (!least.never) told->moments_deg = tp_near_arctangent(least.tangent);
  return told->pivot != NULL;
}

/* ---- cohesion and bonds ------------------------------------------------------------------------
 */

/* Under these modes may begin beyond the limit alone, which then is the onset
 * (onset/onset_limit.c). */
static bool begins_beyond(const tp_case_told *told, tp_near limit) {
  return told->capacities.acts &&
         (told->onset.never || tp_near_sign(tp_near_sub(told->onset.tangent, limit)) > 0);
}

/* May it slide along its facet before a bond that pulls and presses would let it
 * (stability/mechanism.c)? */
static bool may_slide_sooner(const tp_case_told *told, tp_near limit) {
  bool starts = false;
  tp_near critical;
  if (!told->capacities.acts || !told->capacities.bonds || !told->filter->capacities.slips) {
    return false;
  }
  return !tp_sliding_filter_start(&starts, &critical, told) ||
         (starts && tp_near_sign(tp_near_sub(critical, limit)) <= 0);
}

/* ---- at any tilt -------------------------------------------------------------------------------
 */

/* The shape of a block that varies, and where its pivots lie. */
static bool take_shape(tp_case_told *told, tp_near_outline *outline, const tp_near *variables) {
  const tp_case_filter *f = told->filter;
  told->of.shape = f->varies ? &told->own : &f->shape;
  return !f->varies || (tp_outline_map_shape(&told->own, outline, &f->map, &f->plan, variables) &&
                        tp_shape_complete(&told->own, &f->plan));
}

/* Loads of the sample. Without an earthquake that was the only one the weight is left, and no load
 * is called for but what cohesion and bonds are. */
static bool take_loads(tp_case_told *told, const tp_case_sample *sample) {
  enum { WEIGHT_AND_EARTHQUAKE = 2 };
  const tp_case_filter *f = told->filter;
  if (!tp_load_plan_evaluate(&told->loads, &f->loads, sample->numbers)) return false;
  if (!sample->at_rest || told->loads.count > WEIGHT_AND_EARTHQUAKE) return true;
  tp_filter_loads_init(&told->loads);
  told->loads.called_for = f->capacities.acts;
  return true;
}

/* Cohesion and bonds, which stay with the block. */
static bool take_capacities(tp_case_told *told, const tp_near numbers[TP_LOAD_NUMBERS]) {
  const tp_case_filter *f = told->filter;
  if (!tp_capacities_evaluate(&told->capacities, &f->capacities, &f->loads, &f->plan,
                              told->of.shape, f->map.metres_per_unit, numbers)) {
    return false;
  }
  if (told->capacities.acts) told->loads.stays = told->loads.turns = true;
  return true;
}

static tp_near coordinate(const tp_case_filter *f, tp_near first, tp_near apart, bool varies,
                          tp_bounded given) {
  const double unit = f->map.metres_per_unit;
  if (!varies) return (tp_near){given.value, given.error};
  return tp_near_mul(tp_near_plus(first, apart), (tp_near){unit, unit * DBL_EPSILON});
}

static void place_pivot(tp_case_told *told, const tp_near_outline *outline,
                        const tp_near *variables) {
  const tp_case_filter *f = told->filter;
  const int at = f->varies ? f->map.points[told->pivot->point].vertex : 0;
  const bool x = f->varies && f->map.x[at].varies, y = f->varies && f->map.y[at].varies;
  tp_near first_x = {0, 0}, first_y = {0, 0};
  if (x || y) tp_outline_map_first(&first_x, &first_y, &f->map, variables);
  told->pivot_x_m = coordinate(f, first_x, outline->x[at], x, told->pivot->x_m);
  told->pivot_y_m = coordinate(f, first_y, outline->y[at], y, told->pivot->y_m);
}

bool tp_case_filter_tell(tp_case_told *told, const tp_case_filter *f,
                         const tp_case_sample *sample) {
  static const tp_near level = {0, 0};
  tp_near_outline outline;
  outline.x[0] = outline.y[0] = level;
  told->filter = f;
  told->sample = *sample;
  for (size_t k = 0; k < f->variable_count; k++) told->variables[k] = sample->variables[k];
  told->of.plan = &f->plan;
  told->of.rest = &f->rest;
  told->of.loads = &told->loads;
  told->of.capacities = &told->capacities;
  told->of.friction = tangent_of(sample->friction_deg);
  if (tp_near_sign(told->of.friction) <= 0 || !take_shape(told, &outline, sample->variables) ||
      !take_loads(told, sample) || !take_capacities(told, sample->numbers) || !find_pivot(told)) {
    return false;
  }
  place_pivot(told, &outline, sample->variables);
  tp_edge_set edges;
  tp_limit_filter limit;
  tp_edge_set_init(&edges, &told->of);
  if (!tp_limit_filter_find(&limit, &edges) || !tp_limit_filter_holds_to(&edges, limit.value) ||
      !tp_onset_filter_find(&told->onset, &told->of) || begins_beyond(told, limit.value) ||
      may_slide_sooner(told, limit.value)) {
    return false;
  }
  told->limit = limit.mechanism;
  told->limit_tangent = limit.value;
  told->limit_deg = tp_near_arctangent(limit.value);
  told->never = told->onset.never;
  if (!told->never) told->onset_deg = tp_near_arctangent(told->onset.tangent);
  return true;
}

/* ---- at one ------------------------------------------------------------------------------------
 */

/* Forces hold it from level ground up to the limit; beyond it some motion begins. */
static bool tell_mechanism(tp_mechanism *mechanism, tp_filter_state *state,
                           const tp_case_told *told, tp_near tangent) {
  const int side = tp_near_sign(tp_near_sub(told->limit_tangent, tangent));
  *state = (tp_filter_state){.tangent = tangent};
  if (side == 0 ||
      !tp_onset_filter_look(&state->moves, &state->beginnings, &told->onset, tangent) ||
      (side < 0 && !state->moves) || (state->moves && state->beginnings == 0)) {
    return false;
  }
  int first = TP_SLIDES;
  while (state->moves && (state->beginnings & 1U << first) == 0) first++;
  *mechanism = side < 0 ? told->limit : state->moves ? TP_MAY_MOVE : TP_STANDS;
  if (side < 0 && (state->beginnings & 1U << told->limit) == 0) {
    *mechanism = (tp_mechanism)first;
  }
  state->mover = side < 0 ? *mechanism : (tp_mechanism)first;
  return true;
}

static bool tell_at(tp_mechanism *mechanism, tp_filter_state *state, const tp_case_told *told,
                    tp_near tilt_deg) {
  const tp_near tangent = tangent_of(tilt_deg);
  return (tp_near_is_zero(tangent) || tp_near_sign(tangent) > 0) &&
         tell_mechanism(mechanism, state, told, tangent);
}

/* ---- without the earthquake --------------------------------------------------------------------
 */

/* Can its weight alone move the block up-dip, along a facet that dips that way or past the end of
 * its contact? */
static bool may_move_up_dip(const tp_case_told *told, tp_near tangent) {
  const tp_shape_point *points = told->of.shape->points;
  bool is_within = false;
  for (int k = 0; k < told->of.plan->point_count; k++) {
    const tp_near rise = tp_near_plus(points[k].ty, tp_near_times(points[k].tx, tangent));
    if (!tp_near_is_zero(rise) && tp_near_sign(rise) <= 0) return true;
    const tp_near along = tp_near_minus(points[k].x, tp_near_times(points[k].y, tangent));
    is_within = is_within || (!tp_near_is_zero(along) && tp_near_sign(along) > 0);
  }
  return !is_within;
}

/* Does the base admit a motion of its weight that the earthquake works against? */
static bool may_move_against(const tp_case_told *told, tp_near tangent) {
  const tp_shape_point *points = told->of.shape->points;
  tp_contact_row rows[TP_PLAN_POINTS];
  const int count = told->of.plan->point_count;
  for (int k = 0; k < count; k++) {
    const tp_shape_point *p = points + k;
    rows[k] = (tp_contact_row){p->x.value, p->y.value, -p->ty.value, p->tx.value};
  }
  return tp_may_move_against(rows, count, tangent.value);
}

/* Does the state without the earthquake count, too (stability/static_state.h)? Not where a motion
 * can begin anyway. */
static bool asks_rest(const tp_case_told *told, tp_mechanism mechanism, tp_near tangent) {
  const tp_case_filter *f = told->filter;
  const tp_near *numbers = told->sample.numbers;
  return f->loads.shakes && mechanism == TP_STANDS &&
         (f->rests || numbers[TP_NUMBER_HORIZONTAL].value < 0 ||
          !tp_near_is_zero(numbers[TP_NUMBER_VERTICAL]) || may_move_up_dip(told, tangent) ||
          may_move_against(told, tangent));
}

static bool tell_rest(tp_case_told *rest, tp_case_told_at *at, tp_filter_state *state,
                      const tp_case_told *told, tp_near tilt_deg) {
  static const tp_near none = {0, 0};
  tp_case_sample still = told->sample;
  still.variables = told->variables;
  still.at_rest = true;
  still.numbers[TP_NUMBER_HORIZONTAL] = still.numbers[TP_NUMBER_VERTICAL] = none;
  return tp_case_filter_tell(rest, told->filter, &still) &&
         tell_at(&at->mechanism, state, rest, tilt_deg);
}

bool tp_case_filter_tell_mechanism(tp_mechanism *mechanism, const tp_case_told *told,
                                   tp_near tilt_deg) {
  tp_filter_state state;
  if (!tell_at(mechanism, &state, told, tilt_deg)) return false;
  if (!asks_rest(told, *mechanism, state.tangent)) return true;
  tp_case_told rest;
  tp_case_told_at at;
  if (!tell_rest(&rest, &at, &state, told, tilt_deg)) return false;
  *mechanism = at.mechanism;
  return true;
}

/* The sign of one factor less the other; 0 where doubles do not tell. */
static int order_of(const tp_fos_told *one, const tp_fos_told *other) {
  const bool number = one->state == TP_FOS_NUMBER, also = other->state == TP_FOS_NUMBER;
  if (number && also) return tp_near_sign(tp_near_sub(one->value, other->value));
  return number ? -1 : 1; /* of two that are unbounded the first stays */
}

bool tp_case_filter_tell_at(tp_case_told_at *at, tp_case_told *told, tp_near tilt_deg) {
  tp_filter_state state;
  if (!tell_at(&at->mechanism, &state, told, tilt_deg) || !tp_factor_filter(at, told, &state)) {
    return false;
  }
  if (!asks_rest(told, at->mechanism, state.tangent)) return true;
  tp_case_told rest;
  tp_case_told_at rest_at;
  if (!tell_rest(&rest, &rest_at, &state, told, tilt_deg) ||
      !tp_factor_filter(&rest_at, &rest, &state)) {
    return false;
  }
  const int order = rest_at.mechanism != TP_STANDS ? -1 : order_of(&rest_at.fos, &at->fos);
  if (order < 0) {
    const tp_case_sample sample = told->sample;
    *told = rest;
    told->of.loads = &told->loads;
    told->of.capacities = &told->capacities;
    if (told->filter->varies) told->of.shape = &told->own;
    told->sample = sample;
    *at = rest_at;
  }
  return order != 0;
}
