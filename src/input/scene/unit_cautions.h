/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Cautions on numbers that were likely given in another unit than that of their key. */

#ifndef TP_SCENE_UNIT_CAUTIONS_H
#define TP_SCENE_UNIT_CAUTIONS_H

#include "common/notes.h"
#include "scene/scene.h"

/* Add a caution for each angle of the scene that is likely in radians, but those of joints between
 * two blocks, and that of a section; and for one friction angle. */
TP_MUST_USE tp_status tp_scene_angle_cautions(tp_notes *notes, const tp_scene *scene,
                                              tp_message *message);
TP_MUST_USE tp_status tp_scene_friction_caution(tp_notes *notes, const tp_quantity *angle,
                                                tp_message *message);

/* The same for an azimuth that the scene does not keep. */
TP_MUST_USE tp_status tp_scene_azimuth_caution(tp_notes *notes, const tp_quantity *azimuth,
                                               tp_message *message);

/* Add a caution for each angle, share and strength that is likely in another unit. */
TP_MUST_USE tp_status tp_scene_unit_cautions(tp_notes *notes, const tp_scene *scene,
                                             tp_message *message);

#endif
