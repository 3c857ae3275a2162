/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The base of a scene as a polyline of exact points from left to right, the rock below it.
 *
 * A mated base is the counterpart of the block's underside: the lower chain of the outline from its
 * leftmost to its rightmost vertex, or between two named vertices. Past the block it goes on as far
 * as the scene says: along the teeth of a toothed block, level otherwise. */

#ifndef TP_PROFILE_H
#define TP_PROFILE_H

#include "block/section.h"

typedef struct tp_base {
  tp_polyline ring; /* the profile, closed by two corners below everything else */
  long edge_count;  /* edges of the profile: the ring's first */
  bool mated;       /* edges mated_first … are the outline's edges outline_first … */
  long mated_first, outline_first, mated_count;
} tp_base;

/* On failure `base` is cleared. */
TP_MUST_USE tp_status tp_base_init(tp_base *base, const tp_scene *scene, const tp_section *section,
                                   tp_message *message);
void tp_base_clear(tp_base *base);

#endif
