/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Motions of a solid within one section: the strong side of contacts that face different ways.
 *
 * Where all normals and the load are across one axis, and every contact point has partners of the
 * same normal and friction on the same line along the axis, on both sides of the centroid or in its
 * section, and the axis is a principal one of the inertia, the solid can move as a body in a plane:
 * forces shared among partners have no moment out of the section.
 *
 * A motion from rest (docs/mechanics.md, "Onset of motion") is an acceleration a = (v, omega) with
 *     M a = w + sum of contact forces,
 * where no contact closes, an open one bears nothing, one that slips bears n - tan(phi) t against
 * the slip, and one that sticks any force of its cone. The accelerations that no contact stops are
 * a cone K of three dimensions. Its rays, and those on its faces along which a contact sticks,
 * divide K into modes: rays, sectors between two rays of one face, and the inside, where the solid
 * leaves all contacts. In a mode M a - sum of forces is a cone of few generators, M r of its rays
 * and -f of the edges of its forces. The mode can begin under a load in this cone that needs some M
 * r. By Caratheodory's theorem three generators are enough, so that the multiples x of loads R + x
 * D under which a mode can begin are intervals between roots of linear functions, and divisors of
 * strength are intervals between roots of quadratic ones.
 *
 * Points, normals and loads are rational numbers and are taken exactly; tan(phi), the radius of
 * gyration and the length of the axis are rounded to doubles, as a relative change of 1e-15.
 * What can begin is proven for the solid. That nothing can is proven for motions within the
 * section. */

#ifndef TP_SOLID_CONTACTS_SOLID_SECTION_H
#define TP_SOLID_CONTACTS_SOLID_SECTION_H

#include "solid_contacts/hold_load.h"
#include "solid_contacts/solid_section_parts.h"

/* Integrals of x x, y y, z z, y z, z x, x y about the centroid over the mass, in lengths of the
 * cones. */
typedef struct tp_solid_section_inertia {
  double second[6];
} tp_solid_section_inertia;

/* Have cones and load such a section? To be cleared also where they have none; false when memory is
 * exhausted. */
TP_MUST_USE bool tp_solid_section_init(bool *has_section, tp_solid_section *section,
                                       const tp_friction_cones *cones,
                                       const tp_solid_section_inertia *inertia, const fmpq load[3]);
void tp_solid_section_clear(tp_solid_section *section);

/* Is a load within the section? */
bool tp_solid_section_has_load(const tp_solid_section *section, const tp_hold_load *load);

#endif
