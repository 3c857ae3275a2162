/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Reading of the scene that a study varies. */

#ifndef TP_STUDY_SCENE_H
#define TP_STUDY_SCENE_H

#include "study/values.h"

/* The keys scene, unit and set, and the hash of all files that the scene names. */
TP_MUST_USE tp_status tp_study_read_scene(const tp_study_reader *reader, const tp_node *root);

#endif
