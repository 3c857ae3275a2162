/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Cells of a grid with crossings on their edges: two crossings make a piece of a curve, more are
 * resolved by quartering the cell; pieces with common ends are joined to curves. */

#include "chart/trace.h"

#include <math.h>
#include <stdlib.h>

enum { HALVINGS = 12, HALVINGS_OF_BENDS = 5 };

/* Corners counter-clockwise from the lower left; edge k joins corners k and k + 1. */
typedef struct cell {
  tp_map_sample corners[4];
  tp_crossing crossings[4];
} cell;

void tp_pieces_clear(tp_pieces *pieces) {
  free(pieces->pieces);
  free(pieces->patches);
}

/* Room for one more; NULL when memory is exhausted. */
static void *grow(bool *failed, void **array, size_t *count, size_t *capacity, size_t size) {
  if (*failed) return NULL;
  if (*count == *capacity) {
    const size_t wanted = *capacity > 0 ? 2 * *capacity : 128;
    void *grown = realloc(*array, wanted * size);
    *failed = grown == NULL;
    if (grown == NULL) return NULL;
    *array = grown;
    *capacity = wanted;
  }
  return (char *)*array + (*count)++ * size;
}

static void add_piece(tp_pieces *p, tp_map_point a, tp_map_point b, int one, int other) {
  tp_piece *piece =
      grow(&p->failed, (void **)&p->pieces, &p->count, &p->capacity, sizeof *p->pieces);
  if (piece == NULL) return;
  *piece = (tp_piece){{a, b}, {one < other ? one : other, one < other ? other : one}, false};
}

static void add_patch(tp_pieces *p, const tp_patch *patch) {
  tp_patch *last = p->patch_count > 0 ? p->patches + p->patch_count - 1 : NULL;
  const bool goes_on =
      last != NULL && last->region == patch->region && last->count == 4 && patch->count == 4 &&
      last->corners[1].x == patch->corners[0].x && last->corners[1].y == patch->corners[0].y &&
      last->corners[2].x == patch->corners[3].x && last->corners[2].y == patch->corners[3].y;
  if (goes_on) { /* a longer rectangle */
    last->corners[1] = patch->corners[1];
    last->corners[2] = patch->corners[2];
    return;
  }
  tp_patch *own = grow(&p->failed, (void **)&p->patches, &p->patch_count, &p->patch_capacity,
                       sizeof *p->patches);
  if (own != NULL) *own = *patch;
}

static tp_map_point point_of(const tp_map_sample *sample) {
  return (tp_map_point){.x = sample->values[0], .y = sample->values[1]};
}

/* The crossing of an edge, always from its lower or left end, so that both cells beside it find the
 * same point. */
static tp_crossing cross(const tp_map_field *field, const tp_map_sample *a,
                         const tp_map_sample *b) {
  if (field->region(field->context, a) == field->region(field->context, b)) {
    return (tp_crossing){0};
  }
  const bool forward = a->values[0] + a->values[1] < b->values[0] + b->values[1];
  return forward ? field->cross(field->context, *a, *b) : field->cross(field->context, *b, *a);
}

static void set_crossings(cell *c, const tp_map_field *field) {
  for (int k = 0; k < 4; k++) {
    c->crossings[k] = cross(field, c->corners + k, c->corners + (k + 1) % 4);
  }
}

static void trace_cell(tp_pieces *pieces, tp_map *map, const tp_map_field *field, const cell *c,
                       int depth);

static tp_map_sample middle(tp_map *map, const tp_map_sample *a, const tp_map_sample *b) {
  const double values[2] = {a->values[0] + (b->values[0] - a->values[0]) / 2,
                            a->values[1] + (b->values[1] - a->values[1]) / 2};
  return tp_map_take_sample(map, values);
}

static void halve(tp_pieces *pieces, tp_map *map, const tp_map_field *field, const cell *c,
                  int depth) {
  tp_map_sample sides[4];
  for (int k = 0; k < 4; k++) sides[k] = middle(map, c->corners + k, c->corners + (k + 1) % 4);
  const tp_map_sample centre = middle(map, c->corners, c->corners + 2);
  for (int k = 0; k < 4; k++) {
    cell part;
    part.corners[k] = c->corners[k];
    part.corners[(k + 1) % 4] = sides[k];
    part.corners[(k + 2) % 4] = centre;
    part.corners[(k + 3) % 4] = sides[(k + 3) % 4];
    set_crossings(&part, field);
    trace_cell(pieces, map, field, &part, depth + 1);
  }
}

static int region_of(const tp_map_field *field, const cell *c, int corner) {
  return field->region(field->context, c->corners + corner % 4);
}

/* The side of a cell that was cut across edges `from` and `to`: the corners behind `from` up to
 * `to`, and the cut. */
static void add_side(tp_pieces *pieces, const tp_map_field *field, const cell *c, int from,
                     int to) {
  tp_patch patch = {.region = region_of(field, c, from + 1)};
  patch.corners[patch.count++] = c->crossings[from % 4].point;
  for (int k = from + 1; k <= to; k++) {
    patch.corners[patch.count++] = point_of(c->corners + k % 4);
  }
  patch.corners[patch.count++] = c->crossings[to % 4].point;
  add_patch(pieces, &patch);
}

static void add_whole(tp_pieces *pieces, const tp_map_field *field, const cell *c) {
  tp_patch patch = {.region = region_of(field, c, 0), .count = 4};
  for (int k = 0; k < 4; k++) patch.corners[k] = point_of(c->corners + k);
  add_patch(pieces, &patch);
}

/* Is the border between two crossings about straight? */
static bool is_straight(tp_map *map, const tp_map_field *field, const cell *c, const int found[2]) {
  const tp_map_point a = c->crossings[found[0]].point, b = c->crossings[found[1]].point;
  const double wide = c->corners[2].values[0] - c->corners[0].values[0];
  const double high = c->corners[2].values[1] - c->corners[0].values[1];
  /* the normal, in shares of the cell, to the left from a to b: corner found[0] lies there */
  const double nx = -(b.y - a.y) / high, ny = (b.x - a.x) / wide, length = hypot(nx, ny);
  if (length == 0) return true;
  for (int side = 0; side < 2; side++) {
    const double off = (side == 0 ? 1 : -1) / (16 * length);
    const double values[2] = {(a.x + b.x) / 2 + off * nx * wide, (a.y + b.y) / 2 + off * ny * high};
    const bool inside = values[0] > c->corners[0].values[0] &&
                        values[0] < c->corners[2].values[0] &&
                        values[1] > c->corners[0].values[1] && values[1] < c->corners[2].values[1];
    if (!inside) continue;
    const tp_map_sample sample = tp_map_take_sample(map, values);
    const int expected = region_of(field, c, side == 0 ? found[0] : found[0] + 1);
    if (field->region(field->context, &sample) != expected) return false;
  }
  return true;
}

/* Regions meet in a cell that is small enough: at its centre. */
static void meet(tp_pieces *pieces, const tp_map_field *field, const cell *c) {
  const double *low = c->corners[0].values, *high = c->corners[2].values;
  const double half_x = (high[0] - low[0]) / 2, half_y = (high[1] - low[1]) / 2;
  const tp_map_point centre = {low[0] + half_x, low[1] + half_y, half_x, half_y};
  for (int k = 0; k < 4; k++) {
    if (!c->crossings[k].found) continue;
    add_piece(pieces, c->crossings[k].point, centre, region_of(field, c, k),
              region_of(field, c, k + 1));
  }
  add_whole(pieces, field, c);
}

static void trace_cell(tp_pieces *pieces, tp_map *map, const tp_map_field *field, const cell *c,
                       int depth) {
  int found[4], count = 0;
  for (int k = 0; k < 4; k++) {
    if (c->crossings[k].found) found[count++] = k;
  }
  if (map->status != TP_OK) return;
  if (count < 2) {
    add_whole(pieces, field, c);
  } else if (count == 2 && (depth >= HALVINGS_OF_BENDS || is_straight(map, field, c, found))) {
    add_piece(pieces, c->crossings[found[0]].point, c->crossings[found[1]].point,
              region_of(field, c, found[0]), region_of(field, c, found[0] + 1));
    add_side(pieces, field, c, found[0], found[1]);
    add_side(pieces, field, c, found[1], found[0] + 4);
  } else if (depth < HALVINGS) {
    halve(pieces, map, field, c, depth);
  } else {
    meet(pieces, field, c);
  }
}

/* The crossings of the row's lower edges become those of the next row's. */
void tp_trace(tp_pieces *pieces, tp_map *map, const tp_map_field *field, const tp_map_sample *grid,
              size_t columns, size_t rows) {
  tp_crossing *below = calloc(columns, sizeof *below), *above = calloc(columns, sizeof *above);
  pieces->failed = below == NULL || above == NULL;
  for (size_t row = 0; row < rows && !pieces->failed; row++) {
    const tp_map_sample *low = grid + row * columns, *high = low + columns;
    tp_crossing left = {0};
    for (size_t k = 0; k + 1 < columns && row == 0; k++)
      below[k] = cross(field, low + k, low + k + 1);
    if (row + 1 == rows) break;
    for (size_t k = 0; k < columns; k++) {
      const tp_crossing right = cross(field, low + k, high + k);
      if (k > 0) {
        above[k - 1] = cross(field, high + k - 1, high + k);
        const cell c = {{low[k - 1], low[k], high[k], high[k - 1]},
                        {below[k - 1], right, above[k - 1], left}};
        trace_cell(pieces, map, field, &c, 0);
      }
      left = right;
    }
    tp_crossing *held = below;
    below = above;
    above = held;
  }
  free(below);
  free(above);
}

/* Both cells beside an edge find the same doubles but for those of a finer cell, which may stop a
 * few doubles off. */
static bool same(tp_map_point a, tp_map_point b) {
  static const double few_doubles = 0x1p-40; /* 2^13 of them, far below a cell */
  return fabs(a.x - b.x) <= few_doubles * fabs(a.x) && fabs(a.y - b.y) <= few_doubles * fabs(a.y);
}

/* The one unused piece between the same regions that goes on from a point. */
static tp_piece *next_piece(tp_pieces *p, tp_map_point from, const int regions[2], int *end) {
  for (size_t k = 0; k < p->count; k++) {
    tp_piece *piece = p->pieces + k;
    if (piece->used || piece->regions[0] != regions[0] || piece->regions[1] != regions[1]) continue;
    for (*end = 0; *end < 2; (*end)++) {
      if (same(piece->ends[*end], from)) return piece;
    }
  }
  return NULL;
}

static size_t follow(tp_map_point *points, size_t count, const int regions[2], tp_pieces *p) {
  int end = 0;
  for (tp_piece *piece = next_piece(p, points[count - 1], regions, &end); piece != NULL;
       piece = next_piece(p, points[count - 1], regions, &end)) {
    piece->used = true;
    points[count++] = piece->ends[1 - end];
  }
  return count;
}

size_t tp_trace_next(tp_map_point *points, int regions[2], tp_pieces *p) {
  size_t k = 0;
  while (k < p->count && p->pieces[k].used) k++;
  if (k == p->count) return 0;
  tp_piece *first = p->pieces + k;
  first->used = true;
  regions[0] = first->regions[0];
  regions[1] = first->regions[1];
  points[0] = first->ends[1];
  points[1] = first->ends[0];
  size_t count = follow(points, 2, regions, p);
  for (size_t a = 0, b = count - 1; a < b; a++, b--) { /* turned about, on from the other end */
    const tp_map_point held = points[a];
    points[a] = points[b];
    points[b] = held;
  }
  return follow(points, count, regions, p);
}
