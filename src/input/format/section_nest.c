/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Which chains of a section lie within others: by the box of each, and then by how often the
 * outline is passed on the way to the right of a point, in exact numbers. A point on the outline
 * tells nothing, and the next one is asked; a chain whose points all lie on it is taken to be
 * within. Costs the points of one for each of the other, where their boxes say no more. */

#include "format/section_take.h"

#include <stdlib.h>

typedef enum side { OUTSIDE, INSIDE, ON } side;

/* Twice the area of the triangle that an edge makes with a point: above 0 left of it. */
static int turn(const tp_polyline *ring, long from, long to, const fmpq_t x, const fmpq_t y) {
  fmpq_t a, b, c;
  fmpq_init(a);
  fmpq_init(b);
  fmpq_init(c);
  fmpq_sub(a, ring->x + to, ring->x + from);
  fmpq_sub(b, y, ring->y + from);
  fmpq_mul(c, a, b);
  fmpq_sub(a, ring->y + to, ring->y + from);
  fmpq_sub(b, x, ring->x + from);
  fmpq_submul(c, a, b);
  const int sign = fmpq_sgn(c);
  fmpq_clear(a);
  fmpq_clear(b);
  fmpq_clear(c);
  return sign;
}

/* Between the ends of the edge in x and in y? */
static bool is_in_box(const tp_polyline *ring, long from, long to, const fmpq_t x, const fmpq_t y) {
  return fmpq_cmp(ring->x + from, x) * fmpq_cmp(ring->x + to, x) <= 0 &&
         fmpq_cmp(ring->y + from, y) * fmpq_cmp(ring->y + to, y) <= 0;
}

static side side_of(const tp_polyline *ring, const fmpq_t x, const fmpq_t y) {
  bool inside = false;
  for (long k = 0, last = ring->count - 1; k < ring->count; last = k++) {
    const bool above = fmpq_cmp(ring->y + k, y) > 0, was_above = fmpq_cmp(ring->y + last, y) > 0;
    if (!is_in_box(ring, last, k, x, y) && above == was_above) continue;
    const int left = turn(ring, last, k, x, y);
    if (left == 0 && is_in_box(ring, last, k, x, y)) return ON;
    if (above != was_above && (left > 0) == above) inside = !inside;
  }
  return inside ? INSIDE : OUTSIDE;
}

static bool lies_within(const tp_polyline *inner, const tp_polyline *outer) {
  for (long k = 0; k < inner->count; k++) {
    const side own = side_of(outer, inner->x + k, inner->y + k);
    if (own != ON) return own == INSIDE;
  }
  return true;
}

/* The least and the greatest of x and of y. */
typedef struct box {
  const fmpq *least[2], *most[2];
} box;

static box box_of(const tp_polyline *line) {
  box own = {{line->x, line->y}, {line->x, line->y}};
  for (long k = 1; k < line->count; k++) {
    const fmpq *point[2] = {line->x + k, line->y + k};
    for (int c = 0; c < 2; c++) {
      if (fmpq_cmp(point[c], own.least[c]) < 0) own.least[c] = point[c];
      if (fmpq_cmp(point[c], own.most[c]) > 0) own.most[c] = point[c];
    }
  }
  return own;
}

static bool is_box_within(const box *inner, const box *outer) {
  bool within = true;
  for (int c = 0; c < 2 && within; c++) {
    within = fmpq_cmp(inner->least[c], outer->least[c]) >= 0 &&
             fmpq_cmp(inner->most[c], outer->most[c]) <= 0;
  }
  return within;
}

bool tp_section_nest(long *within, const tp_mesh_section *section, long outer) {
  const tp_section_chain *chains = section->chains;
  box *boxes = calloc((size_t)section->count + 1, sizeof *boxes);
  if (boxes == NULL) return false;
  for (long k = 0; k < section->count; k++) {
    within[k] = -1;
    if (chains[k].closed) boxes[k] = box_of(&chains[k].points);
  }
  for (long k = 0; k < section->count; k++) {
    if (k == outer || !chains[k].closed || !is_box_within(boxes + k, boxes + outer) ||
        !lies_within(&chains[k].points, &chains[outer].points)) {
      continue;
    }
    within[k] = 0;
    for (long j = 0; j < section->count; j++) {
      if (j == k || j == outer || !chains[j].closed || !is_box_within(boxes + k, boxes + j))
        continue;
      within[k] += lies_within(&chains[k].points, &chains[j].points);
    }
  }
  free(boxes);
  return true;
}
