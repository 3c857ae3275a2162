/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Acceleration, next kink, and peak acceleration, velocity and displacement of pulses in closed
 * form and of records by exact integration of straight pieces. */

#include "shaking/shaking.h"

#include <math.h>
#include <stdlib.h>

/* ---- one axis ----------------------------------------------------------------------------------
 */

static double pulse_end(const tp_base_acceleration *axis) {
  return (axis->form == TP_SHAKING_HALF_SINE ? 0.5 : 1.0) / axis->frequency_hz;
}

/* The last sample at or before a time, of two at least that lie on both sides of it. */
static size_t sample_before(const tp_base_acceleration *axis, double time_s) {
  size_t low = 0, high = axis->count - 1;
  while (high - low > 1) {
    const size_t middle = low + (high - low) / 2;
    if (axis->time_s[middle] <= time_s) {
      low = middle;
    } else {
      high = middle;
    }
  }
  return low;
}

double tp_base_acceleration_at(const tp_base_acceleration *axis, double time_s) {
  if (axis->form == TP_SHAKING_NONE || time_s < 0) return 0;
  if (axis->form != TP_SHAKING_RECORD) {
    if (time_s > pulse_end(axis)) return 0;
    return axis->peak_m_s2 * sin(2 * M_PI * axis->frequency_hz * time_s);
  }
  if (time_s > axis->time_s[axis->count - 1]) return 0;
  const size_t k = sample_before(axis, time_s);
  const double from = axis->time_s[k], to = axis->time_s[k + 1];
  const double share = (time_s - from) / (to - from);
  return (1 - share) * axis->value_m_s2[k] + share * axis->value_m_s2[k + 1];
}

/* A kink that is nearer than this share of the step between samples, or of the pulse, is passed: an
 * integrator that came to it but for rounding would be asked for a step of nothing. */
static const double passed = 1e-9;

double tp_base_acceleration_next_kink(const tp_base_acceleration *axis, double time_s) {
  if (axis->form == TP_SHAKING_NONE) return INFINITY;
  if (time_s < 0) return 0;
  if (axis->form != TP_SHAKING_RECORD) {
    const double end = pulse_end(axis);
    return time_s < (1 - passed) * end ? end : INFINITY;
  }
  const double last = axis->time_s[axis->count - 1], near = time_s + passed * axis->time_s[1];
  return near < last ? axis->time_s[sample_before(axis, near) + 1] : INFINITY;
}

static tp_shaking_peaks pulse_peaks(const tp_base_acceleration *axis) {
  /* the integral over half a period; the second half of a full sine takes it back */
  const double velocity = fabs(axis->peak_m_s2) / (M_PI * axis->frequency_hz);
  const bool half = axis->form == TP_SHAKING_HALF_SINE;
  return (tp_shaking_peaks){fabs(axis->peak_m_s2), velocity,
                            half ? axis->peak_m_s2 / (M_PI * axis->frequency_hz) : 0,
                            pulse_end(axis)};
}

tp_shaking_peaks tp_base_acceleration_peaks(const tp_base_acceleration *axis) {
  tp_shaking_peaks peaks = {0};
  double velocity = 0;
  if (axis->form == TP_SHAKING_NONE) return peaks;
  if (axis->form != TP_SHAKING_RECORD) return pulse_peaks(axis);
  for (size_t k = 0; k < axis->count; k++) {
    peaks.acceleration_m_s2 = fmax(peaks.acceleration_m_s2, fabs(axis->value_m_s2[k]));
    if (k + 1 == axis->count) break;
    const double from = axis->value_m_s2[k], to = axis->value_m_s2[k + 1];
    const double step = axis->time_s[k + 1] - axis->time_s[k];
    if (from * to < 0) { /* the velocity is extreme where the acceleration passes zero */
      peaks.velocity_m_s =
          fmax(peaks.velocity_m_s, fabs(velocity + 0.5 * from * step * from / (from - to)));
    }
    velocity += 0.5 * (from + to) * step;
    peaks.velocity_m_s = fmax(peaks.velocity_m_s, fabs(velocity));
  }
  peaks.last_velocity_m_s = velocity;
  peaks.duration_s = axis->time_s[axis->count - 1];
  return peaks;
}

/* ---- both --------------------------------------------------------------------------------------
 */

static void acceleration(double *horizontal_m_s2, double *vertical_m_s2,
                         const tp_base_motion *motion, double time_s) {
  const tp_base_shaking *shaking = motion->data;
  *horizontal_m_s2 =
      shaking->factor * tp_base_acceleration_at(shaking->axes + TP_SHAKING_HORIZONTAL, time_s);
  *vertical_m_s2 =
      shaking->factor * tp_base_acceleration_at(shaking->axes + TP_SHAKING_VERTICAL, time_s);
}

static double next_kink(const tp_base_motion *motion, double time_s) {
  const tp_base_shaking *shaking = motion->data;
  return fmin(tp_base_acceleration_next_kink(shaking->axes + TP_SHAKING_HORIZONTAL, time_s),
              tp_base_acceleration_next_kink(shaking->axes + TP_SHAKING_VERTICAL, time_s));
}

double tp_base_shaking_duration(const tp_base_shaking *shaking) {
  double longest = 0;
  for (int k = 0; k < TP_SHAKING_AXES; k++) {
    longest = fmax(longest, tp_base_acceleration_peaks(shaking->axes + k).duration_s);
  }
  return longest;
}

void tp_base_shaking_hasten(tp_base_shaking *shaking, double factor) {
  for (int axis = 0; axis < TP_SHAKING_AXES; axis++) {
    tp_base_acceleration *own = shaking->axes + axis;
    own->frequency_hz *= factor;
    for (size_t k = 0; k < own->count; k++) own->time_s[k] /= factor;
  }
}

static tp_status init_record(tp_base_acceleration *own, const tp_shaking_component *given,
                             tp_message *message) {
  const tp_polyline *record = &given->record;
  const double scale =
      TP_GRAVITY_M_S2 * (given->scale.given ? fmpq_get_d(given->scale.value) : 1.0);
  bool moves = false;
  own->count = (size_t)record->count;
  own->time_s = calloc(own->count, sizeof *own->time_s);
  own->value_m_s2 = calloc(own->count, sizeof *own->value_m_s2);
  if (own->time_s == NULL || own->value_m_s2 == NULL) {
    return tp_fail_memory(message, "the shaking of the base");
  }
  for (size_t k = 0; k < own->count; k++) {
    own->time_s[k] = fmpq_get_d(record->x + k);
    own->value_m_s2[k] = scale * fmpq_get_d(record->y + k);
    moves = moves || own->value_m_s2[k] != 0;
  }
  if (moves) return TP_OK;
  return tp_refuse(message, TP_FAULT_RANGE, given->place,
                   "this accelerogram is zero throughout, by its samples or its scale; leave the "
                   "shaking out");
}

tp_status tp_base_shaking_init(tp_base_shaking *shaking, const tp_scene *scene,
                               tp_message *message) {
  tp_status status = TP_OK;
  *shaking = (tp_base_shaking){.factor = 1, .motion = {shaking, acceleration, next_kink}};
  for (int axis = 0; axis < TP_SHAKING_AXES && status == TP_OK; axis++) {
    const tp_shaking_component *given = scene->shaking + axis;
    tp_base_acceleration *own = shaking->axes + axis;
    own->form = given->form;
    if (given->form == TP_SHAKING_RECORD) {
      status = init_record(own, given, message);
    } else if (given->form != TP_SHAKING_NONE) {
      own->peak_m_s2 = TP_GRAVITY_M_S2 * fmpq_get_d(given->peak_g.value);
      own->frequency_hz = fmpq_get_d(given->frequency_hz.value);
    }
  }
  if (status != TP_OK) tp_base_shaking_clear(shaking);
  return status;
}

void tp_base_shaking_clear(tp_base_shaking *shaking) {
  for (int axis = 0; axis < TP_SHAKING_AXES; axis++) {
    free(shaking->axes[axis].time_s);
    free(shaking->axes[axis].value_m_s2);
  }
  *shaking = (tp_base_shaking){.motion = {NULL, NULL, NULL}};
}
