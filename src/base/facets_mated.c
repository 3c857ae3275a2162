/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "base/facets.h"

#include <stdlib.h>

bool tp_facets_append(tp_facets *facets, tp_facet facet) {
  if (facets->count == facets->capacity) {
    const long capacity = facets->capacity == 0 ? 16 : 2 * facets->capacity;
    tp_facet *items = realloc(facets->items, (size_t)capacity * sizeof *items);
    if (items == NULL) return false;
    facets->items = items;
    facets->capacity = capacity;
  }
  facets->items[facets->count++] = facet;
  return true;
}

static int bilinear_sign(const fmpz *a, const fmpz *b, const fmpz *c, const fmpz *d, bool add) {
  fmpz_t result;
  fmpz_init(result);
  fmpz_mul(result, a, b);
  if (add) {
    fmpz_addmul(result, c, d);
  } else {
    fmpz_submul(result, c, d);
  }
  const int sign = fmpz_sgn(result);
  fmpz_clear(result);
  return sign;
}

static int sign_of_product(const tp_lattice *l, long a, long b, long c, long d, bool dot) {
  fmpz r[4]; /* dx and dy of b - a and of d - c */
  for (int k = 0; k < 4; k++) fmpz_init(r + k);
  fmpz_sub(r, l->x + b, l->x + a);
  fmpz_sub(r + 1, l->y + b, l->y + a);
  fmpz_sub(r + 2, l->x + d, l->x + c);
  fmpz_sub(r + 3, l->y + d, l->y + c);
  const int sign = dot ? bilinear_sign(r, r + 2, r + 1, r + 3, true)
                       : bilinear_sign(r, r + 3, r + 1, r + 2, false);
  for (int k = 0; k < 4; k++) fmpz_clear(r + k);
  return sign;
}

int tp_facets_cross(const tp_lattice *lattice, long a, long b, long c, long d) {
  return sign_of_product(lattice, a, b, c, d, false);
}

int tp_facets_dot(const tp_lattice *lattice, long a, long b, long c, long d) {
  return sign_of_product(lattice, a, b, c, d, true);
}

bool tp_facets_same_point(const tp_lattice *lattice, long a, long b) {
  return a == b ||
         (fmpz_equal(lattice->x + a, lattice->x + b) && fmpz_equal(lattice->y + a, lattice->y + b));
}

tp_status tp_facets_of_mated(tp_facets *facets, const tp_section *section, const tp_base *base,
                             const tp_lattice *lattice, tp_message *message) {
  const long outline = lattice->start[0], vertices = section->rings[0].count;
  const long ring = lattice->start[section->ring_count];
  const long first = base->mated_first, last = first + base->mated_count; /* of the profile */
  bool done = true;
  if (first > 0 && tp_facets_cross(lattice, ring + first - 1, ring + first, ring + first,
                                   ring + first + 1) > 0) {
    done = tp_facets_append(facets,
                            (tp_facet){outline + base->outline_first, outline + base->outline_first,
                                       ring + first - 1, ring + first, first - 1});
  }
  for (long k = 0; k < base->mated_count && done; k++) {
    const long from = outline + (base->outline_first + k) % vertices;
    const long to = outline + (base->outline_first + k + 1) % vertices;
    done = tp_facets_append(facets, (tp_facet){from, to, from, to, first + k});
  }
  if (last < base->edge_count && done &&
      tp_facets_cross(lattice, ring + last - 1, ring + last, ring + last, ring + last + 1) > 0) {
    const long end = outline + (base->outline_first + base->mated_count) % vertices;
    done = tp_facets_append(facets, (tp_facet){end, end, ring + last, ring + last + 1, last});
  }
  return done ? TP_OK : tp_fail_memory(message, "the contact");
}
