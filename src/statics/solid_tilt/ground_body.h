/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A rock and the mesh of the ground that it rests on, on one lattice: what of both does not depend
 * on bands. */

#ifndef TP_SOLID_TILT_GROUND_BODY_H
#define TP_SOLID_TILT_GROUND_BODY_H

#include "ground/relief.h"
#include "scene/scene.h"

typedef struct tp_ground_body {
  tp_mesh joined; /* of both */
  tp_surface whole;
  tp_relief rock, ground;
} tp_ground_body;

/* Of a rock that passed its gate. Refused by triangle: a ground with triangles without area, of
 * which neighbours run against each other, or that looks down as a whole. */
TP_MUST_USE tp_status tp_ground_body_make(tp_ground_body **body, const tp_mesh *rock, long object,
                                          const tp_solid_description *solid, tp_message *message);
void tp_ground_body_free(tp_ground_body *body); /* NULL is allowed */

#endif
