/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What spans the cone of loads of a mode: M r for its rays, -e for its edges, and what cohesion and
 * bonds add; each with where it comes from, which tells planes that are one by construction. */

#ifndef TP_MOTION_GENERATORS_H
#define TP_MOTION_GENERATORS_H

#include "motion/mode.h"
#include "motion/question.h"
#include "motion/strength.h"
#include "motion/tilts.h"

/* What a plane is spanned by: the same for planes of two modes that are one by construction, and
 * for planes that weight alone, whose moment is none, meets at one tilt. */
typedef enum tp_source_kind {
  TP_FROM_SITE,     /* all forces through one point */
  TP_FROM_PARALLEL, /* all forces of one direction: an axis and an edge of its cones */
  TP_FROM_AXIS,     /* weight along a facet */
  TP_FROM_NORMAL,   /* M times the twists on one normal line */
  TP_FROM_PAIR      /* two generators */
} tp_source_kind;

typedef struct tp_generator {
  tp_vector of; /* once it is evaluated */
  bool is_evaluated;
  bool is_ray;
  long id;          /* no two have the same */
  long axis;        /* of a force; of a ray that does not turn; else -1 */
  long site, point; /* of a force */
  bool against;
  long edge; /* of a force: its friction and the side of its cone; forces of one axis and one such
                are parallel */
} tp_generator;

typedef struct tp_generators {
  const tp_motion_question *q;
  const tp_normals *n;
  const tp_mode *mode;
  const tp_strength *strength; /* or NULL */
  long count;                  /* rays come first */
  long free_count;             /* of those behind them that may be anything within bounds */
  long room;
  tp_generator *items;
} tp_generators;

/* What they are, without their balls, in the place of what was there: zeros to begin with. False
 * when memory is exhausted; `strength` is that of the mode, or NULL. */
TP_MUST_USE bool tp_generators_set(tp_generators *generators, const tp_motion_question *question,
                                   const tp_normals *normals, const tp_twists *twists,
                                   const tp_mode *mode, const tp_strength *strength);
void tp_generators_clear(tp_generators *generators);

/* The balls of one, or all. */
const tp_vector *tp_generators_evaluate(tp_generators *generators, const tp_twists *twists, long k);
void tp_generators_evaluate_all(tp_generators *generators, const tp_twists *twists);

/* Of the plane of two of them. */
tp_source tp_generators_source(const tp_generators *generators, const tp_generator *a,
                               const tp_generator *b);

/* Of the plane of M times all twists on a normal line. */
tp_source tp_generators_normal_source(const tp_motion_question *question, const tp_normals *normals,
                                      const tp_strength *strength, long normal);

/* Does a force lie in the plane by where it comes from? */
bool tp_generator_is_in_plane(const tp_generator *generator, const tp_source *plane);

#endif
