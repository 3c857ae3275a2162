/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The underside of a block on a profile, of which the contact ratio is a share: of a block that was
 * shifted along its mated base what was mated, of others the edges that by default would be the
 * contact of a mated base (base/underside.h), in the pose that they have. */

#ifndef TP_PROBLEM_SOLE_H
#define TP_PROBLEM_SOLE_H

#include "base/facets.h"

/* Edges of the outline, counter-clockwise from a vertex on. */
typedef struct tp_sole {
  long first, count; /* count 0: there is none */
} tp_sole;

/* Of a block as it lies; none where the default finds none. */
TP_MUST_USE tp_status tp_sole_find(tp_sole *sole, const tp_scene *scene, const tp_section *section,
                                   tp_message *message);

/* Does a facet of positive length lie on one of the edges? */
bool tp_sole_has(const tp_sole *sole, const tp_lattice *lattice, const tp_facet *facet);

/* Their length along the mean plane, the sum of |dx|, in lattice units. */
void tp_sole_length(fmpz_t length, const tp_sole *sole, const tp_lattice *lattice);

#endif
