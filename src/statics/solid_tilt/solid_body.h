/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A solid that passed the gate: what of it does not depend on how it lies or on what it is of. That
 * of a scene is made once for all scenes that differ in numbers. */

#ifndef TP_SOLID_TILT_SOLID_BODY_H
#define TP_SOLID_TILT_SOLID_BODY_H

#include "scene/scene.h"
#include "solid/hull_facets.h"
#include "solid/mend.h"
#include "solid/pieces.h"
#include "solid/thin.h"
#include "solid_tilt/ground_body.h"
#include "solid_tilt/solid_moments.h"

/* What is to be done to a mesh. */
typedef struct tp_solid_wish {
  bool repair; /* mend it: */
  tp_mend_wish mend;
  double thin; /* above 0: thin it by this, in lengths of the mesh */
} tp_solid_wish;

typedef struct tp_solid_body {
  tp_solid_wish wish;  /* what was done to the mesh */
  const tp_mesh *mesh; /* borrowed, or that which was mended */
  long object;
  bool is_mended;
  tp_mesh mended;              /* if is_mended */
  tp_solid_repair repair;      /* if is_mended: what was done, in lengths of the mesh */
  tp_mesh joined;              /* where there are parts, with theirs; */
  tp_surface whole;            /* then of all, */
  tp_surface surface;          /* of which this is the rock's; else the same; */
  bool is_thinned;             /* or what is left of it, which is its own: */
  tp_solid_thinning thinning;  /* if is_thinned */
  tp_solid_moments of_thinned; /* if is_thinned: of what is left, in doubles */
  tp_hull_facets facets;
  tp_solid_moments moments; /* of the rock as the mesh has it, in doubles; exact where these do not
                               tell that it has a volume */
  long part_count;
  tp_solid_piece *pieces;         /* the rock and its parts */
  tp_ground_body *ground;         /* of a scene with a mesh of the ground; else NULL */
  tp_solid_moments *part_moments; /* part_count of them, each of its surface alone, likewise */
} tp_solid_body;

/* Of one object, or of all where it is below zero, with what lies inside; mended and thinned first
 * where that is wished for; refused by triangle. To be cleared where it was made; it stays where it
 * was made. */
TP_MUST_USE tp_status tp_solid_body_init(tp_solid_body *body, const tp_mesh *mesh, long object,
                                         const tp_solid_wish *wish,
                                         const tp_solid_part_description *parts, long part_count,
                                         tp_message *message);
void tp_solid_body_clear(tp_solid_body *body);

/* Of a scene of a solid, kept by its file; of a wedge, which each scene makes for itself, NULL. */
TP_MUST_USE tp_status tp_solid_body_of_scene(const tp_solid_body **body, const tp_scene *scene,
                                             tp_message *message);

/* Is it mended and thinned as this scene says, where a sweep or a study varies how? */
bool tp_solid_body_is_of(const tp_solid_body *body, const tp_scene *scene);

/* One of this scene alone. To be cleared where it was made. */
TP_MUST_USE tp_status tp_solid_body_make(tp_solid_body *body, const tp_scene *scene,
                                         tp_message *message);

#endif
