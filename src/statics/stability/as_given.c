/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Checks the outline and its parts in the coordinates of the scene's author, on a separate lattice,
 * so that messages quote those coordinates. */

#include "stability/as_given.h"

#include "block/check.h"

#include <stdlib.h>

tp_status tp_as_given_check(tp_lattice *lattice, const tp_scene *scene, const tp_section *section,
                            const tp_polyline *base, tp_message *message) {
  const long rings = section->ring_count;
  tp_geom_triangulation triangulation = {0};
  const tp_polyline **chains = calloc((size_t)rings + 1, sizeof *chains);
  if (chains == NULL) return tp_fail_memory(message, "the lattice of points");
  for (long r = 0; r < rings; r++) chains[r] = section->rings + r;
  chains[rings] = base;
  tp_status status = tp_lattice_init(lattice, chains, base == NULL ? rings : rings + 1,
                                     scene->metres_per_unit, message);
  free(chains);
  if (status != TP_OK) return status;
  status = tp_check_section(&triangulation, section, lattice, message);
  tp_geom_triangulation_clear(&triangulation);
  if (status != TP_OK) tp_lattice_clear(lattice);
  return status;
}
