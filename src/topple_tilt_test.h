/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A simulated tilt test of a scene, or the shaking of its base: what a scene in memory is given for
 * it, the call that runs it, its result and reports (docs/tilt.md). Included by topple.h. */

#ifndef TOPPLE_TILT_TEST_H
#define TOPPLE_TILT_TEST_H

#include "topple_scene.h"
#include "topple_tilt.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- the test of a scene in memory -------------------------------------------------------------
 */

/* The test: by which engine, by which protocol; where `set_down`, the block is set down at each
 * angle, else it is placed level and tilted. The path engine takes a ramp, or steps at which the
 * block is set down; a release is at the scene's tilt angle. */
TP_MUST_USE tp_status tp_scene_set_tilt_test(tp_scene *scene, tp_tilt_engine engine,
                                             tp_tilt_protocol protocol, bool set_down,
                                             tp_message *message);

/* Its numbers, each as the key of its name (docs/tilt.md): the speed of the table, above 0, of a
 * ramp in time; up to which tilt, in [0, 90]; the wanted width of the bracket, above 0; the longest
 * time of one run, above 0. */
TP_MUST_USE tp_status tp_scene_set_tilt_test_speed_deg_min(tp_scene *scene, tp_exact speed_deg_min,
                                                           tp_message *message);
TP_MUST_USE tp_status tp_scene_set_tilt_test_until_deg(tp_scene *scene, tp_exact until_deg,
                                                       tp_message *message);
TP_MUST_USE tp_status tp_scene_set_tilt_test_tolerance_deg(tp_scene *scene, tp_exact tolerance_deg,
                                                           tp_message *message);
TP_MUST_USE tp_status tp_scene_set_tilt_test_duration_s(tp_scene *scene, tp_exact duration_s,
                                                        tp_message *message);

/* Of contacts that are springs: stiffness of the contact per unit of its area, both above 0; local
 * damping, in [0, 1]; the radius by which corners are rounded, in scene lengths, and the time step,
 * above 0. */
TP_MUST_USE tp_status tp_scene_set_tilt_test_stiffness_gpa_m(tp_scene *scene, tp_exact normal_gpa_m,
                                                             tp_exact shear_gpa_m,
                                                             tp_message *message);
TP_MUST_USE tp_status tp_scene_set_tilt_test_damping(tp_scene *scene, tp_exact damping,
                                                     tp_message *message);
TP_MUST_USE tp_status tp_scene_set_tilt_test_rounding(tp_scene *scene, tp_exact rounding,
                                                      tp_message *message);
TP_MUST_USE tp_status tp_scene_set_tilt_test_time_step_s(tp_scene *scene, tp_exact time_step_s,
                                                         tp_message *message);

/* Of rigid contacts: the restitution of impacts, in [0, 1]. */
TP_MUST_USE tp_status tp_scene_set_tilt_test_restitution(tp_scene *scene, tp_exact restitution,
                                                         tp_message *message);

/* Along what the base shakes: the horizontal, positive up-dip of a table tilted to the left; or
 * the vertical, positive upwards. */
typedef enum tp_shaking_axis { TP_SHAKES_HORIZONTALLY, TP_SHAKES_VERTICALLY } tp_shaking_axis;

/* Half a period of a sine, or a whole one. */
typedef enum tp_pulse_shape { TP_PULSE_HALF_SINE, TP_PULSE_FULL_SINE } tp_pulse_shape;

/* The base shakes along that axis: by a pulse of `peak_g` of standard gravity, with `frequency_hz`
 * above 0, which begins at once; or by a record of points (seconds, acceleration as a share of
 * gravity) at even steps, times `scale`. The last one set for an axis is taken. */
TP_MUST_USE tp_status tp_scene_set_shaking_pulse(tp_scene *scene, tp_shaking_axis axis,
                                                 tp_pulse_shape shape, tp_exact peak_g,
                                                 tp_exact frequency_hz, tp_message *message);
TP_MUST_USE tp_status tp_scene_set_shaking_record(tp_scene *scene, tp_shaking_axis axis,
                                                  tp_coordinates record, tp_exact scale,
                                                  tp_message *message);

#ifdef __cplusplus
}
#endif

#endif
