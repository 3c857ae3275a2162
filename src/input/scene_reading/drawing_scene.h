/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A drawing or a mesh in place of a scene: the scene that names it, and has what is set. */

#ifndef TP_SCENE_READING_DRAWING_SCENE_H
#define TP_SCENE_READING_DRAWING_SCENE_H

#include "scene/scene.h"

/* Does the name of a file say that it is one? */
bool tp_scene_is_drawing(const char *path);

/* `unit` is empty where the drawing says it; a mesh never does. */
TP_MUST_USE tp_status tp_scene_read_drawing(tp_scene **scene, const char *path, const char *unit,
                                            const char *const *settings, size_t count,
                                            tp_message *message);

#endif
