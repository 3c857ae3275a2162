/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The facets of a mated base: the block's own edges between the ends of the contact, and the point
 * contacts where the base turns away from it there. Exact: copies of lattice points. */

#include "base/facets.h"

tp_status tp_facets_of_mated(tp_facets *facets, const tp_section *section, const tp_base *base,
                             const tp_lattice *lattice, tp_message *message) {
  const long outline = lattice->start[0], vertices = section->rings[0].count;
  const long ring = lattice->start[section->ring_count];
  const long first = base->mated_first, last = first + base->mated_count; /* of the profile */
  bool done = true;
  if (first > 0 && tp_lattice_cross(lattice, ring + first - 1, ring + first, ring + first,
                                    ring + first + 1) > 0) {
    const long begin = outline + base->outline_first;
    done = tp_facets_append(facets,
                            tp_facet_of(begin, begin, ring + first - 1, ring + first, first - 1));
  }
  for (long k = 0; k < base->mated_count && done; k++) {
    const long from = outline + (base->outline_first + k) % vertices;
    const long to = outline + (base->outline_first + k + 1) % vertices;
    done = tp_facets_append(facets, tp_facet_of(from, to, from, to, first + k));
  }
  if (last < base->edge_count && done &&
      tp_lattice_cross(lattice, ring + last - 1, ring + last, ring + last, ring + last + 1) > 0) {
    const long end = outline + (base->outline_first + base->mated_count) % vertices;
    done = tp_facets_append(facets, tp_facet_of(end, end, ring + last, ring + last + 1, last));
  }
  return done ? TP_OK : tp_fail_memory(message, "the contact");
}
