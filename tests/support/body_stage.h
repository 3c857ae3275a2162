/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The rigid body of a scene, for tests of what simulates its motion. */

#ifndef TP_TEST_BODY_STAGE_H
#define TP_TEST_BODY_STAGE_H

#include "rigid_body/body.h"

typedef struct body_stage {
  tp_scene *scene;
  tp_solution *solution; /* towards both sides, or as the scene says */
  tp_rigid_body body;
} body_stage;

/* Fails the test where the scene or its body is refused. */
void body_stage_init(body_stage *stage, const char *text, tp_direction towards);
void body_stage_clear(body_stage *stage);

/* The status of the body of a scene that is fine as such; what it says in `message`. */
tp_status body_stage_refused(const char *text, tp_message *message);

#endif
