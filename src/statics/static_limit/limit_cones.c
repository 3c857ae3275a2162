/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Contact facets and points of a problem as points of friction cones, without those that only an
 * edge of the base past the toe gives or with those that a longer base would add; frictions,
 * cohesion and bonds of each (docs/mechanics.md section 6). */

#include "static_limit/limit_cones.h"

#include "evaluation/friction.h"
#include "evaluation/loaded.h"
#include "load/setting.h"
#include "static_limit/limit_capacities.h"

/* The corner of the base, or where the base is straight there the next one towards `step`. */
static long past_straight(const tp_problem *problem, long corner, long step) {
  const tp_lattice *l = &problem->lattice;
  const long ring = l->start[problem->section.ring_count];
  const bool inner = corner > ring && corner < ring + problem->base.edge_count;
  const bool straight = inner && tp_lattice_cross(l, corner - 1, corner, corner, corner + 1) == 0;
  return straight ? corner + step : corner;
}

/* Does the facet restrain the toe alone, by an edge of the base that lies wholly past it? An edge
 * that goes on straight below the block does not, nor does an edge of the block itself. */
static bool lies_beyond(const tp_problem *problem, const tp_facet *f, tp_direction towards) {
  const tp_lattice *l = &problem->lattice;
  const tp_outline_point toe = tp_contact_on_outline(tp_limit_toe(problem, towards));
  if (f->q0 != f->q1 || !tp_outline_point_is_same(l, tp_facet_begin(f), toe)) return false;
  if (f->t0 < l->start[problem->section.ring_count]) return false;
  return towards == TP_TOWARDS_LEFT
             ? fmpz_cmp(l->x + past_straight(problem, f->t1, 1), l->x + toe.point) <= 0
             : fmpz_cmp(l->x + past_straight(problem, f->t0, -1), l->x + toe.point) >= 0;
}

static bool restrains(const tp_facet *f) {
  return f->t0 != f->t1;
}

bool tp_limit_base_matters(bool *matters, const tp_problem *problem, tp_direction towards) {
  const tp_contact *contact = &problem->contact;
  *matters = false;
  if (tp_limit_base_beyond_toe(problem, towards)) {
    for (long k = 0; k < contact->facet_count && !*matters; k++) {
      const tp_facet *f = contact->facets + k;
      *matters = restrains(f) && lies_beyond(problem, f, towards);
    }
    return true;
  }
  tp_limit_beyond beyond;
  if (!tp_limit_beyond_init(&beyond, problem, towards)) return false;
  *matters = beyond.rises || beyond.sole.count > 0;
  tp_limit_beyond_clear(&beyond);
  return true;
}

/* What is filled in, point after point. */
typedef struct filling {
  tp_cones *cones;
  const tp_evaluation *e;
  tp_direction towards;
  long next, cursor; /* of the cones' points, of the contact's points */
} filling;

/* Contact points come in the order of the facets' ends. */
static long contact_point_of(filling *f, tp_outline_point at) {
  const tp_contact *contact = &f->e->problem->contact;
  const tp_lattice *l = &f->e->problem->lattice;
  long k = f->cursor > 2 ? f->cursor - 2 : 0;
  while (k < contact->point_count - 1 &&
         !tp_outline_point_is_same(l, tp_contact_on_outline(contact->points + k), at)) {
    k++;
  }
  f->cursor = k;
  return k;
}

static void set_place(const filling *f, long own, tp_outline_point at) {
  arb_t x, y;
  arb_init(x);
  arb_init(y);
  tp_evaluation_point(x, y, f->e, at);
  if (f->e->loaded != NULL) tp_loaded_local_metres(x, y, f->e);
  tp_ball_mirror(x, f->towards);
  tp_cones_set_place(f->cones, own, x, y);
  arb_clear(x);
  arb_clear(y);
}

/* Of a point of the lattice under the weight alone. */
static void set_whole_place(const filling *f, long own, long point) {
  const tp_lattice *l = &f->e->problem->lattice;
  fmpz_t x;
  fmpz_init(x);
  if (f->towards == TP_TOWARDS_RIGHT) {
    fmpz_neg(x, l->x + point);
  } else {
    fmpz_set(x, l->x + point);
  }
  tp_cones_set_whole(f->cones, own, x, l->y + point);
  fmpz_clear(x);
}

/* A point of the cones; the direction is left to the caller. */
static long add_point(filling *f, tp_outline_point at, long site, long facet) {
  const long own = f->next++;
  if (f->e->loaded == NULL && at.cut == NULL) {
    set_whole_place(f, own, at.point);
  } else {
    set_place(f, own, at);
  }
  f->cones->points[own] = (tp_cone_point){(int32_t)site, (int32_t)facet};
  if (f->cones->owns != NULL && facet >= 0) {
    f->cones->owns[own] = (int32_t)f->e->problem->friction.of_facet[facet];
  }
  return own;
}

static void set_direction(filling *f, long own, const tp_facet *facet) {
  tp_limit_direction(f->cones->tx + own, f->cones->ty + own, &f->e->problem->lattice, facet,
                     f->towards);
}

static void add_facet(filling *f, long k) {
  const tp_facet *facet = f->e->problem->contact.facets + k;
  tp_outline_point ends[2];
  const int count = tp_facet_contacts(ends, facet);
  for (int end = 0; end < count; end++) {
    set_direction(f, add_point(f, ends[end], contact_point_of(f, ends[end]), k), facet);
  }
}

/* The site of a point past the toe: the toe's, that of a point before it there, or a new one. */
static long site_beyond(filling *f, tp_outline_point at, const tp_limit_beyond *beyond, long ends) {
  const tp_problem *problem = f->e->problem;
  const tp_contact_point *toe = tp_limit_toe(problem, f->towards);
  const tp_lattice *l = &problem->lattice;
  if (tp_outline_point_is_same(l, at, tp_contact_on_outline(toe)))
    return toe - problem->contact.points;
  for (long k = 0; k < ends; k++) {
    const tp_facet *facet = beyond->sole.items + k / 2;
    const tp_outline_point other = k % 2 == 0 ? tp_facet_begin(facet) : tp_facet_end(facet);
    if (tp_outline_point_is_same(l, at, other)) return problem->contact.point_count + k;
  }
  return problem->contact.point_count + ends;
}

static void add_beyond(filling *f, const tp_limit_beyond *beyond) {
  for (long k = 0; k < beyond->sole.count; k++) {
    const tp_facet *facet = beyond->sole.items + k;
    tp_outline_point ends[2];
    const int count = tp_facet_contacts(ends, facet);
    for (int end = 0; end < count; end++) {
      const long site = site_beyond(f, ends[end], beyond, 2 * k + end);
      set_direction(f, add_point(f, ends[end], site, -1), facet);
    }
  }
  if (!beyond->rises) return;
  const long site = site_beyond(f, beyond->at, beyond, 2 * beyond->sole.count);
  const long own = add_point(f, beyond->at, site, -1);
  fmpz_set(f->cones->tx + own, beyond->tx);
  fmpz_set(f->cones->ty + own, beyond->ty);
}

static long count_beyond(const tp_limit_beyond *beyond) {
  long count = beyond->rises ? 1 : 0;
  tp_outline_point ends[2];
  for (long k = 0; k < beyond->sole.count; k++) {
    count += tp_facet_contacts(ends, beyond->sole.items + k);
  }
  return count;
}

/* x mirrored towards the right, t is turned round as well. */
static void add_besides(filling *f) {
  const tp_problem *problem = f->e->problem;
  const tp_facet_friction *own = &problem->friction;
  const int along = f->towards == TP_TOWARDS_LEFT ? 1 : -1;
  for (long k = 0; k < own->beside_count; k++) {
    const tp_facet_beside *beside = own->besides + k;
    const tp_facet *facet = problem->contact.facets + beside->facet;
    const tp_outline_point at = beside->at_end ? tp_facet_end(facet) : tp_facet_begin(facet);
    const long point = add_point(f, at, contact_point_of(f, at), -1);
    set_direction(f, point, facet);
    f->cones->owns[point] = (int32_t)beside->friction;
    f->cones->senses[point] = (signed char)(beside->goes_on ? 0 : beside->at_end ? along : -along);
  }
}

/* What is put in behind the facets of the contact. */
typedef struct behind {
  const tp_limit_beyond *beyond; /* what a base that goes on adds, or NULL */
  bool besides;
} behind;

/* The facets of the contact, less those that a base that ends at the toe has not. */
static bool fill(tp_cones *cones, const tp_evaluation *e, tp_direction towards, bool ends,
                 behind more) {
  const tp_problem *problem = e->problem;
  const tp_contact *contact = &problem->contact;
  const long besides = more.besides ? problem->friction.beside_count : 0;
  tp_outline_point at[2];
  long count = besides + (more.beyond != NULL ? count_beyond(more.beyond) : 0);
  for (long k = 0; k < contact->facet_count; k++) {
    const tp_facet *f = contact->facets + k;
    if (!(ends && lies_beyond(problem, f, towards))) count += tp_facet_contacts(at, f);
  }
  if (!tp_cones_init(cones, count)) return false;
  if (!tp_friction_take_own(cones, e) || (besides > 0 && !tp_cones_take_senses(cones))) {
    tp_cones_clear(cones);
    return false;
  }
  cones->beside_count = besides;
  filling f = {.cones = cones, .e = e, .towards = towards};
  for (long k = 0; k < contact->facet_count; k++) {
    const tp_facet *facet = contact->facets + k;
    if (!(ends && lies_beyond(problem, facet, towards))) add_facet(&f, k);
  }
  if (more.beyond != NULL) add_beyond(&f, more.beyond);
  if (besides > 0) {
    f.cursor = 0;
    add_besides(&f);
  }
  const bool done = tp_limit_capacities_add(cones, e);
  if (!done) tp_cones_clear(cones);
  return done;
}

bool tp_limit_cones_init(tp_cones *cones, const tp_evaluation *e, tp_direction towards,
                         bool otherwise) {
  const bool goes_on = tp_limit_base_beyond_toe(e->problem, towards);
  if (!otherwise || goes_on) return fill(cones, e, towards, otherwise, (behind){NULL, false});
  tp_limit_beyond beyond;
  if (!tp_limit_beyond_init(&beyond, e->problem, towards)) return false;
  const bool done = fill(cones, e, towards, false, (behind){&beyond, false});
  tp_limit_beyond_clear(&beyond);
  return done;
}

bool tp_limit_cones_init_beside(tp_cones *cones, const tp_evaluation *e, tp_direction towards) {
  return fill(cones, e, towards, false, (behind){NULL, true});
}

static void copy_point(tp_cones *cones, long to, const tp_cones *from, long point) {
  cones->points[to] = from->points[point];
  if (cones->owns != NULL) cones->owns[to] = from->owns[point];
  const arb_struct x = tp_cones_x(from, point), y = tp_cones_y(from, point);
  tp_cones_set_place(cones, to, &x, &y);
  fmpz_set(cones->tx + to, from->tx + point);
  fmpz_set(cones->ty + to, from->ty + point);
}

bool tp_limit_cones_added(tp_cones *cones, const tp_evaluation *e, tp_direction towards,
                          const tp_cones *own, const long points[2]) {
  tp_limit_beyond beyond;
  if (!tp_limit_beyond_init(&beyond, e->problem, towards)) return false;
  bool done = tp_cones_init(cones, 2 + count_beyond(&beyond));
  if (done && own->owns != NULL && !tp_cones_take_own(cones, own->own_count)) {
    tp_cones_clear(cones);
    done = false;
  }
  if (done) {
    for (int k = 0; k < 2; k++) copy_point(cones, k, own, points[k]);
    arb_set(cones->friction, own->friction);
    if (own->owns != NULL) {
      _arb_vec_set(cones->own_friction, own->own_friction, own->own_count);
    }
    filling f = {.cones = cones, .e = e, .towards = towards, .next = 2};
    add_beyond(&f, &beyond);
  }
  tp_limit_beyond_clear(&beyond);
  return done;
}

bool tp_limit_keeps_facet(const tp_problem *problem, tp_direction towards, long facet) {
  return !lies_beyond(problem, problem->contact.facets + facet, towards);
}
