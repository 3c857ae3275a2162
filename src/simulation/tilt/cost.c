/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Estimate of the steps of a run from its duration and step length, its comparison with the budget,
 * and the refusal that names the number at fault. */

#include "tilt/cost.h"

#include "common/budget.h"
#include "common/message.h"
#include "contact_springs/springs.h"
#include "tilt/settings.h"

#include <math.h>

/* A step of rigid contacts in these units. */
static const double rigid_unit = TP_BUDGET_SPRING_STEPS / (double)TP_BUDGET_RIGID_STEPS;

static double unit_of(const tp_tilting *tilting) {
  return tilting->settings->engine == TP_TILT_SPRINGS ? 1 : rigid_unit;
}

static double budget_of(const tp_tilting *tilting) {
  return TP_BUDGET_SPRING_STEPS * (tilting->budgets > 0 ? tilting->budgets : 1);
}

double tp_tilting_search_budgets(size_t factors) {
  static const double least = 25, factors_of_one = 4;
  return fmax(least, (double)factors / factors_of_one);
}

double tp_tilting_steps_left(const tp_tilting *tilting) {
  const double own = budget_of(tilting);
  const double left = own * fmax(tilting->search, 1) - tilting->spent;
  return fmax(1, fmin(own, left) / unit_of(tilting));
}

double tp_tilting_runs_left(const tp_tilting *tilting) {
  const double each = tilting->own->runs > 0 ? tilting->spent / (double)tilting->own->runs : 0;
  return floor(fmax(0, budget_of(tilting) - tilting->spent) / fmax(each, 1));
}

void tp_tilting_count_steps(tp_tilting *tilting, double steps) {
  tilting->spent += steps * unit_of(tilting);
}

static double spring_step(const tp_tilting *tilting) {
  const tp_tilt_settings *s = tilting->settings;
  const tp_spring_settings springs = {.normal_pa_m = s->normal_stiffness_pa_m,
                                      .shear_pa_m = s->shear_stiffness_pa_m,
                                      .damping = s->damping,
                                      .rounding_m = s->rounding_m,
                                      .time_step_s = s->time_step_s};
  return tp_springs_step(&springs, tilting->body);
}

static tp_place place_of(const tp_quantity *quantity, tp_place otherwise) {
  return quantity->given ? quantity->place : otherwise;
}

/* Of the component that shakes for longest: its frequency, or its record. */
static tp_place place_of_shaking(const tp_tilting *tilting, tp_place otherwise) {
  tp_place place = otherwise;
  double longest = 0;
  for (int k = 0; tilting->shaken != NULL && k < TP_SHAKING_AXES; k++) {
    const tp_shaking_component *own = tilting->shaken + k;
    if (own->form == TP_SHAKING_NONE) continue;
    const bool record = own->form == TP_SHAKING_RECORD;
    const double lasts = record ? fmpq_get_d(own->record.x + own->record.count - 1)
                                : 1 / fmpq_get_d(own->frequency_hz.value);
    if (!(lasts > longest)) continue;
    longest = lasts;
    place = record ? own->place : place_of(&own->frequency_hz, own->place);
  }
  return place;
}

/* The number that asks for most of the time, or for the step. */
static tp_place place_of_cost(const tp_tilting *tilting, double longest_s) {
  const tp_tilt_test_description *asked = tilting->asked;
  const tp_tilt_settings *s = tilting->settings;
  static const double ordinary_s = 3600;
  if (asked == NULL) return place_of_shaking(tilting, (tp_place){0});
  const tp_place test = asked->place;
  if (tilting->shaking != NULL && tilting->shaking_s > longest_s / 2) {
    return place_of_shaking(tilting, test);
  }
  if (asked->duration_s.given && s->duration_s > longest_s / 2 &&
      (s->duration_s > ordinary_s || s->engine == TP_TILT_RIGID)) {
    return asked->duration_s.place;
  }
  if (asked->speed_deg_min.given && longest_s > ordinary_s) return asked->speed_deg_min.place;
  if (asked->time_step_s.given) return asked->time_step_s.place;
  const bool shear = s->shear_stiffness_pa_m > s->normal_stiffness_pa_m;
  return place_of(shear ? &asked->shear_stiffness_gpa_m : &asked->normal_stiffness_gpa_m, test);
}

static tp_status refuse_springs(const tp_tilting *tilting, double longest_s, double step_s) {
  return tp_refuse(
      tilting->message, TP_FAULT_RANGE, place_of_cost(tilting, longest_s),
      "up to %.3g s in steps of %.3g s are %.2g steps, and at most %.2g are made: give "
      "softer springs%s, or a shorter time by 'speed_deg_min', 'until_deg' or "
      "'duration_s'",
      longest_s, step_s, longest_s / step_s, budget_of(tilting),
      tilting->settings->time_step_s > 0 ? " or a longer 'time_step_s'" : "");
}

static tp_status refuse_rigid(const tp_tilting *tilting, double longest_s, double steps) {
  return tp_refuse(
      tilting->message, TP_FAULT_RANGE, place_of_cost(tilting, longest_s),
      "up to %.3g s, %.3g times what this block needs for a fall from its extent, take "
      "%.2g steps, and at most %.2g are made: let it shake for a shorter time, by a "
      "higher frequency or a record of smaller steps, or give a shorter 'duration_s'",
      longest_s, longest_s / tp_tilt_time_scale(tilting->body), steps,
      budget_of(tilting) / rigid_unit);
}

tp_status tp_tilting_check_cost(const tp_tilting *tilting, double longest_s) {
  static const double looks = 50; /* in a time scale, while its base shakes (rigid_contact/begin.c);
                                     a moving block takes fewer steps */
  if (tilting->settings->engine == TP_TILT_SPRINGS) {
    const double step_s = spring_step(tilting);
    if (longest_s / step_s <= budget_of(tilting)) return TP_OK;
    return refuse_springs(tilting, longest_s, step_s);
  }
  const double shaken_s = tilting->shaking != NULL ? tilting->shaking_s : 0;
  const double lasts = tilting->shaking != NULL || tilting->settings->set_down
                           ? longest_s
                           : tp_tilt_duration(tilting->settings, tilting->body);
  const double steps = looks * fmax(shaken_s, lasts) / tp_tilt_time_scale(tilting->body);
  if (steps * rigid_unit <= budget_of(tilting)) return TP_OK;
  return refuse_rigid(tilting, lasts, steps);
}
