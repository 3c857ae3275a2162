/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The multiple lambda of the driving loads D, beside the resisting loads R, at which a motion
 * begins, as onset/onset_driving.c has it in balls. Of the weight alone, and of loads that act at
 * the centroid, it follows from the onset. Of others it is the onset under loads R + t D, t =
 * lambda; and where cohesion or bonds act, which in these forms go with s = 1 / cos, under s R + t
 * (M D) with t = tan a and lambda = M sin a, up to the multiple M. */

#include "case_filter/driving_filter.h"

#include "case_filter/limit_filter.h"

static const tp_near zero = {0, 0}, one = {1, 0};

/* ---- resisting and driving loads ---------------------------------------------------------------
 */

/* At the tilt, over the weight and cos(tilt): (f_x, f_y, moment) as the base bears them. */
typedef struct split {
  tp_near rests[3], drives[3];
  bool any; /* something drives */
} split;

static void add(tp_near to[3], const tp_near of[3], tp_near times) {
  for (int k = 0; k < 3; k++) to[k] = tp_near_plus(to[k], tp_near_times(times, of[k]));
}

static void load_at(tp_near at[3], const tp_filter_load *load, tp_near tangent, tp_near secant) {
  for (int k = 0; k < 3; k++) at[k] = zero;
  add(at, load->at, one);
  add(at, load->rise, tangent);
  add(at, load->fixed, secant);
}

/* 1 where it points down-dip and off the base together, or neither, -1 where it does not, 0 where
 * that is open; `push` is the sum of the loads that drive, or not, as one. */
static int pushes(const tp_near push[3]) {
  const tp_near sum = tp_near_minus(push[0], push[1]);
  return tp_near_is_zero(sum) ? 1 : tp_near_sign(sum);
}

static bool set_split(split *s, const tp_filter_loads *loads, tp_near tangent) {
  const tp_near secant = tp_tilt_secant(tangent);
  tp_near water[3] = {zero, zero, zero};
  bool told = true;
  *s = (split){.any = false};
  for (int k = 0; k < 3; k++) s->rests[k] = s->drives[k] = zero;
  for (int k = 0; k < loads->count; k++) {
    const tp_filter_load *load = loads->items + k;
    tp_near at[3];
    load_at(at, load, tangent, secant);
    int side = -1;
    switch (load->side) {
    case TP_FILTER_GRAVITY:
      add(s->rests, load->at, one);
      add(s->drives, load->rise, tangent);
      continue;
    case TP_FILTER_WATER:
      add(water, at, one);
      continue;
    case TP_FILTER_EARTHQUAKE:
      side = 1;
      break;
    case TP_FILTER_PUSH:
      side = pushes(at);
      break;
    case TP_FILTER_SUPPORT:
      side = load->active ? 1 : -1;
      break;
    }
    told = told && side != 0;
    add(side > 0 ? s->drives : s->rests, at, one);
  }
  const int side = pushes(water);
  add(side > 0 ? s->drives : s->rests, water, one);
  for (int k = 0; k < 3; k++) s->any = s->any || !tp_near_is_zero(s->drives[k]);
  return told && side != 0;
}

/* ---- where a motion begins ---------------------------------------------------------------------
 */

static void set_mechanism(tp_driving_told *d, const tp_onset_filter *o, tp_near end) {
  static const double beside = 0x1p-30;
  bool moves = false;
  unsigned beginnings = 0;
  const tp_near at = tp_near_mul(end, (tp_near){1 + beside, 0});
  d->has_mechanism = tp_onset_filter_look(&moves, &beginnings, o, at) && beginnings != 0;
  if (!d->has_mechanism) return;
  int first = TP_SLIDES;
  while ((beginnings & 1U << first) == 0) first++;
  d->mechanism = (tp_mechanism)first;
  d->has_mechanism = beginnings == 1U << first;
}

/* The onset, where it is the end of the window that is next to the scene's own state, at `own`:
 * above it of a block that stands, below it of one that moves. */
static bool is_next(const tp_onset_filter *o, tp_near own, bool moves) {
  if (moves) return !o->never && tp_filter_begins_from(o, o->tangent, own) == TP_FILTER_COUNTS;
  return o->never || tp_near_sign(tp_near_sub(o->tangent, own)) > 0;
}

/* A motion begins there, at `end` of the question's tangents. */
static bool finish(tp_driving_told *d, const tp_onset_filter *o, tp_near end, tp_near factor) {
  if (!isfinite(factor.error) || tp_near_sign(factor) <= 0) return false;
  d->fos = (tp_fos_told){TP_FOS_NUMBER, factor};
  set_mechanism(d, o, end);
  return true;
}

static tp_near cross(const tp_near a[3], const tp_near b[3]) {
  return tp_near_minus(tp_near_times(a[0], b[1]), tp_near_times(a[1], b[0]));
}

/* R + lambda D has the direction of all loads at the onset. Where what drives lifts the block that
 * direction goes beyond 90 degrees from the normal, and so beyond all tilts. */
static bool find_by_direction(tp_driving_told *d, const tp_case_told *told, const split *s) {
  const bool lifts = !(s->drives[1].value - s->drives[1].error >= 0);
  tp_near at[3];
  if (told->onset.never) return !lifts;
  tp_filter_loads_at(at, told->of.loads, told->onset.tangent);
  const tp_near over = cross(s->drives, at);
  if (tp_near_sign(over) == 0) return false;
  const tp_near factor = tp_near_neg(tp_near_div(cross(s->rests, at), over));
  if (tp_near_sign(factor) < 0) return !lifts; /* at no multiple */
  return finish(d, &told->onset, told->onset.tangent, factor);
}

/* Of any loads without cohesion or bonds. */
static bool find_by_modes(tp_driving_told *d, const tp_case_told *told, const split *s,
                          bool moves) {
  tp_filter_loads loads = *told->of.loads;
  tp_filter_case of = told->of;
  tp_onset_filter onset;
  loads.stays = false;
  for (int k = 0; k < 3; k++) {
    loads.sum.at[k] = s->rests[k];
    loads.sum.rise[k] = s->drives[k];
    loads.sum.fixed[k] = zero;
  }
  of.loads = &loads;
  bool never = false;
  tp_near end;
  if (!tp_onset_filter_modes(&onset, &of) ||
      !tp_onset_filter_end(&never, &end, &onset, one, moves)) {
    return false;
  }
  return never || finish(d, &onset, end, end);
}

/* Under cohesion and bonds, where forces have to hold the block up to there. */
static bool find_by_strong_modes(tp_driving_told *d, const tp_case_told *told, const split *s,
                                 bool moves, tp_near tangent) {
  static const double most = 64;
  const tp_near secant = tp_tilt_secant(tangent);
  tp_filter_loads loads = *told->of.loads;
  tp_filter_case of = told->of;
  tp_onset_filter onset;
  for (int k = 0; k < 3; k++) {
    loads.sum.at[k] = zero;
    loads.sum.rise[k] = tp_near_div(tp_near_times((tp_near){most, 0}, s->drives[k]), secant);
    loads.sum.fixed[k] = tp_near_div(s->rests[k], secant);
  }
  of.loads = &loads;
  const tp_near own = tp_near_div(one, tp_near_sqrt((tp_near){most * most - 1, 0}));
  bool never = false;
  tp_near end;
  if (!tp_onset_filter_modes(&onset, &of) ||
      !tp_onset_filter_end(&never, &end, &onset, own, moves) || never) {
    return false;
  }
  tp_edge_set edges;
  tp_limit_filter limit;
  tp_edge_set_init(&edges, &of);
  if (!tp_limit_filter_find(&limit, &edges) || tp_near_sign(tp_near_sub(end, limit.value)) > 0) {
    return false;
  }
  const tp_near sine = tp_near_div(end, tp_tilt_secant(end));
  return finish(d, &onset, end, tp_near_mul((tp_near){most, 0}, sine));
}

bool tp_driving_filter(tp_driving_told *d, const tp_case_told *told, const tp_filter_state *s) {
  const tp_filter_loads *loads = told->of.loads;
  *d = (tp_driving_told){.fos = {.state = TP_FOS_NO_OVERTURNING},
                         .mechanism = TP_MECHANISM_UNDECIDED};
  if (!loads->called_for && !told->of.capacities->acts) {
    if (!is_next(&told->onset, s->tangent, s->moves)) return false;
    if (told->onset.never || tp_near_is_zero(s->tangent)) return true;
    return finish(d, &told->onset, told->onset.tangent,
                  tp_near_div(told->onset.tangent, s->tangent));
  }
  split split;
  if (!set_split(&split, loads, s->tangent)) return false;
  if (!split.any) return !s->moves;
  if (told->of.capacities->acts) {
    return find_by_strong_modes(d, told, &split, s->moves, s->tangent);
  }
  if (loads->turns || loads->stays) return find_by_modes(d, told, &split, s->moves);
  if (!is_next(&told->onset, s->tangent, s->moves)) return false;
  return find_by_direction(d, told, &split);
}
