/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What a drawing gives a scene: outline and arcs, holes, parts, the profile of the base, in scene
 * lengths; and which of its objects became what. */

#ifndef TP_SCENE_DRAWN_H
#define TP_SCENE_DRAWN_H

#include "format/roles.h"
#include "scene/quantity.h"

/* An object of the drawing, for the report. */
typedef struct tp_drawn_object {
  tp_drawing_role role;
  const char *kind;
  TP_OUTSIDE char *layer;
  TP_OUTSIDE char *name;
  tp_mark mark;
  long points, arcs;
  bool closed;
} tp_drawn_object;

/* An edge of the outline that is an arc, from a vertex on; the bulge is negative inwards. */
typedef struct tp_drawn_arc {
  fmpq_t x, y, bulge;
  tp_mark mark;
} tp_drawn_arc;

typedef struct tp_drawn {
  const char *path;          /* borrowed */
  const char *length_unit;   /* of the drawing's lengths */
  bool fixed;                /* no number that varies bears upon it */
  tp_polyline outline, base; /* no point: the drawing has no base */
  long arc_count, hole_count, part_count, object_count;
  tp_drawn_arc *arcs;
  tp_polyline *holes, *parts;
  long *part_words; /* of each part, the number of its layer among those that the scene names */
  TP_OUTSIDE char **part_layers; /* and that layer */
  tp_drawn_object *objects;
  tp_notes notes;
} tp_drawn;

/* Chains by their roles, scaled; arcs of all but the outline become chords. `drawn` is empty, but
 * for its path and unit, and cleared on failure. */
TP_MUST_USE tp_status tp_drawn_make(tp_drawn *drawn, tp_drawing_choice *choice,
                                    const tp_drawing *drawing, const tp_drawing_words *words,
                                    const tp_drawing_options *options, const fmpq_t scale,
                                    tp_message *message);
void tp_drawn_clear(tp_drawn *drawn);

#endif
