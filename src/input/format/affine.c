/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Composition and application of affine maps in rationals; a similarity is recognised exactly, its
 * scale and the size of its numbers bounded. */

#include "format/affine.h"

#include <arf.h>
#include <math.h>

static void each(tp_affine_map *map, void (*call)(fmpq_t)) {
  call(map->a);
  call(map->b);
  call(map->c);
  call(map->d);
  call(map->e);
  call(map->f);
}

void tp_affine_map_init(tp_affine_map *map) {
  each(map, fmpq_init);
  fmpq_one(map->a);
  fmpq_one(map->d);
}

void tp_affine_map_clear(tp_affine_map *map) {
  each(map, fmpq_clear);
}

void tp_affine_map_set(tp_affine_map *map, const tp_affine_map *other) {
  fmpq_set(map->a, other->a);
  fmpq_set(map->b, other->b);
  fmpq_set(map->c, other->c);
  fmpq_set(map->d, other->d);
  fmpq_set(map->e, other->e);
  fmpq_set(map->f, other->f);
}

/* (x, y) by the linear part. */
static void map_vector(fmpq_t x, fmpq_t y, const tp_affine_map *map) {
  fmpq_t u, v;
  fmpq_init(u);
  fmpq_init(v);
  fmpq_mul(u, map->a, x);
  fmpq_addmul(u, map->c, y);
  fmpq_mul(v, map->b, x);
  fmpq_addmul(v, map->d, y);
  fmpq_swap(x, u);
  fmpq_swap(y, v);
  fmpq_clear(u);
  fmpq_clear(v);
}

void tp_affine_map_point(fmpq_t x, fmpq_t y, const tp_affine_map *map) {
  map_vector(x, y, map);
  fmpq_add(x, x, map->e);
  fmpq_add(y, y, map->f);
}

void tp_affine_map_compose(tp_affine_map *map, const tp_affine_map *inner) {
  tp_affine_map product;
  tp_affine_map_init(&product);
  tp_affine_map_set(&product, inner);
  map_vector(product.a, product.b, map);
  map_vector(product.c, product.d, map);
  tp_affine_map_point(product.e, product.f, map);
  tp_affine_map_set(map, &product);
  tp_affine_map_clear(&product);
}

void tp_affine_map_shift(tp_affine_map *map, const fmpq_t x, const fmpq_t y) {
  tp_affine_map inner;
  tp_affine_map_init(&inner);
  fmpq_set(inner.e, x);
  fmpq_set(inner.f, y);
  tp_affine_map_compose(map, &inner);
  tp_affine_map_clear(&inner);
}

void tp_affine_map_scale(tp_affine_map *map, const fmpq_t x, const fmpq_t y) {
  fmpq_mul(map->a, map->a, x);
  fmpq_mul(map->b, map->b, x);
  fmpq_mul(map->c, map->c, y);
  fmpq_mul(map->d, map->d, y);
}

void tp_affine_map_turn(tp_affine_map *map, const fmpq_t cosine, const fmpq_t sine) {
  tp_affine_map inner;
  tp_affine_map_init(&inner);
  fmpq_set(inner.a, cosine);
  fmpq_set(inner.b, sine);
  fmpq_neg(inner.c, sine);
  fmpq_set(inner.d, cosine);
  tp_affine_map_compose(map, &inner);
  tp_affine_map_clear(&inner);
}

/* Below this a double may have lost digits. */
static const double least_root = 1e-290;

/* |a| + |b| + |c| + |d|, for what no double holds. */
static void add_sizes(fmpq_t sum, const tp_affine_map *map) {
  const fmpq *const parts[] = {map->a, map->b, map->c, map->d};
  fmpq_t size, total;
  fmpq_init(size);
  fmpq_init(total);
  for (int k = 0; k < 4; k++) {
    fmpq_abs(size, parts[k]);
    fmpq_add(total, total, size);
  }
  fmpq_swap(sum, total);
  fmpq_clear(size);
  fmpq_clear(total);
}

void tp_affine_map_stretch(fmpq_t stretch, const tp_affine_map *map) {
  const double a = fmpq_get_d(map->a), b = fmpq_get_d(map->b), c = fmpq_get_d(map->c),
               d = fmpq_get_d(map->d);
  const double root = hypot(hypot(a, b), hypot(c, d)) * (1 + 1e-14);
  if (!isfinite(root) || root < least_root) {
    add_sizes(stretch, map);
    return;
  }
  arf_t bound;
  arf_init(bound);
  arf_set_d(bound, root);
  arf_get_fmpq(stretch, bound);
  arf_clear(bound);
}

long tp_affine_map_bits(const tp_affine_map *map) {
  const fmpq *const all[] = {map->a, map->b, map->c, map->d, map->e, map->f};
  long most = 0;
  for (size_t k = 0; k < sizeof all / sizeof all[0]; k++) {
    const long above = (long)fmpz_bits(fmpq_numref(all[k]));
    const long below = (long)fmpz_bits(fmpq_denref(all[k]));
    if (above > most) most = above;
    if (below > most) most = below;
  }
  return most;
}

static bool are_opposite(const fmpq_t one, const fmpq_t other) {
  fmpq_t sum;
  fmpq_init(sum);
  fmpq_add(sum, one, other);
  const bool opposite = fmpq_is_zero(sum);
  fmpq_clear(sum);
  return opposite;
}

static bool is_mirror(const tp_affine_map *map) {
  return fmpq_equal(map->b, map->c) && are_opposite(map->a, map->d);
}

bool tp_affine_map_keeps_circles(const tp_affine_map *map) {
  return is_mirror(map) || (fmpq_equal(map->a, map->d) && are_opposite(map->b, map->c));
}

void tp_affine_map_object(tp_drawing_object *object, const tp_affine_map *map) {
  tp_polyline *line = &object->line;
  for (long k = 0; k < line->count; k++) tp_affine_map_point(line->x + k, line->y + k, map);
  fmpq_t stretch;
  fmpq_init(stretch);
  tp_affine_map_stretch(stretch, map);
  fmpq_mul(object->uncertainty, object->uncertainty, stretch);
  fmpq_mul(object->deviation, object->deviation, stretch);
  fmpq_clear(stretch);
  if (!is_mirror(map)) return;
  for (long k = 0; k < object->bulge_room; k++) fmpq_neg(object->bulges + k, object->bulges + k);
}
