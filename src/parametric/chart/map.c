/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Samples of a scene; and borders between samples that are not alike, by halving: what happens
 * there is one of several, no value that could be interpolated. */

#include "chart/map.h"
#include "chart/mechanism_style.h"
#include "evaluation/case_numbers.h"

#include <stdio.h>

const char *tp_regime_name(tp_regime regime) {
  static const char *const names[] = {
      "no answer",   "stands",   "slides",      "topples",        "slides and topples",
      "tie",         "may move", "interlocked", "does not stand", "leaves its base",
      "can be held", "undecided"};
  return names[regime];
}

tp_chart_style tp_regime_line(tp_regime regime) {
  return regime == TP_REGIME_SLIDES    ? tp_line_slides
         : regime == TP_REGIME_TOPPLES ? tp_line_topples
                                       : tp_line_both;
}

tp_chart_style tp_regime_region(tp_regime regime) {
  switch (regime) {
  case TP_REGIME_SLIDES:
    return tp_region_slides;
  case TP_REGIME_TOPPLES:
    return tp_region_topples;
  case TP_REGIME_BOTH:
  case TP_REGIME_TIE:
    return tp_region_both;
  case TP_REGIME_MAY_MOVE:
  case TP_REGIME_CAN_HOLD:
    return tp_region_history;
  case TP_REGIME_STANDS: /* no map has both */
  case TP_REGIME_INTERLOCKED:
    return tp_region_interlocked;
  case TP_REGIME_NONE:
  case TP_REGIME_NOWHERE:
  case TP_REGIME_LEAVES_BASE:
  case TP_REGIME_UNDECIDED:
    break;
  }
  return tp_region_other;
}

static tp_regime regime_of(const tp_case *own) {
  const tp_limit *limit = &own->limit;
  const tp_onset_kind onset = own->onset.kind;
  switch (limit->kind) {
  case TP_LIMIT_AT_ANGLE:
    if (limit->tie && limit->tied_with != limit->mechanism) return TP_REGIME_TIE;
    return limit->mechanism == TP_SLIDES    ? TP_REGIME_SLIDES
           : limit->mechanism == TP_TOPPLES ? TP_REGIME_TOPPLES
                                            : TP_REGIME_BOTH;
  case TP_LIMIT_INTERLOCKED:
    return onset == TP_ONSET_NEVER || onset == TP_ONSET_NOT_ASKED ? TP_REGIME_INTERLOCKED
           : onset == TP_ONSET_UNDECIDED                          ? TP_REGIME_UNDECIDED
                                                                  : TP_REGIME_MAY_MOVE;
  case TP_LIMIT_NOWHERE:
    return TP_REGIME_NOWHERE;
  case TP_LIMIT_NOT_ASKED:
  case TP_LIMIT_UNDECIDED:
    break;
  }
  return TP_REGIME_UNDECIDED;
}

static tp_regime regime_at_tilt(tp_mechanism mechanism) {
  switch (mechanism) {
  case TP_STANDS:
  case TP_INTERLOCKED:
    return TP_REGIME_STANDS;
  case TP_SLIDES:
    return TP_REGIME_SLIDES;
  case TP_TOPPLES:
    return TP_REGIME_TOPPLES;
  case TP_SLIDES_AND_TOPPLES:
    return TP_REGIME_BOTH;
  case TP_MAY_MOVE:
    return TP_REGIME_MAY_MOVE;
  case TP_LEAVES_BASE:
    return TP_REGIME_LEAVES_BASE;
  case TP_MECHANISM_UNDECIDED:
    break;
  }
  return TP_REGIME_UNDECIDED;
}

static void add_strip(tp_map_sample *sample, unsigned motions, tp_bounded from, tp_bounded to) {
  if (sample->strip_count < TP_STRIPS_MAX) {
    sample->strips[sample->strip_count++] = (tp_strip){motions, from, to};
  } else {
    sample->has_strips = false;
  }
}

/* From level on; two that meet have the same tilt for an end. */
static void take_strips(tp_map_sample *sample, const tp_onset *onset) {
  const tp_bounded level = {0}, upright = {.value = 90};
  sample->has_strips = onset->has_ranges;
  for (size_t k = 0; k < onset->range_count; k++) {
    const tp_motion_range *own = onset->ranges + k;
    const tp_bounded to = own->to_above ? upright : own->to_deg;
    tp_bounded from = own->from_below ? level : own->from_deg;
    if (to.value <= 0) continue;
    if (from.value < 0) from = level;
    const tp_strip *last =
        sample->strip_count > 0 ? sample->strips + sample->strip_count - 1 : NULL;
    if (last != NULL && last->to_deg.value != from.value) add_strip(sample, 0, last->to_deg, from);
    add_strip(sample, own->motions, from, to);
  }
}

static void take(tp_map_sample *sample, const tp_solution *solution, bool at_tilt) {
  const tp_case *own = solution->cases;
  sample->has_limit = own->limit.kind == TP_LIMIT_AT_ANGLE;
  sample->limit_deg = own->limit.critical_angle_deg;
  sample->has_onset = own->onset.kind == TP_ONSET_AT_ANGLE && own->onset.below_limit;
  if (sample->has_onset) sample->onset_deg = own->onset.critical_angle_deg;
  sample->has_toppling = own->has_toppling_pivot && !own->pivots[own->toppling_pivot].never &&
                         !own->pivots[own->toppling_pivot].always;
  sample->governing = own->has_toppling_pivot ? own->pivots[own->toppling_pivot].index : 0;
  if (sample->has_toppling)
    sample->toppling_deg = own->pivots[own->toppling_pivot].critical_angle_deg;
  sample->has_sliding = own->sliding.known && !own->sliding.never && !own->sliding.always;
  if (sample->has_sliding) sample->sliding_deg = own->sliding.critical_angle_deg;
  sample->regime = at_tilt ? regime_at_tilt(own->mechanism) : regime_of(own);
  sample->has_fos = tp_case_fos(&sample->fos, own) == TP_CASE_NUMBER;
  take_strips(sample, &own->onset);
}

static void note_tilt(tp_map *map, const tp_solution *solution) {
  const double own = solution->tilt_angle_deg.value;
  map->tilts_differ |= map->has_tilt && own != map->tilt_deg;
  map->has_tilt = true;
  map->tilt_deg = own;
}

tp_map_sample tp_map_take_sample(tp_map *map, const double *values) {
  if (map->of_many) return tp_map_take_system(map, values);
  tp_map_sample sample = {.regime = TP_REGIME_NONE};
  tp_solution *solution = NULL;
  for (size_t k = 0; k < map->varied.count; k++) sample.values[k] = values[k];
  const tp_status status = tp_varied_solve(&solution, &map->varied, values, &map->why);
  if (status == TP_OK) {
    take(&sample, solution, map->at_tilt);
    if (map->at_tilt) note_tilt(map, solution);
    map->patton = solution->friction_is_patton;
  }
  if (status == TP_UNDECIDED) sample.regime = TP_REGIME_UNDECIDED;
  if (status == TP_OUT_OF_MEMORY || status == TP_SYSTEM_FAILED) {
    map->status = status;
    *map->message = map->why;
  }
  tp_solution_free(solution);
  return sample;
}

bool tp_map_sample_is_like(const tp_map_sample *one, const tp_map_sample *other) {
  if (one->regime != other->regime || one->has_strips != other->has_strips ||
      one->strip_count != other->strip_count) {
    return false;
  }
  for (size_t k = 0; k < one->strip_count; k++) {
    if (one->strips[k].motions != other->strips[k].motions) return false;
  }
  return true;
}

/* The regime alone, in doubles; false where these do not tell it. */
static bool tell_regime(tp_map_sample *sample, const tp_map *map, const double *values) {
  tp_case_told told;
  tp_near tilt_deg;
  *sample = (tp_map_sample){.regime = TP_REGIME_NONE};
  for (size_t k = 0; k < map->varied.count; k++) sample->values[k] = values[k];
  if (map->filter == NULL || !tp_keyed_filter_tell(&told, &tilt_deg, map->filter, values)) {
    return false;
  }
  tp_mechanism mechanism = told.limit;
  const bool asks_tilt = map->at_tilt && map->filter->has_tilt;
  if (asks_tilt && !tp_case_filter_tell_mechanism(&mechanism, &told, tilt_deg)) return false;
  sample->regime = regime_at_tilt(mechanism); /* of a limit at an angle the same */
  return true;
}

void tp_map_border(tp_map *map, tp_map_sample *low, tp_map_sample *high) {
  for (int step = 0; step < map->border_steps && map->status == TP_OK; step++) {
    double middle[TP_VARIED_MAX];
    bool moved = false;
    for (size_t k = 0; k < map->varied.count; k++) {
      const double a = low->values[k], b = high->values[k];
      middle[k] = a + (b - a) / 2;
      moved |= middle[k] != a && middle[k] != b;
    }
    if (!moved) return;
    tp_map_sample found;
    if (!tell_regime(&found, map, middle)) found = tp_map_take_sample(map, middle);
    if (tp_map_sample_is_like(&found, low)) {
      *low = found;
    } else {
      *high = found;
    }
  }
}

void tp_map_border_name(char *text, size_t size, tp_regime one, tp_regime other) {
  const tp_regime first = one < other ? one : other, last = one < other ? other : one;
  snprintf(text, size, "%s | %s", tp_regime_name(first), tp_regime_name(last));
}

void tp_map_begin(tp_map *map, tp_chart_style style, const char *series, const char *of) {
  tp_chart_add_series(map->chart, style, (const char *const[]){series, of, NULL});
}

tp_status tp_map_no_answer(const tp_map *map) {
  return tp_fail(map->message, TP_NO_ANSWER, (tp_place){map->varied.scene->path, 0, 0},
                 "nowhere in the map the scene has an answer; %s", map->why.text);
}
