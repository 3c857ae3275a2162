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

static const char *const resamplings[] = {"linear", "spline"};
static const char *const detrends[] = {"none", "line", "ends", "turn"};
static const char *const windows[] = {"hann", "none"};

/* The index of a name; -1 where it is none of them. */
static int index_of(const char *name, const char *const *names, int count) {
  for (int k = 0; k < count && name != NULL; k++) {
    if (strcmp(name, names[k]) == 0) return k;
  }
  return -1;
}

static const char *name_of(int index, const char *const *names, int count) {
  return index >= 0 && index < count ? names[index] : "unknown";
}

enum {
  RESAMPLINGS = sizeof resamplings / sizeof resamplings[0],
  DETRENDS = sizeof detrends / sizeof detrends[0],
  WINDOWS = sizeof windows / sizeof windows[0]
};

bool tp_profile_resampling_read(tp_profile_resampling *resampling, const char *name) {
  const int index = index_of(name, resamplings, RESAMPLINGS);
  if (index < 0 || resampling == NULL) return false;
  *resampling = (tp_profile_resampling)index;
  return true;
}

const char *tp_profile_resampling_name(tp_profile_resampling resampling) {
  return name_of((int)resampling, resamplings, RESAMPLINGS);
}

bool tp_profile_detrend_read(tp_profile_detrend *detrend, const char *name) {
  const int index = index_of(name, detrends, DETRENDS);
  if (index < 0 || detrend == NULL) return false;
  *detrend = (tp_profile_detrend)index;
  return true;
}

const char *tp_profile_detrend_name(tp_profile_detrend detrend) {
  return name_of((int)detrend, detrends, DETRENDS);
}

bool tp_profile_window_read(tp_profile_window *window, const char *name) {
  const int index = index_of(name, windows, WINDOWS);
  if (index < 0 || window == NULL) return false;
  *window = (tp_profile_window)index;
  return true;
}

const char *tp_profile_window_name(tp_profile_window window) {
  return name_of((int)window, windows, WINDOWS);
}

static tp_status refuse(tp_message *message, const char *what) {
  return tp_fail(message, TP_BAD_INPUT, (tp_place){0}, "%s", what);
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
  if ((int)o->resampling < 0 || (int)o->resampling >= RESAMPLINGS) {
    return refuse(message, "there is no such resampling");
  }
  if ((int)o->detrend < 0 || (int)o->detrend >= DETRENDS) {
    return refuse(message, "there is no such detrend");
  }
  if ((int)o->window < 0 || (int)o->window >= WINDOWS) {
    return refuse(message, "there is no such window");
  }
  return TP_OK;
}
