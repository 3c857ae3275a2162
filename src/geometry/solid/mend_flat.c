/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Triangles whose corners lie on one line. One with p, m, q in this order has no area; over its
 * long side lies the neighbour q, p, d, which is parted at m into q, m, d and m, p, d: the same
 * surface, with m as a corner of it, and one flat triangle less. Passes go on while there is one to
 * part. */

#include "solid/mend_steps.h"
#include "solid/sides.h"
#include "solid/turns.h"

#include <math.h>
#include <stdlib.h>

/* Of three on one line the one in the middle, by its number; coordinates of doubles tell, for they
 * are in order along the line. */
static int middle_of(const tp_mending *m, long t) {
  const int *own = m->triangles + 3 * t;
  int axis = 0;
  double widest = -1;
  for (int k = 0; k < 3; k++) {
    double low = INFINITY, high = -INFINITY;
    for (int c = 0; c < 3; c++) {
      low = fmin(low, m->surface->near[3L * own[c] + k]);
      high = fmax(high, m->surface->near[3L * own[c] + k]);
    }
    if (high - low > widest) axis = k;
    widest = fmax(widest, high - low);
  }
  for (int c = 0; c < 3; c++) {
    const double at = m->surface->near[3L * own[c] + axis];
    const double one = m->surface->near[3L * own[(c + 1) % 3] + axis];
    const double other = m->surface->near[3L * own[(c + 2) % 3] + axis];
    if ((one - at) * (other - at) < 0) return c;
  }
  return 0;
}

/* Parts the neighbour of a flat triangle; false: there is none that was not touched before. */
static bool part(tp_mending *m, const tp_sides *sides, long t, bool *touched) {
  int *flat = m->triangles + 3 * t;
  const int c = middle_of(m, t), middle = flat[c];
  long count = 0;
  const tp_side *edge = tp_sides_edge(&count, sides, flat[(c + 1) % 3], flat[(c + 2) % 3]);
  if (count != 2 || touched[t]) return false;
  const long other = edge[0].triangle == t ? edge[1].triangle : edge[0].triangle;
  int *own = m->triangles + 3 * other;
  if (touched[other] || tp_surface_is_straight(m->surface, own[0], own[1], own[2])) return false;
  for (int k = 0; k < 3; k++) {
    const int from = own[k], to = own[(k + 1) % 3], apex = own[(k + 2) % 3];
    if (from != flat[(c + 2) % 3] || to != flat[(c + 1) % 3] || apex == middle) continue;
    const int first[3] = {from, middle, apex}, second[3] = {middle, to, apex};
    for (int i = 0; i < 3; i++) {
      flat[i] = first[i];
      own[i] = second[i];
    }
    m->faces[t] = m->faces[other];
    m->turned[t] = m->turned[other];
    touched[t] = touched[other] = true;
    return true;
  }
  return false;
}

bool tp_mending_part_flat(tp_mending *m) {
  bool goes_on = true, done = true;
  while (goes_on && done) {
    tp_sides sides;
    bool *touched = calloc((size_t)m->count + 1, sizeof *touched);
    done =
        tp_sides_init(&sides, m->triangles, m->count, m->surface->vertex_count) && touched != NULL;
    goes_on = false;
    for (long t = 0; done && t < m->count; t++) {
      const int *own = m->triangles + 3 * t;
      if (touched[t] || !tp_surface_is_straight(m->surface, own[0], own[1], own[2])) continue;
      const int face = m->faces[t];
      const long number = tp_mending_number(m, t);
      if (!part(m, &sides, t, touched)) continue;
      goes_on = true;
      if (face >= 0 && m->record->flat_triangles++ == 0) m->record->first_flat = number;
    }
    tp_sides_clear(&sides);
    free(touched);
  }
  return done;
}
