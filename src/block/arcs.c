/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "block/arcs.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Exact points and vectors. */
typedef struct point {
  fmpq_t x, y;
} point;

static void point_init(point *p) {
  fmpq_init(p->x);
  fmpq_init(p->y);
}

static void point_clear(point *p) {
  fmpq_clear(p->x);
  fmpq_clear(p->y);
}

static void difference(point *d, const point *p, const point *q) {
  fmpq_sub(d->x, p->x, q->x);
  fmpq_sub(d->y, p->y, q->y);
}

static void dot(fmpq_t value, const point *p, const point *q) {
  fmpq_mul(value, p->x, q->x);
  fmpq_addmul(value, p->y, q->y);
}

static void cross(fmpq_t value, const point *p, const point *q) {
  fmpq_mul(value, p->x, q->y);
  fmpq_submul(value, p->y, q->x);
}

/* p + t q */
static void along(point *sum, const point *p, const fmpq_t t, const point *q) {
  fmpq_set(sum->x, p->x);
  fmpq_set(sum->y, p->y);
  fmpq_addmul(sum->x, t, q->x);
  fmpq_addmul(sum->y, t, q->y);
}

/* An arc from p to q, counter-clockwise about its centre, the block inside. */
typedef struct arc {
  point p, q, centre;
} arc;

static void arc_init(arc *a) {
  point_init(&a->p);
  point_init(&a->q);
  point_init(&a->centre);
}

static void arc_clear(arc *a) {
  point_clear(&a->p);
  point_clear(&a->q);
  point_clear(&a->centre);
}

/* The centre of the circle through p, m and q: with u = m - p and v = q - p,
 * C - p = (v_y |u|^2 - u_y |v|^2, u_x |v|^2 - v_x |u|^2) / (2 u x v). False where
 * m is not to the right of the chord from p to q: then the arc does not bulge outwards. */
static bool set_centre(arc *a, const point *m) {
  point u, v;
  fmpq_t uu, vv, area, t;
  point_init(&u);
  point_init(&v);
  fmpq_init(uu);
  fmpq_init(vv);
  fmpq_init(area);
  fmpq_init(t);
  difference(&u, m, &a->p);
  difference(&v, &a->q, &a->p);
  dot(uu, &u, &u);
  dot(vv, &v, &v);
  cross(area, &u, &v);
  const bool outwards = fmpq_sgn(area) > 0;
  if (outwards) {
    fmpq_add(area, area, area);
    fmpq_mul(t, v.y, uu);
    fmpq_submul(t, u.y, vv);
    fmpq_div(t, t, area);
    fmpq_add(a->centre.x, a->p.x, t);
    fmpq_mul(t, u.x, vv);
    fmpq_submul(t, v.x, uu);
    fmpq_div(t, t, area);
    fmpq_add(a->centre.y, a->p.y, t);
  }
  point_clear(&u);
  point_clear(&v);
  fmpq_clear(uu);
  fmpq_clear(vv);
  fmpq_clear(area);
  fmpq_clear(t);
  return outwards;
}

/* The angle of the arc, in (0, 2 pi), for the choice of points on it alone. */
static double angle(const arc *a) {
  const double px = fmpq_get_d(a->p.x) - fmpq_get_d(a->centre.x);
  const double py = fmpq_get_d(a->p.y) - fmpq_get_d(a->centre.y);
  const double qx = fmpq_get_d(a->q.x) - fmpq_get_d(a->centre.x);
  const double qy = fmpq_get_d(a->q.y) - fmpq_get_d(a->centre.y);
  const double turn = atan2(px * qy - py * qx, px * qx + py * qy);
  return turn > 0 ? turn : turn + 2 * M_PI;
}

/* A point of the circle: p turned about the centre by the angle whose half has the tangent t. */
static void turned(point *r, const arc *a, const fmpq_t t) {
  point u;
  fmpq_t cosine, sine, size;
  point_init(&u);
  fmpq_init(cosine);
  fmpq_init(sine);
  fmpq_init(size);
  difference(&u, &a->p, &a->centre);
  fmpq_mul(size, t, t);
  fmpq_one(cosine);
  fmpq_sub(cosine, cosine, size);
  fmpq_add_si(size, size, 1);
  fmpq_div(cosine, cosine, size);
  fmpq_add(sine, t, t);
  fmpq_div(sine, sine, size);
  fmpq_mul(r->x, cosine, u.x);
  fmpq_submul(r->x, sine, u.y);
  fmpq_mul(r->y, sine, u.x);
  fmpq_addmul(r->y, cosine, u.y);
  fmpq_add(r->x, r->x, a->centre.x);
  fmpq_add(r->y, r->y, a->centre.y);
  point_clear(&u);
  fmpq_clear(cosine);
  fmpq_clear(sine);
  fmpq_clear(size);
}

/* Where the tangents at two points of the circle meet: C + R^2 (A + B) / (R^2 + A . B). */
static void meeting(point *m, const arc *a, const point *p, const point *q) {
  point u, v;
  fmpq_t rr, t;
  point_init(&u);
  point_init(&v);
  fmpq_init(rr);
  fmpq_init(t);
  difference(&u, p, &a->centre);
  difference(&v, q, &a->centre);
  dot(rr, &u, &u);
  dot(t, &u, &v);
  fmpq_add(t, t, rr);
  fmpq_div(t, rr, t);
  fmpq_add(u.x, u.x, v.x);
  fmpq_add(u.y, u.y, v.y);
  along(m, &a->centre, t, &u);
  point_clear(&u);
  point_clear(&v);
  fmpq_clear(rr);
  fmpq_clear(t);
}

static tp_arc_tip *add_tip(tp_arc_tips *tips) {
  if (tips->count == tips->capacity) {
    const long capacity = 2 * tips->capacity + 16;
    tp_arc_tip *items = realloc(tips->items, (size_t)capacity * sizeof *items);
    if (items == NULL) return NULL;
    tips->items = items;
    tips->capacity = capacity;
  }
  tp_arc_tip *tip = tips->items + tips->count++;
  fmpq_init(tip->before_x);
  fmpq_init(tip->before_y);
  fmpq_init(tip->after_x);
  fmpq_init(tip->after_y);
  fmpq_init(tip->centre_x);
  fmpq_init(tip->centre_y);
  return tip;
}

/* The tangents between two points of the arc. */
static bool add_piece(tp_arc_tips *tips, tp_polyline *ring, const arc *a, const point *from,
                      const point *to, tp_mark mark) {
  point m;
  point_init(&m);
  meeting(&m, a, from, to);
  tp_arc_tip *tip = add_tip(tips);
  bool done = tip != NULL;
  if (done) {
    tip->vertex = ring->count;
    fmpq_set(tip->before_x, from->x);
    fmpq_set(tip->before_y, from->y);
    fmpq_set(tip->after_x, to->x);
    fmpq_set(tip->after_y, to->y);
    fmpq_set(tip->centre_x, a->centre.x);
    fmpq_set(tip->centre_y, a->centre.y);
    done = tp_polyline_append(ring, m.x, m.y, mark) &&
           tp_polyline_append(&tips->chords, from->x, from->y, mark);
  }
  point_clear(&m);
  return done;
}

/* The arc in pieces of about 40 degrees: tangents into `ring`, points into `tips->chords`. */
static bool add_arc(tp_arc_tips *tips, tp_polyline *ring, const arc *a, tp_mark mark) {
  enum { STEPS = 64, MOST = 64000 }; /* tangents of half angles are multiples of 1 / STEPS */
  const double whole = angle(a);
  const int pieces = 1 + (int)(whole / 0.7);
  point from, to;
  fmpq_t t;
  point_init(&from);
  point_init(&to);
  fmpq_init(t);
  fmpq_set(from.x, a->p.x);
  fmpq_set(from.y, a->p.y);
  bool done = true;
  for (int k = 1; k <= pieces && done; k++) {
    if (k == pieces) {
      fmpq_set(to.x, a->q.x);
      fmpq_set(to.y, a->q.y);
    } else {
      const double half = STEPS * tan(whole * k / pieces / 2);
      fmpq_set_si(t, lround(fmax(-MOST, fmin(half, MOST))), STEPS);
      turned(&to, a, t);
    }
    done = add_piece(tips, ring, a, &from, &to, mark);
    fmpq_set(from.x, to.x);
    fmpq_set(from.y, to.y);
  }
  point_clear(&from);
  point_clear(&to);
  fmpq_clear(t);
  return done;
}

/* The arc of an edge of the outline, or NULL. */
static const tp_arc_description *find_arc(const tp_block_description *block,
                                          const tp_polyline *outline, long edge) {
  const long next = edge + 1 == outline->count ? 0 : edge + 1;
  const long own = outline->reversed ? next : edge; /* the end that its author names */
  for (long k = 0; k < block->arc_count; k++) {
    if (fmpq_equal(block->arcs[k].x.value, outline->x + own) &&
        fmpq_equal(block->arcs[k].y.value, outline->y + own)) {
      return block->arcs + k;
    }
  }
  return NULL;
}

/* A point that the arc goes through: given, or the middle of the chord moved outwards by half of
 * the bulge times the chord. */
static void set_through(point *m, const arc *a, const tp_arc_description *d) {
  if (!d->bulge.given) {
    fmpq_set(m->x, d->through_x.value);
    fmpq_set(m->y, d->through_y.value);
    return;
  }
  point v, normal;
  fmpq_t half;
  point_init(&v);
  point_init(&normal);
  fmpq_init(half);
  fmpq_set_si(half, 1, 2);
  difference(&v, &a->q, &a->p);
  along(m, &a->p, half, &v);
  fmpq_set(normal.x, v.y);
  fmpq_neg(normal.y, v.x);
  fmpq_mul(half, half, d->bulge.value);
  along(&v, m, half, &normal);
  fmpq_set(m->x, v.x);
  fmpq_set(m->y, v.y);
  point_clear(&v);
  point_clear(&normal);
  fmpq_clear(half);
}

/* One edge of the outline into the rings. */
static tp_status add_edge(tp_arc_tips *tips, tp_polyline *ring, const tp_polyline *outline,
                          long edge, const tp_arc_description *d, tp_message *message) {
  const long next = edge + 1 == outline->count ? 0 : edge + 1;
  const tp_mark mark = outline->marks[edge];
  bool done = tp_polyline_append(ring, outline->x + edge, outline->y + edge, mark);
  if (d == NULL) {
    done = done && tp_polyline_append(&tips->chords, outline->x + edge, outline->y + edge, mark);
    return done ? TP_OK : tp_fail_memory(message, "the arcs");
  }
  arc a;
  point m;
  arc_init(&a);
  point_init(&m);
  fmpq_set(a.p.x, outline->x + edge);
  fmpq_set(a.p.y, outline->y + edge);
  fmpq_set(a.q.x, outline->x + next);
  fmpq_set(a.q.y, outline->y + next);
  set_through(&m, &a, d);
  tp_status status = TP_OK;
  if (!set_centre(&a, &m)) {
    status = tp_fail(message, TP_BAD_INPUT, d->place,
                     "this arc does not bulge outwards: arcs inwards and straight ones are not "
                     "taken");
  } else if (!done || !add_arc(tips, ring, &a, mark)) {
    status = tp_fail_memory(message, "the arcs");
  }
  arc_clear(&a);
  point_clear(&m);
  return status;
}

tp_status tp_arcs_apply(tp_arc_tips *tips, tp_polyline *outline, const tp_block_description *block,
                        tp_message *message) {
  memset(tips, 0, sizeof *tips);
  if (block->arc_count == 0) return TP_OK;
  tp_polyline ring = {.file = outline->file, .mark = outline->mark, .reversed = outline->reversed};
  tips->chords.file = outline->file;
  tips->chords.mark = outline->mark;
  tips->chords.reversed = outline->reversed;
  tp_status status = TP_OK;
  long found = 0;
  for (long k = 0; k < outline->count && status == TP_OK; k++) {
    const tp_arc_description *d = find_arc(block, outline, k);
    found += d != NULL;
    status = add_edge(tips, &ring, outline, k, d, message);
  }
  if (status == TP_OK && found != block->arc_count) {
    status = tp_fail(message, TP_BAD_INPUT, block->arcs[0].place,
                     "an arc begins in no vertex of the outline, or two begin in the same");
  }
  if (status == TP_OK) {
    tp_polyline_clear(outline);
    *outline = ring;
  } else {
    tp_polyline_clear(&ring);
    tp_arc_tips_clear(tips);
  }
  return status;
}

void tp_arc_tips_clear(tp_arc_tips *tips) {
  for (long k = 0; k < tips->count; k++) {
    tp_arc_tip *tip = tips->items + k;
    fmpq_clear(tip->before_x);
    fmpq_clear(tip->before_y);
    fmpq_clear(tip->after_x);
    fmpq_clear(tip->after_y);
    fmpq_clear(tip->centre_x);
    fmpq_clear(tip->centre_y);
  }
  free(tips->items);
  tp_polyline_clear(&tips->chords);
  memset(tips, 0, sizeof *tips);
}
