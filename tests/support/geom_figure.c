/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "geom_figure.h"

#include "random_numbers.h"

#include <math.h>
#include <string.h>

static fmpz large_x[MOST], large_y[MOST]; /* initialised, to 0 */
static double rounded_x[MOST], rounded_y[MOST];

/* Larger numbers are those of the figure sheared, so far that no double holds what was y: each
 * orientation is as it was, and only whole numbers tell. */
tp_geom_rings view(const figure *f, bool small) {
  for (size_t k = 0; k < f->count; k++) {
    fmpz_set_si(large_x + k, (long)f->u[k] - 1000003);
    fmpz_mul_2exp(large_y + k, large_x + k, 70);
    fmpz_add_si(large_y + k, large_y + k, (long)f->v[k] + 2000003);
    fmpz_mul_2exp(large_x + k, large_x + k, 70);
    fmpz_add_ui(large_x + k, large_x + k, 12345678987654321);
    rounded_x[k] = fmpz_get_d(large_x + k);
    rounded_y[k] = fmpz_get_d(large_y + k);
  }
  if (small) return (tp_geom_rings){f->ring_count, f->start, f->u, f->v, NULL, NULL, true};
  return (tp_geom_rings){f->ring_count, f->start, rounded_x, rounded_y, large_x, large_y, false};
}

void add_ring(figure *f, const long (*points)[2], size_t count) {
  for (size_t k = 0; k < count; k++, f->count++) {
    f->u[f->count] = (double)points[k][0];
    f->v[f->count] = (double)points[k][1];
  }
  f->start[++f->ring_count] = f->count;
}

void add_random_ring(figure *f, random_numbers *state) {
  long p[9][2];
  const size_t count = 3 + draw(state) % 7;
  for (size_t k = 0; k < count; k++) {
    do {
      p[k][0] = (long)(draw(state) % 7);
      p[k][1] = (long)(draw(state) % 7);
    } while ((k > 0 && memcmp(p[k], p[k - 1], sizeof *p) == 0) ||
             (k + 1 == count && memcmp(p[k], p[0], sizeof *p) == 0));
  }
  add_ring(f, p, count);
}

void add_star(figure *f, long u, double radius, size_t count, random_numbers *state) {
  long p[MOST][2];
  for (size_t k = 0; k < count; k++) {
    const double turn = ((double)k + 0.4 * draw_part(state)) / (double)count;
    const double r = radius * (0.3 + 0.7 * draw_part(state));
    p[k][0] = u + lround(r * cos(2 * acos(-1) * turn));
    p[k][1] = lround(r * sin(2 * acos(-1) * turn));
  }
  add_ring(f, p, count);
}

size_t ring_of(const figure *f, size_t vertex) {
  return (size_t)(vertex >= f->start[1]) + (f->ring_count > 2 && vertex >= f->start[2]);
}

size_t next_of(const figure *f, size_t vertex) {
  const size_t ring = ring_of(f, vertex);
  return vertex + 1 == f->start[ring + 1] ? f->start[ring] : vertex + 1;
}

vector between(const figure *f, size_t from, size_t to) {
  return (vector){(wide)f->u[to] - (wide)f->u[from], (wide)f->v[to] - (wide)f->v[from]};
}

wide cross(vector a, vector b) {
  return a.u * b.v - a.v * b.u;
}
