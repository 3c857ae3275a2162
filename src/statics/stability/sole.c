/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The underside as a run of edges of the outline (base/underside.h), membership of a facet, and its
 * length along the mean plane in lattice units. */

#include "stability/sole.h"

#include "base/underside.h"

tp_status tp_sole_find(tp_sole *sole, const tp_scene *scene, const tp_section *section,
                       tp_message *message) {
  tp_underside u;
  const long count = section->rings[0].count;
  const tp_status status = tp_underside_find(&u, scene, section, message);
  if (status != TP_OK || u.none != NULL) return status;
  *sole = (tp_sole){u.first, (u.last - u.first + count) % count};
  return TP_OK;
}

/* The direction of such a facet is that of its edge, from vertex to vertex. */
bool tp_sole_has(const tp_sole *sole, const tp_lattice *lattice, const tp_facet *facet) {
  const long count = lattice->start[1];
  return facet->q0 != facet->q1 && (facet->t0 - sole->first + count) % count < sole->count;
}

void tp_sole_length(fmpz_t length, const tp_sole *sole, const tp_lattice *lattice) {
  const long count = lattice->start[1];
  fmpz_t dx;
  fmpz_init(dx);
  fmpz_zero(length);
  for (long k = 0; k < sole->count; k++) {
    const long from = (sole->first + k) % count;
    fmpz_sub(dx, lattice->x + (from + 1) % count, lattice->x + from);
    fmpz_abs(dx, dx);
    fmpz_add(length, length, dx);
  }
  fmpz_clear(dx);
}
