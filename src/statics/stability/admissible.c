/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Every contact facet is tested against every pivot by the sign of an integer (docs/mechanics.md
 * section 3); the facet that obstructed last is tried first. */

#include "stability/admissible.h"

static bool opens(const tp_lattice *lattice, const tp_facet *facet, tp_outline_point p,
                  tp_direction direction) {
  return direction == TP_TOWARDS_LEFT ? tp_facet_side(lattice, facet, p, tp_facet_begin(facet)) >= 0
                                      : tp_facet_side(lattice, facet, tp_facet_end(facet), p) >= 0;
}

void tp_admissible_find(bool *admissible, const tp_contact *contact, const tp_lattice *lattice,
                        tp_direction direction) {
  const bool left = direction == TP_TOWARDS_LEFT;
  const long count = contact->facet_count;
  long obstacle = 0; /* the facet that obstructed last most often obstructs again */
  for (long k = 0; k < contact->point_count; k++) {
    const tp_contact_point *p = contact->points + k;
    admissible[k] = false;
    if ((left ? p->left : p->right) >= 0) continue; /* presses its own facet down */
    const tp_outline_point at = tp_contact_on_outline(p);
    bool clear = opens(lattice, contact->facets + obstacle, at, direction);
    for (long step = 0; step < count && clear; step++) {
      const long f = left ? step : count - 1 - step;
      clear = opens(lattice, contact->facets + f, at, direction);
      if (!clear) obstacle = f;
    }
    admissible[k] = clear;
  }
}
