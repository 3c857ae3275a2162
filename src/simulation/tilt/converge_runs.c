/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Levels of each numerical setting of a tilt test (factors on stiffness, time step, damping,
 * rounding, tolerances) and the run that each level stands for (docs/tilt_converge.md). */

#include "contact_springs/springs.h"
#include "rigid_contact/rigid_contact.h"
#include "tilt/converge.h"

#include <math.h>

/* Of the wanted width: two brackets that agree are told from two that do not. */
static const double bracket_share = 0.25;

/* Of the longest stable step, that which springs take where none is given; and beyond which a step
 * is not tried. */
static const double chosen_share = 0.2, most_share = 0.9;

/* The ratios of stiffness that contacts of rock have; the paper's is the first. */
static const double ratios[] = {0.01, 0.1, 1};

/* Times the scene's own value, from coarse to fine; 0 ends them. */
static const double factors[TP_CONVERGE_SETTINGS][TP_CONVERGE_MOST_LEVELS] = {
    [TP_CONVERGE_TOLERANCE] = {16, 4, 1, 0.25}, [TP_CONVERGE_STIFFNESS] = {0.1, 1, 10, 100, 1000},
    [TP_CONVERGE_TIME_STEP] = {4, 2, 1, 0.5},   [TP_CONVERGE_DAMPING] = {1, 0.5, 0.25},
    [TP_CONVERGE_ROUNDING] = {10, 1, 0.1},      [TP_CONVERGE_STEP_TOLERANCE] = {1e6, 1e4, 1e2, 1},
    [TP_CONVERGE_LEAST_BOUNCE] = {1e2, 1, 1e-2}};

/* Of a path, which is told in the limit of stiff contacts. */
static const double path_factors[TP_CONVERGE_MOST_LEVELS] = {1, 1e2, 1e4, 1e6, INFINITY};

tp_converge_run tp_converge_own(const tp_tilt_settings *settings) {
  const tp_rigid_contact_settings rigid = tp_rigid_contact_settings_default();
  tp_converge_run own = {
      .settings = *settings, .step_tolerance = rigid.tolerance, .least_bounce = rigid.least_bounce};
  own.settings.tolerance_deg *= bracket_share;
  return own;
}

static bool has(tp_converge_setting setting, tp_tilt_engine engine, tp_converge_quantity quantity) {
  switch (setting) {
  case TP_CONVERGE_TOLERANCE:
    return quantity == TP_CONVERGE_ANGLE;
  case TP_CONVERGE_STIFFNESS:
  case TP_CONVERGE_STIFFNESS_RATIO:
    return engine != TP_TILT_RIGID;
  case TP_CONVERGE_TIME_STEP:
  case TP_CONVERGE_DAMPING:
  case TP_CONVERGE_ROUNDING:
    return engine == TP_TILT_SPRINGS;
  case TP_CONVERGE_STEP_TOLERANCE:
    return engine == TP_TILT_RIGID;
  case TP_CONVERGE_LEAST_BOUNCE: /* nothing bounces before the block begins to move */
    return engine == TP_TILT_RIGID && quantity == TP_CONVERGE_OVERTURNING;
  }
  return false;
}

static tp_spring_settings springs_of(const tp_tilt_settings *s) {
  return (tp_spring_settings){.normal_pa_m = s->normal_stiffness_pa_m,
                              .shear_pa_m = s->shear_stiffness_pa_m,
                              .damping = s->damping,
                              .rounding_m = s->rounding_m,
                              .time_step_s = s->time_step_s};
}

static double stable_step(const tp_tilt_settings *s, const tp_rigid_body *body) {
  const tp_spring_settings springs = springs_of(s);
  return tp_springs_stable_step(&springs, body);
}

static double own_value(const tp_converge_run *own, tp_converge_setting setting,
                        const tp_rigid_body *body) {
  const tp_tilt_settings *s = &own->settings;
  switch (setting) {
  case TP_CONVERGE_TOLERANCE:
    return s->tolerance_deg / bracket_share;
  case TP_CONVERGE_STIFFNESS:
    return s->normal_stiffness_pa_m;
  case TP_CONVERGE_STIFFNESS_RATIO:
    return s->shear_stiffness_pa_m / s->normal_stiffness_pa_m;
  case TP_CONVERGE_TIME_STEP:
    return s->time_step_s > 0 ? s->time_step_s : chosen_share * stable_step(s, body);
  case TP_CONVERGE_DAMPING:
    return s->damping;
  case TP_CONVERGE_ROUNDING:
    return s->rounding_m;
  case TP_CONVERGE_STEP_TOLERANCE:
    return own->step_tolerance;
  case TP_CONVERGE_LEAST_BOUNCE:
    return own->least_bounce;
  }
  return 0;
}

static void put_stiffness(tp_tilt_settings *s, double normal_pa_m) {
  s->shear_stiffness_pa_m *= normal_pa_m / s->normal_stiffness_pa_m;
  s->normal_stiffness_pa_m = normal_pa_m;
  s->time_step_s = 0; /* one that is given is stable for the stiffness that is given */
}

static void put(tp_converge_run *run, tp_converge_setting setting, double value) {
  tp_tilt_settings *s = &run->settings;
  run->setting = setting;
  run->value = value;
  switch (setting) {
  case TP_CONVERGE_TOLERANCE:
    s->tolerance_deg = value;
    run->path_tolerance_deg = value;
    break;
  case TP_CONVERGE_STIFFNESS:
    run->weight_moves = isfinite(value);
    if (isfinite(value) && value != s->normal_stiffness_pa_m) put_stiffness(s, value);
    break;
  case TP_CONVERGE_STIFFNESS_RATIO:
    s->shear_stiffness_pa_m = value * s->normal_stiffness_pa_m;
    break;
  case TP_CONVERGE_TIME_STEP:
    s->time_step_s = value;
    break;
  case TP_CONVERGE_DAMPING:
    s->damping = value;
    break;
  case TP_CONVERGE_ROUNDING:
    s->rounding_m = value;
    break;
  case TP_CONVERGE_STEP_TOLERANCE:
    run->step_tolerance = value;
    break;
  case TP_CONVERGE_LEAST_BOUNCE:
    run->least_bounce = value;
    break;
  }
}

/* The rising ratios, the scene's own among them. */
static size_t runs_of_ratios(tp_converge_run runs[], const tp_converge_run *own, double value) {
  const size_t count = sizeof ratios / sizeof *ratios;
  size_t made = 0, k = 0;
  bool placed = false;
  while (k < count || !placed) {
    const bool first = !placed && (k == count || value <= ratios[k] * (1 + 1e-9));
    const double next = first ? value : ratios[k];
    k += first ? k < count && value >= ratios[k] * (1 - 1e-9) : 1;
    placed = placed || first;
    runs[made] = *own;
    put(runs + made, TP_CONVERGE_STIFFNESS_RATIO, next);
    runs[made++].own = first;
  }
  return made;
}

size_t tp_converge_runs(tp_converge_run runs[TP_CONVERGE_MOST_LEVELS], tp_converge_setting setting,
                        const tp_converge_run *own, tp_converge_quantity quantity,
                        const tp_rigid_body *body) {
  const tp_tilt_engine engine = own->settings.engine;
  if (!has(setting, engine, quantity)) return 0;
  const double value = own_value(own, setting, body);
  if (!(value > 0)) return 0;
  if (setting == TP_CONVERGE_STIFFNESS_RATIO) return runs_of_ratios(runs, own, value);
  const bool of_path = setting == TP_CONVERGE_STIFFNESS && engine == TP_TILT_PATH;
  const double *by = of_path ? path_factors : factors[setting];
  size_t made = 0;
  for (size_t k = 0; k < TP_CONVERGE_MOST_LEVELS && by[k] > 0; k++) {
    const bool is_own = of_path ? isinf(by[k]) : by[k] == 1;
    if (setting == TP_CONVERGE_TIME_STEP && !is_own &&
        by[k] * value > most_share * stable_step(&own->settings, body)) {
      continue;
    }
    runs[made] = *own;
    put(runs + made, setting, by[k] * value);
    runs[made++].own = is_own;
  }
  return made;
}
