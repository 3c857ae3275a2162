/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A scene made ready for statics: the exact block on its exact base. Nothing here is rounded. */

#ifndef TP_PROBLEM_PROBLEM_H
#define TP_PROBLEM_PROBLEM_H

#include "base/contact.h"
#include "block/corners.h"
#include "block/elements.h"
#include "load/wetted.h"
#include "problem/base_joint.h"
#include "problem/chorded.h"
#include "problem/facet_friction.h"
#include "problem/on_face.h"
#include "problem/placement.h"
#include "problem/sole.h"

/* Above this many vertices the elements form of the factor of safety, which needs a triangulation
 * at some hundred times the cost of everything else, is drawn up only when asked for. */
enum { TP_ELEMENTS_UNASKED = 10000 };

typedef struct tp_problem {
  const tp_scene *scene; /* in the frame of its base */
  tp_placement placement;
  tp_chorded *chorded; /* chords stand for its arcs; else NULL */
  tp_on_face *on_face; /* NULL: no load lies beside its face */
  tp_section section;
  tp_base base;       /* mated: without the points of its ring, which are the block's */
  tp_lattice lattice; /* chains: the section's rings, the base's ring, the element corners */
  tp_contact contact;
  tp_facet_friction friction; /* of facets that have their own; else empty */
  tp_sole sole;               /* on a profile: its underside */
  tp_base_joint joint;        /* where there is water: what it fills */
  tp_wetted wetted[2];        /* sited water: what it presses on as the block goes left, right */
  bool *admissible[2];        /* by direction of tilt, for each contact point */
  tp_corners corners;         /* rounded ones */
  bool loaded;                /* the scene calls for loads besides the weight */
  bool has_elements;
  tp_elements elements;
  size_t triangle_count;
} tp_problem;

/* Prepare the scene, noting in `solution` what ran. On failure `problem` is cleared. */
TP_MUST_USE tp_status tp_problem_init(tp_problem *problem, const tp_scene *scene,
                                      const tp_solve_options *options, tp_solution *solution,
                                      tp_message *message);
void tp_problem_clear(tp_problem *problem);

/* Do rounded corners or loads rule out exact arithmetic? */
bool tp_problem_is_enclosed(const tp_problem *problem);

/* Does its water press as problem.wetted has it? */
bool tp_problem_has_wetted(const tp_problem *problem);

/* Vertices of all rings of the section. */
long tp_problem_vertex_count(const tp_problem *problem);

/* Thickness of the section in metres. */
void tp_problem_thickness(fmpq_t metres, const tp_problem *problem);

/* Newton for each unit of weighted twice-area on the lattice: half of it, times the square of the
 * step, the thickness and the unit weight. */
void tp_problem_weight_factor(fmpq_t newton, const tp_problem *problem);

#endif
