/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Affine maps of the plane with rational coefficients: x' = a x + c y + e, y' = b x + d y + f, as
 * SVG writes them. A map that keeps circles (a turn, one scale, a mirror) keeps arcs as arcs, of
 * the same bulge or, mirrored, of its opposite. */

#ifndef TP_FORMAT_AFFINE_H
#define TP_FORMAT_AFFINE_H

#include "format/drawing.h"

typedef struct tp_affine_map {
  fmpq_t a, b, c, d, e, f;
} tp_affine_map;

/* The identity. */
void tp_affine_map_init(tp_affine_map *map);
void tp_affine_map_clear(tp_affine_map *map);
void tp_affine_map_set(tp_affine_map *map, const tp_affine_map *other);

/* `map` becomes what first does `inner`, then what `map` did. */
void tp_affine_map_compose(tp_affine_map *map, const tp_affine_map *inner);
/* What `map` does, before a shift, a scale or a turn by a cosine and a sine. */
void tp_affine_map_shift(tp_affine_map *map, const fmpq_t x, const fmpq_t y);
void tp_affine_map_scale(tp_affine_map *map, const fmpq_t x, const fmpq_t y);
void tp_affine_map_turn(tp_affine_map *map, const fmpq_t cosine, const fmpq_t sine);

void tp_affine_map_point(fmpq_t x, fmpq_t y, const tp_affine_map *map);

/* By how much a length is stretched at most: the root of the sum of squares, rounded up, between
 * the largest stretch and the root of two of it; of maps that no double holds up to twice it. */
void tp_affine_map_stretch(fmpq_t stretch, const tp_affine_map *map);

/* Of the longest numerator or denominator of its coefficients. */
long tp_affine_map_bits(const tp_affine_map *map);

bool tp_affine_map_keeps_circles(const tp_affine_map *map);

/* Map an object whose arcs the map keeps, or that has none. */
void tp_affine_map_object(tp_drawing_object *object, const tp_affine_map *map);

#endif
