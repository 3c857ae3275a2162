/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* An arrangement of segments from which edges are taken until every face is a simple polygon.
 *
 * A half-edge h has its twin h ^ 1 and the face on its left; `cycle` numbers the rings of
 * half-edges. A tidy map has no edge with one face on both sides (a joint that ends in rock), and
 * nothing that lies all within a face or hangs in it by one corner: a piece that one block encloses
 * on all sides fits its hollow, and cannot move against it, so it is part of it. */

#ifndef TP_JOINTING_PLANAR_MAP_H
#define TP_JOINTING_PLANAR_MAP_H

#include "common/message.h"
#include "geom/geom.h"

typedef struct tp_planar_map {
  tp_geom_arrangement a;
  size_t *previous;
  bool *gone; /* of an edge */
  size_t *cycle, cycle_count;
  size_t *stamp, *seat; /* of a vertex: the cycle that was there last, and its half-edge */
} tp_planar_map;

/* Segments as tp_geom_arrange takes them. On failure `map` is cleared. */
TP_MUST_USE tp_status tp_planar_map_init(tp_planar_map *map, const fmpq *ends, size_t count,
                                         tp_message *message);
void tp_planar_map_clear(tp_planar_map *map);

void tp_planar_map_remove(tp_planar_map *map, size_t edge);

/* Keep what hangs together with an edge that stays, and tidy it; and number its cycles. */
TP_MUST_USE tp_status tp_planar_map_tidy(tp_planar_map *map, size_t kept, tp_message *message);

/* The vertex that a half-edge leads to. */
static inline size_t tp_planar_map_end(const tp_planar_map *map, size_t half_edge) {
  return map->a.origin[half_edge ^ 1];
}

#endif
