/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Sum over facets in a binary tree of bounding boxes: runs of facets that separate wholly, or not
 * at all, are settled at once, any other facet by the part past the foot of the pivot on its
 * line. */

#include "stability/loaded_bond.h"

#include <math.h>
#include <stdlib.h>

/* Facets side by side: a box about their ends, and one about their t, in doubles and measured from
 * the first contact point; and the sums of (q0 + q1) / 2 . t and of t. */
typedef struct run {
  double low[2], high[2], t_low[2], t_high[2];
  arb_t moment;
  arb_struct t[2];
} run;

enum { FACETS_OF_LEAF = 4 };

/* A binary tree: the halves of run k are 2 k and 2 k + 1; those from `leaves` on hold facets. */
struct tp_bond {
  long leaves;
  run *runs;
  arb_struct origin[2];
};

/* Coordinates are whole numbers but for tangent points of rounded corners. */
static long exact_bits(bool sharp, const tp_evaluation *e) {
  return sharp ? ARF_PREC_EXACT : e->rung.bits;
}

static double bound_below(const arb_t ball) {
  arf_t end;
  arf_init(end);
  arb_get_lbound_arf(end, ball, 64);
  const double below = arf_get_d(end, ARF_RND_FLOOR);
  arf_clear(end);
  return below;
}

static double bound_above(const arb_t ball) {
  arf_t end;
  arf_init(end);
  arb_get_ubound_arf(end, ball, 64);
  const double above = arf_get_d(end, ARF_RND_CEIL);
  arf_clear(end);
  return above;
}

static void widen(double low[2], double high[2], const arb_struct q[2]) {
  for (int axis = 0; axis < 2; axis++) {
    low[axis] = fmin(low[axis], bound_below(q + axis));
    high[axis] = fmax(high[axis], bound_above(q + axis));
  }
}

static void run_init(run *r) {
  arb_init(r->moment);
  for (int axis = 0; axis < 2; axis++) {
    arb_init(r->t + axis);
    r->low[axis] = r->t_low[axis] = INFINITY;
    r->high[axis] = r->t_high[axis] = -INFINITY;
  }
}

/* A facet's ends, t, and whether they are exact. */
typedef struct ends {
  arb_struct q0[2], q1[2], t[2];
  long bits;
} ends;

static void ends_init(ends *own, const tp_facet *f, const tp_evaluation *e, const tp_bond *bond) {
  const tp_outline_point first = tp_facet_begin(f), last = tp_facet_end(f);
  own->bits = exact_bits(first.cut == NULL && last.cut == NULL, e);
  for (int axis = 0; axis < 2; axis++) {
    arb_init(own->q0 + axis);
    arb_init(own->q1 + axis);
    arb_init(own->t + axis);
  }
  tp_evaluation_point(own->q0, own->q0 + 1, e, first);
  tp_evaluation_point(own->q1, own->q1 + 1, e, last);
  for (int axis = 0; axis < 2; axis++) {
    arb_sub(own->t + axis, own->q1 + axis, own->q0 + axis, own->bits);
    arb_sub(own->q0 + axis, own->q0 + axis, bond->origin + axis, own->bits);
    arb_sub(own->q1 + axis, own->q1 + axis, bond->origin + axis, own->bits);
  }
}

static void ends_clear(ends *own) {
  for (int axis = 0; axis < 2; axis++) {
    arb_clear(own->q0 + axis);
    arb_clear(own->q1 + axis);
    arb_clear(own->t + axis);
  }
}

static void add_facet(run *r, const tp_facet *f, const tp_evaluation *e, const tp_bond *bond) {
  if (f->q0 == f->q1) return; /* a contact in a point has no length */
  ends own;
  ends_init(&own, f, e, bond);
  widen(r->low, r->high, own.q0);
  widen(r->low, r->high, own.q1);
  widen(r->t_low, r->t_high, own.t);
  for (int axis = 0; axis < 2; axis++) {
    arb_add(own.q0 + axis, own.q0 + axis, own.q1 + axis, own.bits);
    arb_mul_2exp_si(own.q0 + axis, own.q0 + axis, -1);
    arb_addmul(r->moment, own.q0 + axis, own.t + axis, own.bits);
    arb_add(r->t + axis, r->t + axis, own.t + axis, own.bits);
  }
  ends_clear(&own);
}

static void join(run *r, const run *a, const run *b) {
  arb_add(r->moment, a->moment, b->moment, ARF_PREC_EXACT);
  for (int axis = 0; axis < 2; axis++) {
    arb_add(r->t + axis, a->t + axis, b->t + axis, ARF_PREC_EXACT);
    r->low[axis] = fmin(a->low[axis], b->low[axis]);
    r->high[axis] = fmax(a->high[axis], b->high[axis]);
    r->t_low[axis] = fmin(a->t_low[axis], b->t_low[axis]);
    r->t_high[axis] = fmax(a->t_high[axis], b->t_high[axis]);
  }
}

tp_bond *tp_bond_new(const tp_evaluation *e) {
  const tp_contact *contact = &e->problem->contact;
  tp_bond *bond = calloc(1, sizeof *bond);
  if (bond == NULL) return NULL;
  bond->leaves = 1;
  while (bond->leaves * FACETS_OF_LEAF < contact->facet_count) bond->leaves *= 2;
  bond->runs = calloc(2 * (size_t)bond->leaves, sizeof *bond->runs);
  if (bond->runs == NULL) {
    free(bond);
    return NULL;
  }
  const tp_outline_point first = tp_contact_on_outline(contact->points);
  for (int axis = 0; axis < 2; axis++) arb_init(bond->origin + axis);
  tp_evaluation_point(bond->origin, bond->origin + 1, e, first);
  for (int axis = 0; axis < 2; axis++) arb_get_mid_arb(bond->origin + axis, bond->origin + axis);
  for (long k = 0; k < 2 * bond->leaves; k++) run_init(bond->runs + k);
  for (long k = 0; k < contact->facet_count; k++) {
    add_facet(bond->runs + bond->leaves + k / FACETS_OF_LEAF, contact->facets + k, e, bond);
  }
  for (long k = bond->leaves - 1; k > 0; k--) {
    join(bond->runs + k, bond->runs + 2 * k, bond->runs + 2 * k + 1);
  }
  return bond;
}

void tp_bond_free(tp_bond *bond) {
  if (bond == NULL) return;
  for (long k = 0; k < 2 * bond->leaves; k++) {
    arb_clear(bond->runs[k].moment);
    for (int axis = 0; axis < 2; axis++) arb_clear(bond->runs[k].t + axis);
  }
  for (int axis = 0; axis < 2; axis++) arb_clear(bond->origin + axis);
  free(bond->runs);
  free(bond);
}

/* One pivot at work. */
typedef struct query {
  const tp_bond *bond;
  const tp_evaluation *e;
  tp_outline_point pivot;
  arb_struct p[2]; /* from the origin */
  double p_low[2], p_high[2];
  bool to_the_right;
  arb_ptr sum;
} query;

/* The sign of (q - P) . t for all ends q and all t of a run, where doubles tell. Each of the few
 * roundings is at most 2^-53 of what the terms can be. */
static int side_of(const query *w, const run *r) {
  static const double roundings = 0x1p-49;
  double low = 0, high = 0, most = 0;
  for (int axis = 0; axis < 2; axis++) {
    const double a = r->low[axis] - w->p_high[axis], b = r->high[axis] - w->p_low[axis];
    const double c = r->t_low[axis], d = r->t_high[axis];
    const double products[4] = {a * c, a * d, b * c, b * d};
    low += fmin(fmin(products[0], products[1]), fmin(products[2], products[3]));
    high += fmax(fmax(products[0], products[1]), fmax(products[2], products[3]));
    const double arm = fmax(fabs(r->low[axis]), fabs(r->high[axis])) +
                       fmax(fabs(w->p_low[axis]), fabs(w->p_high[axis]));
    most += arm * fmax(fabs(c), fabs(d));
  }
  if (low > roundings * most) return 1;
  return high < -roundings * most ? -1 : 0;
}

/* The sum over a run that opens wholly: its moment less P . t, to the right. */
static void add_whole(const query *w, const run *r) {
  const long bits = exact_bits(arb_is_exact(r->moment), w->e);
  arb_t own;
  arb_init(own);
  arb_set(own, r->moment);
  for (int axis = 0; axis < 2; axis++) arb_submul(own, w->p + axis, r->t + axis, bits);
  if (!w->to_the_right) arb_neg(own, own);
  arb_add(w->sum, w->sum, own, w->e->rung.bits);
  arb_clear(own);
}

/* (q - P) . t turned to the side, and not below zero; 0 where the end is the pivot. */
static void set_opening(arb_t distance, const query *w, tp_outline_point end, const arb_struct q[2],
                        const ends *own) {
  arb_zero(distance);
  if (tp_outline_point_is_same(&w->e->problem->lattice, end, w->pivot)) return;
  const long bits = w->pivot.cut == NULL ? own->bits : w->e->rung.bits;
  arb_t part;
  arb_init(part);
  for (int axis = 0; axis < 2; axis++) {
    arb_sub(part, q + axis, w->p + axis, bits);
    arb_addmul(distance, part, own->t + axis, bits);
  }
  if (!w->to_the_right) arb_neg(distance, distance);
  arb_zero(part);
  arb_max(distance, distance, part, bits);
  arb_clear(part);
}

/* (s1^2 - s0^2) / (2 t^2), s not below zero. However the facet is divided, the sum is the same. */
static void add_part(const query *w, const tp_facet *f) {
  if (f->q0 == f->q1) return;
  const long bits = w->e->rung.bits;
  ends own;
  arb_t first, last, size;
  ends_init(&own, f, w->e, w->bond);
  arb_init(first);
  arb_init(last);
  arb_init(size);
  set_opening(first, w, tp_facet_begin(f), own.q0, &own);
  set_opening(last, w, tp_facet_end(f), own.q1, &own);
  arb_mul(first, first, first, bits);
  arb_mul(last, last, last, bits);
  arb_sub(last, last, first, bits);
  if (!w->to_the_right) arb_neg(last, last);
  for (int axis = 0; axis < 2; axis++) arb_addmul(size, own.t + axis, own.t + axis, bits);
  arb_mul_2exp_si(size, size, 1);
  arb_div(last, last, size, bits);
  arb_add(w->sum, w->sum, last, bits);
  ends_clear(&own);
  arb_clear(first);
  arb_clear(last);
  arb_clear(size);
}

static void add_run(const query *w, long at) {
  const run *r = w->bond->runs + at;
  if (r->low[0] > r->high[0]) return; /* of points alone, or empty */
  const int side = side_of(w, r);
  if (side != 0) {
    if ((side > 0) == w->to_the_right) add_whole(w, r);
    return;
  }
  if (at < w->bond->leaves) {
    add_run(w, 2 * at);
    add_run(w, 2 * at + 1);
    return;
  }
  const tp_contact *contact = &w->e->problem->contact;
  const long first = (at - w->bond->leaves) * FACETS_OF_LEAF;
  for (long k = first; k < first + FACETS_OF_LEAF && k < contact->facet_count; k++) {
    add_part(w, contact->facets + k);
  }
}

void tp_bond_moment(arb_t moment, const tp_bond *bond, const tp_evaluation *e, long k,
                    bool to_the_right) {
  query w = {.bond = bond,
             .e = e,
             .pivot = tp_contact_on_outline(e->problem->contact.points + k),
             .to_the_right = to_the_right,
             .sum = moment};
  arb_zero(moment);
  for (int axis = 0; axis < 2; axis++) arb_init(w.p + axis);
  tp_evaluation_point(w.p, w.p + 1, e, w.pivot);
  for (int axis = 0; axis < 2; axis++) {
    arb_sub(w.p + axis, w.p + axis, bond->origin + axis, exact_bits(w.pivot.cut == NULL, e));
    w.p_low[axis] = bound_below(w.p + axis);
    w.p_high[axis] = bound_above(w.p + axis);
  }
  add_run(&w, 1);
  for (int axis = 0; axis < 2; axis++) arb_clear(w.p + axis);
}
