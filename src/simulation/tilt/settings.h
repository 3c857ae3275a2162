/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What a test is run by: what the scene gives, in SI units, and defaults for the rest. No default
 * stands for a stiffness of springs, which the scene must give; the path, whose angles do not
 * depend on it but by the ratio of both, takes that of the paper's section 4.3, and says so. */

#ifndef TP_TILT_SETTINGS_H
#define TP_TILT_SETTINGS_H

#include "rigid_body/body.h"
#include "scene/scene.h"
#include "topple_tilt_test.h"

/* Of the scene that asks, and the one prepared from it, which has the tilt in the frame of the
 * base. */
tp_tilt_settings tp_tilt_settings_of(const tp_scene *asks, const tp_scene *prepared);

/* Bad input where the scene calls for no simulation, or lacks what each of them needs. */
TP_MUST_USE tp_status tp_tilt_check_scene(const tp_scene *scene, tp_message *message);

/* A time that scales with the block: of a fall from its extent, sqrt(extent / g). */
double tp_tilt_time_scale(const tp_rigid_body *body);

/* The longest time of a run at a steady tilt, or after the shaking: as given, else TP_TILT_SCALES
 * time scales: at 0.01 degrees beyond the limit a block has turned by a tenth after some 10. */
enum { TP_TILT_SCALES = 100 };
double tp_tilt_duration(const tp_tilt_settings *settings, const tp_rigid_body *body);

#endif
