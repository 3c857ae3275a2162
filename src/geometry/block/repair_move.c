/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Chooses the vertex to move among the four ends of two crossing edges, and a point on a decimal
 * grid just past the other edge, in rationals. */

#include "block/repair_move.h"

#include <math.h>

void tp_move_init(tp_move *m) {
  fmpq *const all[] = {m->dx, m->dy, m->along, m->across, m->norm, m->x, m->y, m->distance};
  for (size_t k = 0; k < sizeof all / sizeof all[0]; k++) fmpq_init(all[k]);
}

void tp_move_clear(tp_move *m) {
  fmpq *const all[] = {m->dx, m->dy, m->along, m->across, m->norm, m->x, m->y, m->distance};
  for (size_t k = 0; k < sizeof all / sizeof all[0]; k++) fmpq_clear(all[k]);
}

/* Of vertex w by the move's edge: along = d . (w - p), across = d x (w - p), and d . d. */
static void look_from_edge(tp_move *m, const tp_polyline *ring, long w) {
  fmpq_sub(m->dx, ring->x + m->next, ring->x + m->edge);
  fmpq_sub(m->dy, ring->y + m->next, ring->y + m->edge);
  fmpq_sub(m->x, ring->x + w, ring->x + m->edge);
  fmpq_sub(m->y, ring->y + w, ring->y + m->edge);
  fmpq_mul(m->along, m->dx, m->x);
  fmpq_addmul(m->along, m->dy, m->y);
  fmpq_mul(m->across, m->dx, m->y);
  fmpq_submul(m->across, m->dy, m->x);
  fmpq_mul(m->norm, m->dx, m->dx);
  fmpq_addmul(m->norm, m->dy, m->dy);
}

static int side_of(tp_move *m, const tp_polyline *ring, long w) {
  look_from_edge(m, ring, w);
  return fmpq_sgn(m->across);
}

/* The side on which the neighbours of the vertex are; of a vertex beyond the edge that of `inner`,
 * the other end of the edge that crosses. 0: they are on either side, or on the edge. */
static int wanted_side(tp_move *m, const tp_polyline *ring, tp_geom_meeting_kind kind, long inner) {
  const long count = ring->count;
  if (kind == TP_GEOM_CROSS) return side_of(m, ring, inner);
  const int before = side_of(m, ring, (m->vertex + count - 1) % count);
  const int after = side_of(m, ring, (m->vertex + 1) % count);
  return before * after < 0 ? 0 : before != 0 ? before : after;
}

bool tp_move_choose(tp_move *m, const tp_polyline *ring, tp_geom_meeting meeting) {
  const long count = ring->count, a = (long)meeting.a, b = (long)meeting.b;
  const long ends[4][3] = {{a, (a + 1) % count, b},
                           {(a + 1) % count, a, b},
                           {b, (b + 1) % count, a},
                           {(b + 1) % count, b, a}};
  fmpq_t least;
  fmpq_init(least);
  int best = -1;
  for (int k = 0; k < 4; k++) {
    m->edge = ends[k][2];
    m->next = (m->edge + 1) % count;
    m->vertex = ends[k][0];
    if (m->vertex == m->edge || m->vertex == m->next) continue;
    if (wanted_side(m, ring, meeting.kind, ends[k][1]) == 0) continue;
    look_from_edge(m, ring, m->vertex);
    if (fmpq_sgn(m->along) < 0 || fmpq_cmp(m->along, m->norm) > 0) continue;
    fmpq_mul(m->distance, m->across, m->across);
    fmpq_div(m->distance, m->distance, m->norm);
    if (best >= 0 && fmpq_cmp(m->distance, least) >= 0) continue;
    best = k;
    fmpq_set(least, m->distance);
  }
  fmpq_clear(least);
  if (best < 0) return false;
  m->vertex = ends[best][0];
  m->edge = ends[best][2];
  m->next = (m->edge + 1) % count;
  m->side = wanted_side(m, ring, meeting.kind, ends[best][1]);
  return true;
}

/* Steps of the grid in a digit: three decimals more than the scene has, far finer than the moves.
 */
enum { GRID = 1000 };

/* To the nearest multiple of a step of the grid. */
static void put_on_grid(fmpq_t x, const fmpq_t digit) {
  fmpz_t whole, steps;
  fmpq_t half;
  fmpz_init(whole);
  fmpz_init_set_ui(steps, GRID);
  fmpq_init(half);
  fmpq_set_si(half, 1, 2);
  fmpq_div(x, x, digit);
  fmpq_mul_fmpz(x, x, steps);
  fmpq_add(x, x, half);
  fmpz_fdiv_q(whole, fmpq_numref(x), fmpq_denref(x));
  fmpq_mul_fmpz(x, digit, whole);
  fmpq_div_fmpz(x, x, steps);
  fmpz_clear(whole);
  fmpz_clear(steps);
  fmpq_clear(half);
}

/* Units in which a vertex goes past the edge, an eighth of a digit where there is room. */
enum { UNIT_EXPONENT = 6, DIGIT = 1 << UNIT_EXPONENT, EIGHTH = DIGIT / 8 };

/* By how many it goes: an eighth, or half of what its way to the edge leaves of the digit. Where
 * that is hardly anything the distance moved decides afterwards. */
static long step_past(tp_move *m, const fmpq_t digit) {
  fmpq_mul(m->distance, m->across, m->across);
  fmpq_div(m->distance, m->distance, m->norm);
  fmpq_div(m->distance, m->distance, digit);
  fmpq_div(m->distance, m->distance, digit);
  const double left = DIGIT / 2.0 * (1 - sqrt(fmpq_get_d(m->distance)));
  return left >= EIGHTH ? EIGHTH : left >= 1 ? (long)left : 1;
}

/* From the foot on the edge by the step times (|dx|, |dy|) / (|dx| + |dy|) to the wanted side. */
void tp_move_aim(tp_move *m, const tp_polyline *ring, const fmpq_t digit) {
  fmpq_t sum, step;
  fmpq_init(sum);
  fmpq_init(step);
  look_from_edge(m, ring, m->vertex);
  const long past = step_past(m, digit);
  fmpq_div(m->along, m->along, m->norm);
  fmpq_mul(m->x, m->along, m->dx);
  fmpq_add(m->x, m->x, ring->x + m->edge);
  fmpq_mul(m->y, m->along, m->dy);
  fmpq_add(m->y, m->y, ring->y + m->edge);
  fmpq_abs(sum, m->dx);
  fmpq_abs(step, m->dy);
  fmpq_add(sum, sum, step);
  fmpq_div_2exp(step, digit, UNIT_EXPONENT);
  fmpq_mul_si(step, step, past);
  fmpq_div(step, step, sum);
  if (m->side < 0) fmpq_neg(step, step);
  fmpq_submul(m->x, step, m->dy);
  fmpq_addmul(m->y, step, m->dx);
  put_on_grid(m->x, digit);
  put_on_grid(m->y, digit);
  fmpq_clear(sum);
  fmpq_clear(step);
}
