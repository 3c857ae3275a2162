/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Problem: an outline that was rounded to a few decimals may meet itself: a vertex that lay beside
 * an edge comes to lie on it, or beyond it by less than the last digit.
 *
 * Method: where edges meet, of their four ends that one is taken which is nearest to the other edge
 * and whose foot lies within that. It is put on the side of that edge on which its neighbours are,
 * at most an eighth of the last digit beside it, on a grid of thousandths of it, until no edges
 * meet or some end is a whole digit away from where it was given. All in rationals: that no edges
 * meet in the end is decided exactly, as is the distance of each vertex from where it was.
 *
 * Validity: a ring of which width and height have at least two digits above the last; for one as
 * small as its own last digit that digit is no slip of rounding. Cost: a search for meeting edges a
 * round, at most 20 rounds. */

#include "block/repair.h"

#include "block/repair_move.h"
#include "block/ring_meetings.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
  MOST_ROUNDS = 20,     /* slips of rounding end in one or two; a ring that takes more is no slip */
  MOST_MEETINGS = 1000, /* of one round: beyond it the outline is wrong, not rounded */
  MOST_BITS = 4096,     /* of a last digit, some 1200 decimals; finer ones are left alone */
  LEAST_SIZE = 100      /* width and height in last digits: the two digits of the head */
};

typedef struct meetings {
  size_t count;
  bool too_many;
  tp_geom_meeting items[MOST_MEETINGS];
} meetings;

void tp_repair_init(tp_repair *repair) {
  *repair = (tp_repair){.done = false};
  fmpq_init(repair->digit);
}

void tp_repair_clear(tp_repair *repair) {
  fmpq_clear(repair->digit);
}

/* Take all factors p out of n; how many there were. */
static long take_factors(fmpz_t n, unsigned long p) {
  fmpz_t factor;
  fmpz_init_set_ui(factor, p);
  const long count = fmpz_is_zero(n) ? 0 : fmpz_remove(n, n, factor);
  fmpz_clear(factor);
  return count;
}

/* The largest power of ten of which all coordinates are multiples; false where there is none. */
static bool last_digit(fmpq_t digit, const tp_polyline *ring) {
  fmpq_t measure, ten;
  fmpq_init(measure);
  fmpq_init(ten);
  for (long k = 0; k < ring->count && fmpz_bits(fmpq_denref(measure)) <= MOST_BITS; k++) {
    fmpq_gcd(measure, measure, ring->x + k);
    fmpq_gcd(measure, measure, ring->y + k);
  }
  /* measure = n / d: 10^-e is the largest that divides it, e = max(twos, fives of d) less those of
   * n */
  fmpz *n = fmpq_numref(measure), *d = fmpq_denref(measure);
  const long twos = take_factors(d, 2) - take_factors(n, 2);
  const long fives = take_factors(d, 5) - take_factors(n, 5);
  const bool found = fmpz_bits(d) <= MOST_BITS && fmpz_is_one(d) && !fmpz_is_zero(n);
  fmpq_set_si(ten, 10, 1);
  if (found) fmpq_pow_si(digit, ten, -(twos > fives ? twos : fives));
  fmpq_clear(measure);
  fmpq_clear(ten);
  return found;
}

static bool keep_meeting(void *context, tp_geom_meeting meeting) {
  meetings *all = context;
  all->too_many = all->count == MOST_MEETINGS;
  if (!all->too_many) all->items[all->count++] = meeting;
  return !all->too_many;
}

static int compare_meetings(const void *one, const void *other) {
  const tp_geom_meeting *m = one, *n = other;
  if (m->a != n->a) return m->a < n->a ? -1 : 1;
  return m->b < n->b ? -1 : m->b > n->b;
}

/* All pairs of edges of the ring that meet, in order. */
static tp_status find_meetings(meetings *all, const tp_polyline *ring, tp_message *message) {
  tp_lattice lattice;
  fmpq_t one;
  fmpq_init(one);
  fmpq_one(one);
  all->count = 0;
  all->too_many = false;
  tp_status status = tp_lattice_init(&lattice, &ring, 1, one, message);
  if (status == TP_OK) {
    size_t start[2];
    const tp_geom_rings rings = tp_rings_view(&lattice, 0, 1, start);
    status = tp_rings_status(tp_geom_find_meetings(&rings, -1, keep_meeting, all),
                             "a crossing outline", message);
    tp_lattice_clear(&lattice);
  }
  fmpq_clear(one);
  qsort(all->items, all->count, sizeof all->items[0], compare_meetings);
  return status;
}

/* How far a vertex is from where it was, squared. */
static void squared_move(fmpq_t square, const tp_polyline *ring, const tp_polyline *before,
                         long k) {
  fmpq_t d;
  fmpq_init(d);
  fmpq_sub(d, ring->x + k, before->x + k);
  fmpq_mul(square, d, d);
  fmpq_sub(d, ring->y + k, before->y + k);
  fmpq_addmul(square, d, d);
  fmpq_clear(d);
}

/* Put it there, unless that is a whole digit from where it was. */
static bool apply(tp_polyline *ring, const tp_polyline *before, const tp_move *m,
                  const fmpq_t digit) {
  fmpq_t square, most;
  fmpq_init(square);
  fmpq_init(most);
  fmpq_set(ring->x + m->vertex, m->x);
  fmpq_set(ring->y + m->vertex, m->y);
  squared_move(square, ring, before, m->vertex);
  fmpq_mul(most, digit, digit);
  const bool near = fmpq_cmp(square, most) < 0;
  fmpq_clear(square);
  fmpq_clear(most);
  return near;
}

/* One move for each meeting of which nothing has moved in this round; false where one cannot be
 * mended. `moved` is by vertex, the round in which it last was. */
static bool mend(tp_polyline *ring, const tp_polyline *before, const meetings *all, int *moved,
                 int round, const fmpq_t digit) {
  bool done = true;
  tp_move m;
  tp_move_init(&m);
  for (size_t k = 0; k < all->count && done; k++) {
    const tp_geom_meeting own = all->items[k];
    const size_t count = (size_t)ring->count;
    const size_t ends[4] = {own.a, (own.a + 1) % count, own.b, (own.b + 1) % count};
    bool fresh = true;
    for (int e = 0; e < 4; e++) fresh = fresh && moved[ends[e]] != round;
    if (!fresh) continue;
    done = tp_move_choose(&m, ring, own);
    if (!done) break;
    tp_move_aim(&m, ring, digit);
    done = apply(ring, before, &m, digit);
    moved[m.vertex] = round;
  }
  tp_move_clear(&m);
  return done;
}

static bool is_large_enough(const tp_polyline *ring, const fmpq_t digit) {
  fmpq_t width, height;
  fmpq_init(width);
  fmpq_init(height);
  tp_polyline_size(width, height, ring);
  fmpq_div(width, width, digit);
  fmpq_div(height, height, digit);
  const bool large = fmpq_cmp_si(width, LEAST_SIZE) >= 0 && fmpq_cmp_si(height, LEAST_SIZE) >= 0;
  fmpq_clear(width);
  fmpq_clear(height);
  return large;
}

static tp_status go_round(tp_polyline *ring, const tp_polyline *before, tp_repair *repair,
                          meetings *all, int *moved, tp_message *message) {
  for (int round = 1; round <= MOST_ROUNDS; round++) {
    const tp_status status = find_meetings(all, ring, message);
    if (status != TP_OK) return status;
    repair->done = all->count == 0;
    if (repair->done || all->too_many) break;
    if (!mend(ring, before, all, moved, round, repair->digit)) break;
  }
  if (!repair->done) return TP_OK;
  fmpq_t square;
  fmpq_init(square);
  for (long k = 0; k < ring->count; k++) {
    if (moved[k] == 0) continue;
    squared_move(square, ring, before, k);
    repair->most = fmax(repair->most, sqrt(fmpq_get_d(square)));
    repair->moved++;
  }
  fmpq_clear(square);
  return TP_OK;
}

tp_status tp_repair_ring(tp_polyline *ring, tp_repair *repair, tp_message *message) {
  if (ring->count < 3 || !last_digit(repair->digit, ring) ||
      !is_large_enough(ring, repair->digit)) {
    return TP_OK;
  }
  tp_polyline before = {0};
  int *moved = calloc((size_t)ring->count, sizeof *moved);
  meetings *all = malloc(sizeof *all);
  tp_status status = TP_OK;
  if (moved == NULL || all == NULL || !tp_polyline_copy(&before, ring)) {
    status = tp_fail_memory(message, "the repair of an outline");
  } else {
    status = go_round(ring, &before, repair, all, moved, message);
    for (long k = 0; k < ring->count && (status != TP_OK || !repair->done); k++) {
      fmpq_set(ring->x + k, before.x + k);
      fmpq_set(ring->y + k, before.y + k);
    }
  }
  tp_polyline_clear(&before);
  free(moved);
  free(all);
  return status;
}
