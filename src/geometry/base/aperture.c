/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Gap along y between underside and profile over every common piece of x, linear in x: its exact
 * largest value, and the length, area and matched share of the joint in balls. */

#include "base/aperture.h"

void tp_aperture_init(tp_aperture *a) {
  fmpq_init(a->largest);
  arb_init(a->length);
  arb_init(a->covered);
  arb_init(a->area);
  arb_init(a->matched);
}

void tp_aperture_clear(tp_aperture *a) {
  fmpq_clear(a->largest);
  arb_clear(a->length);
  arb_clear(a->covered);
  arb_clear(a->area);
  arb_clear(a->matched);
}

/* An edge that is not upright, by its ends. */
typedef struct edge {
  const fmpq *x0, *y0, *x1, *y1;
} edge;

/* One piece: where it begins and ends, and the gaps there. */
typedef struct piece {
  fmpq_t from, to, gap_from, gap_to, work;
} piece;

/* Of the line through the edge at x. */
static void height_at(fmpq_t y, const edge *e, const fmpq_t x, fmpq_t work) {
  fmpq_sub(y, x, e->x0);
  fmpq_sub(work, e->x1, e->x0);
  fmpq_div(y, y, work);
  fmpq_sub(work, e->y1, e->y0);
  fmpq_mul(y, y, work);
  fmpq_add(y, y, e->y0);
}

static void gap_at(fmpq_t gap, const edge *above, const edge *below, const fmpq_t x, piece *p) {
  fmpq_t base;
  fmpq_init(base);
  height_at(gap, above, x, p->work);
  height_at(base, below, x, p->work);
  fmpq_sub(gap, gap, base);
  fmpq_clear(base);
}

static void add_to(arb_t sum, const fmpq_t length, arb_t work, long bits) {
  arb_set_fmpq(work, length, bits);
  arb_add(sum, sum, work, bits);
}

/* Of the piece's width the share at which a gap that goes from `low` to a higher one, `high`, is no
 * more than the closure. */
static void share_within(fmpq_t share, const fmpq_t low, const fmpq_t high, const fmpq_t closure,
                         fmpq_t work) {
  if (fmpq_cmp(high, closure) <= 0) {
    fmpq_one(share);
  } else if (fmpq_cmp(low, closure) >= 0) {
    fmpq_zero(share);
  } else {
    fmpq_sub(share, closure, low);
    fmpq_sub(work, high, low);
    fmpq_div(share, share, work);
  }
}

static void add_piece(tp_aperture *a, const edge *above, const edge *below, piece *p,
                      const fmpq_t closure, arb_t work, long bits) {
  fmpq_t width, term;
  fmpq_init(width);
  fmpq_init(term);
  gap_at(p->gap_from, above, below, p->from, p);
  gap_at(p->gap_to, above, below, p->to, p);
  const bool rises = fmpq_cmp(p->gap_from, p->gap_to) <= 0;
  const fmpq *low = rises ? p->gap_from : p->gap_to, *high = rises ? p->gap_to : p->gap_from;
  if (fmpq_cmp(high, a->largest) > 0) fmpq_set(a->largest, high);
  fmpq_sub(width, p->to, p->from);
  add_to(a->covered, width, work, bits);
  fmpq_add(term, low, high);
  fmpq_mul(term, term, width);
  fmpq_div_2exp(term, term, 1);
  add_to(a->area, term, work, bits);
  share_within(term, low, high, closure, p->work);
  fmpq_mul(term, term, width);
  add_to(a->matched, term, work, bits);
  fmpq_clear(width);
  fmpq_clear(term);
}

/* The first edge of the profile that ends right of x; that before its last point, if none does. */
static long edge_at(const tp_polyline *profile, long points, const fmpq *x) {
  long low = 0, high = points - 2;
  while (low < high) {
    const long middle = low + (high - low) / 2;
    if (fmpq_cmp(profile->x + middle + 1, x) > 0) {
      high = middle;
    } else {
      low = middle + 1;
    }
  }
  return low;
}

/* All pieces of one edge of the underside, which runs to the right. */
static void add_edge(tp_aperture *a, const edge *above, const tp_polyline *profile, long points,
                     const fmpq_t closure, piece *p, arb_t work, long bits) {
  for (long k = edge_at(profile, points, above->x0); k + 1 < points; k++) {
    const edge below = {profile->x + k, profile->y + k, profile->x + k + 1, profile->y + k + 1};
    if (fmpq_cmp(below.x0, above->x1) >= 0) break;
    fmpq_set(p->from, fmpq_cmp(below.x0, above->x0) > 0 ? below.x0 : above->x0);
    fmpq_set(p->to, fmpq_cmp(below.x1, above->x1) < 0 ? below.x1 : above->x1);
    if (fmpq_cmp(p->from, p->to) < 0) add_piece(a, above, &below, p, closure, work, bits);
  }
}

void tp_aperture_measure(tp_aperture *a, const tp_polyline *outline, long first, long count,
                         const tp_polyline *profile, long points, const fmpq_t closure, long bits) {
  piece p;
  fmpq_t width;
  arb_t work;
  fmpq_init(p.from);
  fmpq_init(p.to);
  fmpq_init(p.gap_from);
  fmpq_init(p.gap_to);
  fmpq_init(p.work);
  fmpq_init(width);
  arb_init(work);
  fmpq_zero(a->largest);
  arb_zero(a->length);
  arb_zero(a->covered);
  arb_zero(a->area);
  arb_zero(a->matched);
  for (long k = 0; k < count; k++) {
    const long from = (first + k) % outline->count, to = (from + 1) % outline->count;
    const edge above = {outline->x + from, outline->y + from, outline->x + to, outline->y + to};
    fmpq_sub(width, above.x1, above.x0);
    const int side = fmpq_sgn(width);
    fmpq_abs(width, width);
    add_to(a->length, width, work, bits);
    if (side > 0) add_edge(a, &above, profile, points, closure, &p, work, bits);
  }
  fmpq_clear(p.from);
  fmpq_clear(p.to);
  fmpq_clear(p.gap_from);
  fmpq_clear(p.gap_to);
  fmpq_clear(p.work);
  fmpq_clear(width);
  arb_clear(work);
}
