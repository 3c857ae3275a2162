/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What a simulated tilt test of a scene is, and what may stand in it together. */

#ifndef TP_SCENE_CHECK_TILT_TEST_H
#define TP_SCENE_CHECK_TILT_TEST_H

#include "scene/scene.h"

/* Does the scene call for a simulation: by tilt_test, or by shaking? */
bool tp_scene_is_simulated(const tp_scene *scene);
bool tp_scene_is_shaken(const tp_scene *scene);

/* As given; else the path engine and a ramp, or, where the base shakes, rigid contacts and a
 * release. */
tp_tilt_engine tp_scene_tilt_engine(const tp_scene *scene);
tp_tilt_protocol tp_scene_tilt_protocol(const tp_scene *scene);
/* As given; else level for a ramp, and set down at the angle for steps and a release. */
bool tp_scene_tilt_set_down(const tp_scene *scene);

/* Settings of another engine, springs without their stiffness, a protocol that the engine has not:
 * told at their place. */
TP_MUST_USE tp_status tp_check_simulation(const tp_scene *scene, tp_message *message);

#endif
