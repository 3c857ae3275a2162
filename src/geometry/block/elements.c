/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Weight and first moments of each slab, triangle or piece as integers, sorted by x and by y with
 * cumulative sums for the elements form (docs/mechanics.md section 3; (A1.3), (A1.15)). */

#include "block/elements.h"

#include <stdlib.h>
#include <string.h>

bool tp_elements_are_given(const tp_section *section) {
  return section->element_corners.count > 0 && section->ring_count == 1;
}

static void clear_array(fmpz *array, long count) {
  if (array == NULL) return;
  for (long k = 0; k < count; k++) fmpz_clear(array + k);
  free(array);
}

static void clear_order(tp_element_order *order, long count) {
  clear_array(order->position6, count);
  clear_array(order->weight2, count + 1);
  clear_array(order->moment12, count + 1);
}

static void element_clear(tp_exact_element *e) {
  fmpz_clear(&e->weight2);
  fmpz_clear(&e->x6);
  fmpz_clear(&e->y6);
  memset(e, 0, sizeof *e);
}

void tp_elements_clear(tp_elements *elements) {
  for (long k = 0; elements->items != NULL && k < elements->count; k++) {
    element_clear(elements->items + k);
  }
  free(elements->items);
  clear_order(&elements->along_x, elements->count);
  clear_order(&elements->along_y, elements->count);
  memset(elements, 0, sizeof *elements);
}

/* Twice the area of the triangle of three lattice points, times a density weight. */
static void set_triangle(tp_exact_element *e, const tp_lattice *l, const long corner[3],
                         const fmpz *density) {
  fmpz_t dx, dy;
  fmpz_init(dx);
  fmpz_init(dy);
  const fmpz *x = l->x, *y = l->y;
  fmpz_sub(dx, x + corner[1], x + corner[0]);
  fmpz_sub(dy, y + corner[2], y + corner[0]);
  fmpz_mul(&e->weight2, dx, dy);
  fmpz_sub(dx, x + corner[2], x + corner[0]);
  fmpz_sub(dy, y + corner[1], y + corner[0]);
  fmpz_submul(&e->weight2, dx, dy);
  fmpz_abs(&e->weight2, &e->weight2);
  fmpz_mul(&e->weight2, &e->weight2, density);
  fmpz_add(&e->x6, x + corner[0], x + corner[1]);
  fmpz_add(&e->x6, &e->x6, x + corner[2]);
  fmpz_mul_ui(&e->x6, &e->x6, 2);
  fmpz_add(&e->y6, y + corner[0], y + corner[1]);
  fmpz_add(&e->y6, &e->y6, y + corner[2]);
  fmpz_mul_ui(&e->y6, &e->y6, 2);
  e->kind = TP_ELEMENT_TRIANGLE;
  for (int k = 0; k < 3; k++) e->corner[k] = corner[k];
  fmpz_clear(dx);
  fmpz_clear(dy);
}

/* The rectangle between two opposite corners. */
static void set_slab(tp_exact_element *e, const tp_lattice *l, long low, long high,
                     const fmpz *density) {
  fmpz_t dx, dy;
  fmpz_init(dx);
  fmpz_init(dy);
  fmpz_sub(dx, l->x + high, l->x + low);
  fmpz_sub(dy, l->y + high, l->y + low);
  fmpz_mul(&e->weight2, dx, dy);
  fmpz_mul_ui(&e->weight2, &e->weight2, 2);
  fmpz_mul(&e->weight2, &e->weight2, density);
  fmpz_add(&e->x6, l->x + high, l->x + low);
  fmpz_mul_ui(&e->x6, &e->x6, 3);
  fmpz_add(&e->y6, l->y + high, l->y + low);
  fmpz_mul_ui(&e->y6, &e->y6, 3);
  e->kind = TP_ELEMENT_SLAB;
  e->corner[0] = low;
  e->corner[1] = high;
  fmpz_clear(dx);
  fmpz_clear(dy);
}

/* N slabs of a x b, then under each a triangle that reaches down to the valley beside it; where
 * the depth is 0 they have no weight and are left out. */
static void set_given(tp_elements *elements, const tp_section *section, const tp_lattice *lattice,
                      long corner_chain) {
  const long corner = lattice->start[corner_chain], outline = lattice->start[0];
  const fmpz *density = section->density_weights;
  const tp_polyline *corners = &section->element_corners;
  const long teeth = corners->count / 2 - 1;
  for (long k = 0; k < teeth; k++) {
    set_slab(elements->items + k, lattice, corner + 2 * k, corner + 2 * k + 3, density);
  }
  elements->count = teeth;
  for (long k = 0; k < teeth; k++) {
    const bool valley_left = fmpz_cmp(lattice->y + outline + k, lattice->y + outline + k + 1) < 0;
    const long ends[3] = {outline + k, outline + k + 1,
                          corner + 2 * (valley_left ? k : k + 1)}; /* above the valley */
    tp_exact_element *e = elements->items + elements->count;
    set_triangle(e, lattice, ends, density);
    if (fmpz_is_zero(&e->weight2)) {
      element_clear(e);
    } else {
      elements->count++;
    }
  }
}

static void set_triangles(tp_elements *elements, const tp_section *section,
                          const tp_lattice *lattice, const tp_geom_triangulation *triangulation) {
  for (size_t k = 0; k < triangulation->count; k++) {
    const tp_geom_triangle *t = triangulation->triangles + k;
    const long corner[3] = {(long)t->corner[0], (long)t->corner[1], (long)t->corner[2]};
    tp_exact_element *e = elements->items + k;
    e->part =
        t->ring_in_layer[2] == 0 ? 0 : (size_t)(t->ring_in_layer[2] - 1 - section->hole_count);
    set_triangle(e, lattice, corner, section->density_weights + e->part);
  }
  elements->count = (long)triangulation->count;
}

static int by_x(const void *a, const void *b) {
  return fmpz_cmp(&(*(tp_exact_element *const *)a)->x6, &(*(tp_exact_element *const *)b)->x6);
}

static int by_y(const void *a, const void *b) {
  return fmpz_cmp(&(*(tp_exact_element *const *)a)->y6, &(*(tp_exact_element *const *)b)->y6);
}

static bool init_order(tp_element_order *order, const tp_elements *elements, bool along_x) {
  const long count = elements->count;
  const size_t room = (size_t)count + 1;
  tp_exact_element **sorted = calloc(room, sizeof *sorted);
  order->position6 = calloc(room, sizeof *order->position6);
  order->weight2 = calloc(room, sizeof *order->weight2);
  order->moment12 = calloc(room, sizeof *order->moment12);
  const bool done = sorted != NULL && order->position6 != NULL && order->weight2 != NULL &&
                    order->moment12 != NULL;
  if (done) {
    for (long k = 0; k < count; k++) sorted[k] = elements->items + k;
    qsort(sorted, (size_t)count, sizeof *sorted, along_x ? by_x : by_y);
    for (long k = 0; k < count; k++) {
      const fmpz *position = along_x ? &sorted[k]->x6 : &sorted[k]->y6;
      fmpz_set(order->position6 + k, position);
      fmpz_add(order->weight2 + k + 1, order->weight2 + k, &sorted[k]->weight2);
      fmpz_set(order->moment12 + k + 1, order->moment12 + k);
      fmpz_addmul(order->moment12 + k + 1, &sorted[k]->weight2, position);
    }
  }
  free(sorted);
  return done;
}

tp_status tp_elements_init(tp_elements *elements, const tp_section *section,
                           const tp_lattice *lattice, long corner_chain,
                           const tp_geom_triangulation *triangulation, tp_message *message) {
  memset(elements, 0, sizeof *elements);
  const bool given = tp_elements_are_given(section);
  const size_t most = given ? (size_t)section->element_corners.count + 1 : triangulation->count + 1;
  elements->items = calloc(most, sizeof *elements->items);
  if (elements->items == NULL) return tp_fail_memory(message, "the elements");
  if (given) {
    set_given(elements, section, lattice, corner_chain);
  } else {
    set_triangles(elements, section, lattice, triangulation);
  }
  if (init_order(&elements->along_x, elements, true) &&
      init_order(&elements->along_y, elements, false)) {
    return TP_OK;
  }
  tp_elements_clear(elements);
  return tp_fail_memory(message, "the elements");
}

void tp_elements_moments(fmpz_t beyond, fmpz_t before, const tp_elements *elements,
                         const tp_element_order *order, const fmpz_t position) {
  fmpz_t position6;
  fmpz_init(position6);
  fmpz_mul_ui(position6, position, 6);
  long low = 0, high = elements->count; /* the first element beyond */
  while (low < high) {
    const long middle = low + (high - low) / 2;
    if (fmpz_cmp(order->position6 + middle, position6) <= 0) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  const fmpz *all_weight = order->weight2 + elements->count;
  const fmpz *all_moment = order->moment12 + elements->count;
  fmpz_mul(before, position6, order->weight2 + low);
  fmpz_sub(before, before, order->moment12 + low);
  fmpz_sub(beyond, all_moment, order->moment12 + low);
  fmpz_submul(beyond, position6, all_weight);
  fmpz_addmul(beyond, position6, order->weight2 + low);
  fmpz_clear(position6);
}
