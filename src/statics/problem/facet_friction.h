/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Which friction each facet of a contact has, where a scene gives some facets of its base one of
 * their own. Exact: numbers of facets, abscissas and angles are compared as the rationals that they
 * are, so that nothing needs a bound.
 *
 * A contact in a point at a vertex of the base belongs to both facets of the base there, and has
 * the smaller friction of the two; but in a notch of the base each of them bears by itself. Where a
 * facet of the contact ends at such a vertex, a slide over it may have that of the facet beside.
 * The upright faces at which a base ends, and what it has past the underside it is mated with, have
 * the scene's. */

#ifndef TP_PROBLEM_FACET_FRICTION_H
#define TP_PROBLEM_FACET_FRICTION_H

#include "base/contact.h"
#include "scene/scene.h"

/* Which edges of a base are counted as its facets: those of its profile, or of the underside that
 * it is, or was before a shift along it, `mated` with. `turned`: from the frame of the world. */
typedef struct tp_facets_counted {
  long first, count;
  bool mated, turned;
} tp_facets_counted;

/* At an end of a facet of the contact a facet of the base with another friction begins. What slips
 * towards that comes onto it, or passes over the vertex; where the block's edge goes on over the
 * vertex, it passes over it however it slips. */
typedef struct tp_facet_beside {
  long facet;
  bool at_end;   /* of its two ends the second, else the first */
  bool goes_on;  /* the block's edge does */
  long friction; /* of the facet beside, as of_facet has it */
} tp_facet_beside;

typedef struct tp_facet_friction {
  long count;          /* of angles besides the scene's, no two of them the same */
  const fmpq **angles; /* borrowed of the scene, rising */
  long *of_facet; /* by facet of the contact: 0, the scene's, or one more than an index of those */
  bool uneven;    /* facets of the contact that restrain the block differ in friction */
  long entry_count;
  long *firsts, *lasts; /* by entry of the scene: the numbers of its facets of the base, from 1 */
  long *touching;       /* and how many facets of the contact they are */
  bool *beside;         /* and whether one of them is among the besides */
  tp_facets_counted counted;
  long *entry_of; /* by facet that is counted: the entry of the scene that it is of, or -1 */
  long beside_count, beside_room;
  tp_facet_beside *besides;
} tp_facet_friction;

/* Facets that are not there, lie within an entry in part, or in two of them, are bad input; so are
 * abscissas of a scene that was turned. What ran is noted in `solution`. On failure `friction` is
 * cleared. */
TP_MUST_USE tp_status tp_facet_friction_init(tp_facet_friction *friction, const tp_scene *scene,
                                             const tp_base *base, const tp_lattice *lattice,
                                             const tp_contact *contact, tp_facets_counted counted,
                                             tp_solution *solution, tp_message *message);
void tp_facet_friction_clear(tp_facet_friction *friction);

/* The friction of an edge of the base's ring, as of_facet has it. */
long tp_facet_friction_index(const tp_facet_friction *friction, const tp_scene *scene, long edge);

/* The entry of an edge of the base's ring, -1: none, the scene's friction. */
long tp_facet_friction_entry(const tp_facet_friction *friction, long edge);

#endif
