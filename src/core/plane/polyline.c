/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Arrays of rationals with their places in a file; chains shared between scenes by an atomic count
 * of users. */

#include "plane/polyline.h"

#include "number/word.h"

#include <stdlib.h>
#include <string.h>

/* Is it the last chain that has the points, or the only one? */
static bool is_last(tp_polyline *line) {
  return line->users == NULL || atomic_fetch_sub(line->users, 1) == 1;
}

void tp_polyline_clear(tp_polyline *line) {
  if (!is_last(line)) {
    memset(line, 0, sizeof *line);
    return;
  }
  for (long k = 0; k < line->count; k++) {
    fmpq_clear(line->x + k);
    fmpq_clear(line->y + k);
  }
  free(line->x);
  free(line->y);
  free(line->marks);
  free(line->users);
  memset(line, 0, sizeof *line);
}

void tp_polylines_clear(tp_polylines *lines) {
  for (long k = 0; k < lines->count; k++) tp_polyline_clear(lines->lines + k);
  free(lines->lines);
  *lines = (tp_polylines){.count = 0};
}

static bool grow(void **array, long capacity, size_t size) {
  void *grown = realloc(*array, (size_t)capacity * size);
  if (grown == NULL) return false;
  *array = grown;
  return true;
}

bool tp_polyline_reserve(tp_polyline *line, long count) {
  if (count <= line->capacity) return true;
  void *xs = line->x, *ys = line->y, *marks = line->marks;
  const bool grown = grow(&xs, count, sizeof *line->x) && grow(&ys, count, sizeof *line->y) &&
                     grow(&marks, count, sizeof *line->marks);
  line->x = xs;
  line->y = ys;
  line->marks = marks;
  if (grown) line->capacity = count;
  return grown;
}

bool tp_polyline_append(tp_polyline *line, const fmpq_t x, const fmpq_t y, tp_mark mark) {
  const bool full = line->count == line->capacity;
  if (full && !tp_polyline_reserve(line, line->capacity == 0 ? 16 : 2 * line->capacity)) {
    return false;
  }
  const long k = line->count++;
  fmpq_init(line->x + k);
  fmpq_init(line->y + k);
  fmpq_set(line->x + k, x);
  fmpq_set(line->y + k, y);
  line->marks[k] = mark;
  return true;
}

bool tp_polyline_copy(tp_polyline *copy, const tp_polyline *line) {
  *copy = (tp_polyline){.file = line->file, .mark = line->mark, .reversed = line->reversed};
  if (!tp_polyline_reserve(copy, line->count)) {
    tp_polyline_clear(copy);
    return false;
  }
  for (long k = 0; k < line->count; k++) {
    if (!tp_polyline_append(copy, line->x + k, line->y + k, line->marks[k])) {
      tp_polyline_clear(copy);
      return false;
    }
  }
  return true;
}

bool tp_polyline_make_shared(tp_polyline *line) {
  atomic_long *users = malloc(sizeof *users);
  if (users == NULL) return false;
  atomic_init(users, 1);
  line->users = users;
  return true;
}

bool tp_polyline_separate(tp_polyline *line) {
  if (line->users == NULL || atomic_load(line->users) == 1) return true;
  tp_polyline own;
  if (!tp_polyline_copy(&own, line)) return false;
  if (!tp_polyline_make_shared(&own)) {
    tp_polyline_clear(&own);
    return false;
  }
  tp_polyline_clear(line);
  *line = own;
  return true;
}

tp_polyline tp_polyline_share(const tp_polyline *line) {
  if (line->users != NULL) atomic_fetch_add(line->users, 1);
  return *line;
}

static void spread(fmpq_t size, const fmpq *values, long count) {
  long least = 0, most = 0;
  fmpq_zero(size);
  for (long k = 0; k < count; k++) {
    if (tp_word_order(values + k, values + least) < 0) least = k;
    if (tp_word_order(values + k, values + most) > 0) most = k;
  }
  if (count > 0) fmpq_sub(size, values + most, values + least);
}

void tp_polyline_size(fmpq_t width, fmpq_t height, const tp_polyline *line) {
  spread(width, line->x, line->count);
  spread(height, line->y, line->count);
}

void tp_polyline_drop_closing_point(tp_polyline *line) {
  const long last = line->count - 1;
  if (last < 3 || !fmpq_equal(line->x, line->x + last) || !fmpq_equal(line->y, line->y + last)) {
    return;
  }
  fmpq_clear(line->x + last);
  fmpq_clear(line->y + last);
  line->count--;
}

void tp_polyline_reverse(tp_polyline *line) {
  for (long i = 0, k = line->count - 1; i < k; i++, k--) {
    fmpq_swap(line->x + i, line->x + k);
    fmpq_swap(line->y + i, line->y + k);
    const tp_mark mark = line->marks[i];
    line->marks[i] = line->marks[k];
    line->marks[k] = mark;
  }
  line->reversed = !line->reversed;
}

long tp_polyline_number(const tp_polyline *line, long index) {
  return line->reversed ? line->count - index : index + 1;
}

tp_place tp_polyline_place(const tp_polyline *line, long index) {
  tp_mark mark = line->mark;
  if (index >= 0 && index < line->count && line->marks[index].line > 0) mark = line->marks[index];
  return (tp_place){line->file, mark.line, mark.column};
}

long tp_polyline_leftmost(const tp_polyline *line) {
  long best = 0;
  for (long k = 1; k < line->count; k++) {
    const int side = tp_word_order(line->x + k, line->x + best);
    if (side < 0 || (side == 0 && tp_word_order(line->y + k, line->y + best) < 0)) best = k;
  }
  return best;
}

int tp_points_turn(const fmpq *px, const fmpq *py, const fmpq *qx, const fmpq *qy, const fmpq *rx,
                   const fmpq *ry) {
  fmpq_t a, b, c, d;
  fmpq_init(a);
  fmpq_init(b);
  fmpq_init(c);
  fmpq_init(d);
  fmpq_sub(a, qx, px);
  fmpq_sub(b, ry, py);
  fmpq_sub(c, qy, py);
  fmpq_sub(d, rx, px);
  fmpq_mul(a, a, b);
  fmpq_submul(a, c, d);
  const int sign = fmpq_sgn(a);
  fmpq_clear(a);
  fmpq_clear(b);
  fmpq_clear(c);
  fmpq_clear(d);
  return sign;
}

int tp_polyline_turn(const tp_polyline *line, long from, long to, long vertex) {
  return tp_points_turn(line->x + from, line->y + from, line->x + to, line->y + to,
                        line->x + vertex, line->y + vertex);
}

int tp_polyline_orientation(const tp_polyline *line) {
  if (line->count < 3) return 0;
  const long at = tp_polyline_leftmost(line);
  return tp_polyline_turn(line, at == 0 ? line->count - 1 : at - 1, at,
                          at + 1 == line->count ? 0 : at + 1);
}

void tp_polyline_orient(tp_polyline *line) {
  if (tp_polyline_orientation(line) < 0) tp_polyline_reverse(line);
}

bool tp_polyline_orient_by_area(tp_polyline *line) {
  fmpq_t area, term;
  fmpq_init(area);
  fmpq_init(term);
  for (long k = 0, last = line->count - 1; k < line->count; last = k++) {
    fmpq_sub(term, line->x + last, line->x + k);
    fmpq_addmul(area, term, line->y + k);
    fmpq_sub(term, line->y + last, line->y + k);
    fmpq_submul(area, term, line->x + k);
  }
  const int sign = fmpq_sgn(area);
  if (sign < 0) tp_polyline_reverse(line);
  fmpq_clear(area);
  fmpq_clear(term);
  return sign != 0;
}
