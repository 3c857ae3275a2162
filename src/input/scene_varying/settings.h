/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What was set in a scene, to be told with its solution. */

#ifndef TP_SCENE_VARYING_SETTINGS_H
#define TP_SCENE_VARYING_SETTINGS_H

#include "scene_varying/vary.h"

/* What was set and holds, in the order in which it was; nothing where nothing was. */
TP_MUST_USE tp_status tp_scene_settings(tp_settings *settings, const tp_scene *scene,
                                        tp_message *message);
/* The same of the scene that tp_scene_set would make, be there one or not. A value that is known
 * only as that is read is NaN. */
TP_MUST_USE tp_status tp_scene_settings_with(tp_settings *settings, const tp_scene *scene,
                                             const tp_scene_key *keys, const char *const *texts,
                                             size_t count, tp_message *message);
void tp_settings_clear(tp_settings *settings);

#endif
