/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Loads whose points miss the block's face by the last digits of a drawing or a survey: a point
 * within 1e-6 of the block's size beside the outline is put on it, with a note. Points of anchors
 * may lie inside; farther out a load is refused later (load/check.h). */

#ifndef TP_PROBLEM_ON_FACE_H
#define TP_PROBLEM_ON_FACE_H

#include "scene/scene.h"

typedef struct tp_on_face {
  tp_scene scene; /* with loads of its own */
} tp_on_face;

/* `*own` stays as it is where all points lie as they must, or too far off. */
TP_MUST_USE tp_status tp_on_face_init(tp_on_face **own, const tp_scene *scene, tp_notes *notes,
                                      tp_message *message);
void tp_on_face_free(tp_on_face *own);

#endif
