/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Where water stands on one side of a block: at a level, or below a surface over level and upright
 * coordinates. */

#ifndef TP_LOAD_WATER_STAND_H
#define TP_LOAD_WATER_STAND_H

#include "load/lie.h"
#include "load/wet_lines.h"

typedef struct tp_water_stand {
  const tp_polyline *surface; /* borrowed, across and up; NULL: a level */
  fmpq_t level;
} tp_water_stand;

/* Its height at a place, and the depth of a point below it. */
void tp_water_stand_at(fmpq_t up, const tp_water_stand *stand, const fmpq_t across);
void tp_water_stand_depth(fmpq_t depth, const tp_water_stand *stand, const fmpq_t across,
                          const fmpq_t up);

/* The surface of the scene in level and upright coordinates: refused where it goes back, or ends
 * between `least` and `greatest`. To be cleared on success. */
TP_MUST_USE tp_status tp_water_surface_lay(tp_polyline *laid, const tp_polyline *surface,
                                           const tp_lie *drawn, const fmpq_t least,
                                           const fmpq_t greatest, tp_message *message);

/* Press on the edge from one point to the next of a chain, which `world` has in level and upright
 * coordinates: with the pressure of `unit_kpa` for a unit of depth, down to all depths; or, where
 * `thickness` is not NULL, with that pressure from the water's level down to it. False when memory
 * is exhausted. */
TP_MUST_USE bool tp_water_press(tp_wet_lines *lines, const tp_water_stand *stand,
                                const tp_polyline *chain, const tp_polyline *world, long k,
                                const fmpq_t unit_kpa, const fmpq *thickness);

/* A line with the pressures of its ends, cut off where they fall below zero. */
TP_MUST_USE bool tp_wet_lines_add(tp_wet_lines *lines, const fmpq *const from[2],
                                  const fmpq *const to[2], const fmpq_t first, const fmpq_t last);

#endif
