/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The scene of a load case: that of the file with what the case says over it, read as if it stood
 * so in the file, each key where it stands. */

#ifndef TP_SCENE_VARYING_LOAD_CASE_H
#define TP_SCENE_VARYING_LOAD_CASE_H

#include "scene/scene.h"

/* Refuse a scene of cases of which none is chosen. */
TP_MUST_USE tp_status tp_check_load_case(const tp_scene *scene, tp_message *message);

#endif
