/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Finding the facets of a contact; used by contact.c alone. */

#ifndef TP_FACETS_H
#define TP_FACETS_H

#include "base/contact.h"

/* A growing list of facets. */
typedef struct tp_facets {
  long count, capacity;
  tp_facet *items;
} tp_facets;

TP_MUST_USE bool tp_facets_append(tp_facets *facets, tp_facet facet);

/* Facets of a mated base: the shared edges one by one, and the notches at its two ends. */
TP_MUST_USE tp_status tp_facets_of_mated(tp_facets *facets, const tp_section *section,
                                         const tp_base *base, const tp_lattice *lattice,
                                         tp_message *message);

/* Facets of any base, by searching for edges that meet; sorted along the base. */
TP_MUST_USE tp_status tp_facets_of_profile(tp_facets *facets, const tp_section *section,
                                           const tp_base *base, const tp_lattice *lattice,
                                           tp_message *message);

/* Sign of (b - a) x (d - c) and of (b - a) . (d - c) for points of the lattice. */
int tp_facets_cross(const tp_lattice *lattice, long a, long b, long c, long d);
int tp_facets_dot(const tp_lattice *lattice, long a, long b, long c, long d);

bool tp_facets_same_point(const tp_lattice *lattice, long a, long b);

#endif
