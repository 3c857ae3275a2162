/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The base of a scene as a polyline of exact points from left to right, the rock below it.
 *
 * A mated base is the counterpart of the block's underside, or of a part of it
 * (base/underside.h). Past the contact it goes on as far
 * as the scene says: along the teeth of a toothed block, level otherwise. */

#ifndef TP_BASE_PROFILE_H
#define TP_BASE_PROFILE_H

#include "block/section.h"
#include "topple.h"

typedef struct tp_base {
  tp_polyline ring; /* the profile, closed by two corners below everything else */
  long edge_count;  /* edges of the profile: the ring's first */
  bool mated;       /* with all of the underside, up to steep sides: nothing else can touch */
  /* of any mated base, also of one that the block was shifted along: edges mated_first … are the
   * outline's edges outline_first …, as many */
  long mated_first, outline_first, mated_count;
  tp_contact_end left, right; /* why it begins and ends there */
  const char *unit;           /* of the scene's lengths, borrowed */
  const char *none;           /* NULL, or for tp_underside_fail, once the block is checked */
} tp_base;

/* On failure `base` is cleared. */
TP_MUST_USE tp_status tp_base_init(tp_base *base, const tp_scene *scene, const tp_section *section,
                                   tp_message *message);
void tp_base_clear(tp_base *base);

/* Give back the points of the ring, which the lattice has as well. */
void tp_base_drop_points(tp_base *base);

#endif
