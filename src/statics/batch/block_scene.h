/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* An outline of a batch as a scene of its own, by the calls of topple_scene.h. */

#ifndef TP_BATCH_BLOCK_SCENE_H
#define TP_BATCH_BLOCK_SCENE_H

#include "batch/outlines.h"

/* On a mated base, tilted one way. The unit of its lengths is metres, by which no angle changes. */
TP_MUST_USE tp_status tp_block_scene_new(tp_scene **scene, tp_vertices vertices,
                                         tp_direction towards, tp_message *message);

#endif
