/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The options of a profile: their defaults, what they may be, and their names. */

#include "common/options.h"
#include "roughness/profile.h"

#include <math.h>
#include <string.h>

TP_OPTIONS_END(tp_profile_options, normal_stress_kpa);

void tp_profile_options_init(tp_profile_options *options, size_t size) {
  const tp_profile_options defaults = {.size = sizeof defaults, .scale = 1};
  tp_options_fill(options, size, &defaults);
}

static tp_status refuse(tp_message *message, const char *what) {
  return tp_refuse(message, TP_FAULT_GEOMETRY, (tp_place){0}, "%s", what);
}

tp_status tp_profile_check_options(const tp_profile_options *o, tp_message *message) {
  const bool step = isfinite(o->step) && o->step >= 0;
  const bool scale = isfinite(o->scale) && o->scale > 0;
  const bool jcs = isfinite(o->jcs_mpa) && o->jcs_mpa >= 0;
  const bool stress = isfinite(o->normal_stress_kpa) && o->normal_stress_kpa >= 0;
  if (!step) return refuse(message, "the step must be a finite length, or 0 for the points");
  if (!scale) return refuse(message, "the scale must be a finite number above 0");
  if (!jcs) return refuse(message, "JCS must be a finite pressure, or 0 where it is not known");
  if (!stress) return refuse(message, "the normal stress must be finite, or 0 where not known");
  if ((int)o->resampling < 0 || (int)o->resampling > TP_RESAMPLE_SPLINE) {
    return refuse(message, "there is no such resampling");
  }
  if ((int)o->detrend < 0 || (int)o->detrend > TP_DETREND_TURN) {
    return refuse(message, "there is no such detrend");
  }
  if ((int)o->window < 0 || (int)o->window > TP_WINDOW_NONE) {
    return refuse(message, "there is no such window");
  }
  return TP_OK;
}
