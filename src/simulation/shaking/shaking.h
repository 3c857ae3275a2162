/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The shaking of a base as a function of time: sine pulses, and accelerograms.
 *
 * A pulse of peak a and frequency f is a sin(2 pi f t), over half a period or a whole one from time
 * 0, and nothing after it. An accelerogram is taken as it is, linear between its samples, nothing
 * before the first and after the last; it is not filtered, and its baseline not corrected: what its
 * velocity comes to at its end is told. A cubic spline through the samples would exceed their peak,
 * which is what decides. Velocities are exact integrals of that but for rounding: relative error
 * below 1e-15 times the number of samples. */

#ifndef TP_SHAKING_SHAKING_H
#define TP_SHAKING_SHAKING_H

#include "rigid_body/drive.h"
#include "scene/scene.h"

/* The acceleration along one axis. */
typedef struct tp_base_acceleration {
  tp_shaking_form form;
  double peak_m_s2, frequency_hz; /* of a pulse */
  size_t count;                   /* of an accelerogram */
  double *time_s, *value_m_s2;
} tp_base_acceleration;

typedef struct tp_base_shaking {
  tp_base_acceleration axes[TP_SHAKING_AXES]; /* as the scene has them */
  double factor;                              /* on both, in `motion` */
  tp_base_motion motion; /* for a drive; refers to this struct, which must not move */
} tp_base_shaking;

/* The shaking that a scene calls for. */
TP_MUST_USE tp_status tp_base_shaking_init(tp_base_shaking *shaking, const tp_scene *scene,
                                           tp_message *message);
void tp_base_shaking_clear(tp_base_shaking *shaking);

/* All of it `factor` times as fast, its accelerations as they are: the frequency of a pulse, the
 * times of a record. */
void tp_base_shaking_hasten(tp_base_shaking *shaking, double factor);

/* Along one axis: the acceleration at a time, and the next time after it at which it is not
 * smooth (INFINITY: none). */
double tp_base_acceleration_at(const tp_base_acceleration *axis, double time_s);
double tp_base_acceleration_next_kink(const tp_base_acceleration *axis, double time_s);

/* What one axis amounts to. */
typedef struct tp_shaking_peaks {
  double acceleration_m_s2; /* PGA: the largest absolute value */
  double velocity_m_s;      /* PGV, of the base that is at rest at first */
  double last_velocity_m_s; /* at the end; of a record with a true baseline about 0 */
  double duration_s;
} tp_shaking_peaks;
tp_shaking_peaks tp_base_acceleration_peaks(const tp_base_acceleration *axis);

/* The time after which nothing shakes any more. */
double tp_base_shaking_duration(const tp_base_shaking *shaking);

#endif
