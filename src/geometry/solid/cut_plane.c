/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The height of a plane in steps of the surface times |up|, which is a root in general. */

#include "solid/cut_plane.h"

enum { ROOT_BITS = 200 };

static void dot(fmpz_t product, const fmpz *a, const fmpz *b) {
  fmpz_mul(product, a, b);
  fmpz_addmul(product, a + 1, b + 1);
  fmpz_addmul(product, a + 2, b + 2);
}

/* |up| as top / 2^shift; returns the shift, 0 where it is a whole number. */
static ulong set_length(fmpz_t top, const fmpz *up) {
  fmpz_t square;
  fmpz_init(square);
  dot(square, up, up);
  const ulong shift = fmpz_is_square(square) ? 0 : ROOT_BITS;
  fmpz_mul_2exp(square, square, 2 * shift);
  fmpz_sqrt(top, square);
  fmpz_clear(square);
  return shift;
}

static void set_lowest(fmpz_t lowest, const tp_surface *surface, const fmpz *up) {
  fmpz_t own;
  fmpz_init(own);
  for (long v = 0; v < surface->vertex_count; v++) {
    dot(own, up, surface->whole + 3 * v);
    if (v == 0 || fmpz_cmp(own, lowest) < 0) fmpz_set(lowest, own);
  }
  fmpz_clear(own);
}

void tp_cut_plane_init(tp_cut_plane *plane, const tp_surface *surface, const fmpz up[3],
                       const fmpq_t height) {
  fmpz_t lowest;
  fmpz_init(lowest);
  fmpz_init(plane->top);
  fmpz_init(plane->bottom);
  fmpz_init(plane->weight);
  plane->exponent = 0;
  for (int k = 0; k < 3; k++) {
    fmpz_init(plane->origin + k);
    fmpz_init_set(plane->up + k, up + k);
  }
  const ulong shift = set_length(plane->top, up); /* lowest + height D |up| */
  fmpz_mul(plane->top, plane->top, surface->divisor);
  fmpz_mul(plane->top, plane->top, fmpq_numref(height));
  fmpz_mul_2exp(plane->bottom, fmpq_denref(height), shift);
  set_lowest(lowest, surface, up);
  fmpz_addmul(plane->top, lowest, plane->bottom);
  fmpz_clear(lowest);
}

void tp_cut_plane_clear(tp_cut_plane *plane) {
  for (int k = 0; k < 3; k++) {
    fmpz_clear(plane->up + k);
    fmpz_clear(plane->origin + k);
  }
  fmpz_clear(plane->top);
  fmpz_clear(plane->bottom);
  fmpz_clear(plane->weight);
}

void tp_cut_height(fmpz_t height, const tp_cut_plane *plane, const fmpz *point) {
  dot(height, plane->up, point);
}
