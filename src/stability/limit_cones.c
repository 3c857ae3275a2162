/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "stability/limit_cones.h"

#include "stability/loaded.h"

#include <stdlib.h>

static long toe_index(const tp_problem *problem, tp_direction towards) {
  return towards == TP_TOWARDS_LEFT ? 0 : problem->contact.point_count - 1;
}

static long toe_point(const tp_problem *problem, tp_direction towards) {
  return problem->contact.points[toe_index(problem, towards)].point;
}

bool tp_limit_base_beyond_toe(const tp_problem *problem, tp_direction towards) {
  const tp_lattice *l = &problem->lattice;
  const long ring = l->start[problem->section.ring_count], toe = toe_point(problem, towards);
  if (towards == TP_TOWARDS_LEFT) return fmpz_cmp(l->x + ring, l->x + toe) < 0;
  return fmpz_cmp(l->x + ring + problem->base.edge_count, l->x + toe) > 0;
}

/* The corner of the base, or where the base is straight there the next one towards `step`. */
static long past_straight(const tp_problem *problem, long corner, long step) {
  const tp_lattice *l = &problem->lattice;
  const long ring = l->start[problem->section.ring_count];
  const bool inner = corner > ring && corner < ring + problem->base.edge_count;
  const bool straight = inner && tp_facet_cross(l, corner - 1, corner, corner, corner + 1) == 0;
  return straight ? corner + step : corner;
}

/* Does the facet restrain the toe alone, by an edge of the base that lies wholly past it? An edge
 * that goes on straight below the block does not, nor does an edge of the block itself. */
static bool lies_beyond(const tp_problem *problem, const tp_facet *f, tp_direction towards) {
  const tp_lattice *l = &problem->lattice;
  const long toe = toe_point(problem, towards);
  if (f->q0 != f->q1 || !tp_facet_same_point(l, f->q0, toe)) return false;
  if (f->t0 < l->start[problem->section.ring_count]) return false;
  return towards == TP_TOWARDS_LEFT
             ? fmpz_cmp(l->x + past_straight(problem, f->t1, 1), l->x + toe) <= 0
             : fmpz_cmp(l->x + past_straight(problem, f->t0, -1), l->x + toe) >= 0;
}

static bool restrains(const tp_facet *f) {
  return f->t0 != f->t1;
}

/* t of a facet, up-dip. */
static void set_direction(fmpz_t tx, fmpz_t ty, const tp_lattice *l, const tp_facet *f,
                          bool mirrored) {
  fmpz_sub(tx, l->x + f->t1, l->x + f->t0);
  fmpz_sub(ty, l->y + f->t1, l->y + f->t0);
  if (mirrored) fmpz_neg(ty, ty);
}

/* The direction of the base past a toe at which it ends: the next flank of a toothed base, level
 * ground otherwise. False where it turns away from the facet at the toe, and so bears nothing. */
static bool beyond_direction(fmpz_t tx, fmpz_t ty, const tp_problem *problem,
                             tp_direction towards) {
  const tp_contact *contact = &problem->contact;
  const tp_contact_point *toe = contact->points + toe_index(problem, towards);
  const long facet = towards == TP_TOWARDS_LEFT ? toe->right : toe->left;
  if (facet < 0) return false;
  set_direction(tx, ty, &problem->lattice, contact->facets + facet, towards == TP_TOWARDS_RIGHT);
  const bool rises = fmpz_sgn(ty) > 0;
  const tp_scene *scene = problem->scene;
  if (scene->block.form == TP_OUTLINE_TEETH && scene->base.mated &&
      scene->base.between.count == 0) {
    fmpz_neg(ty, ty);
  } else {
    fmpz_one(tx);
    fmpz_zero(ty);
  }
  return rises;
}

bool tp_limit_base_matters(const tp_problem *problem, tp_direction towards) {
  const tp_contact *contact = &problem->contact;
  if (tp_limit_base_beyond_toe(problem, towards)) {
    for (long k = 0; k < contact->facet_count; k++) {
      const tp_facet *f = contact->facets + k;
      if (restrains(f) && lies_beyond(problem, f, towards)) return true;
    }
    return false;
  }
  fmpz_t tx, ty;
  fmpz_init(tx);
  fmpz_init(ty);
  const bool matters = beyond_direction(tx, ty, problem, towards);
  fmpz_clear(tx);
  fmpz_clear(ty);
  return matters;
}

/* What is filled in, point after point. */
typedef struct filling {
  tp_cones *cones;
  const tp_evaluation *e;
  tp_direction towards;
  bool mirrored;
  long next, cursor; /* of the cones' points, of the contact's points */
} filling;

/* Contact points come in the order of the facets' ends. */
static long contact_point_of(filling *f, long point) {
  const tp_contact *contact = &f->e->problem->contact;
  const tp_lattice *l = &f->e->problem->lattice;
  long k = f->cursor > 2 ? f->cursor - 2 : 0;
  while (k < contact->point_count - 1 && !tp_facet_same_point(l, contact->points[k].point, point)) {
    k++;
  }
  f->cursor = k;
  return k;
}

/* One end of a facet: with rounded corners the tangent point on the facet's side. */
static long add_point(filling *f, long point, bool on_the_right, long facet) {
  const tp_problem *problem = f->e->problem;
  const long own = f->next++, index = contact_point_of(f, point);
  const tp_direction side = on_the_right ? TP_TOWARDS_LEFT : TP_TOWARDS_RIGHT;
  arb_ptr x = f->cones->x + own, y = f->cones->y + own;
  tp_evaluation_axis(x, y, f->e, point, side);
  if (f->e->loaded != NULL) {
    tp_loaded_metres(x, y, f->e);
  }
  if (f->mirrored) arb_neg(x, x);
  const bool rounded = problem->corners.count > 0 &&
                       tp_corners_find(&problem->corners, &problem->lattice, point) != NULL;
  f->cones->points[own] =
      (tp_cone_point){.site = 2 * index + (rounded && on_the_right ? 1 : 0), .facet = facet};
  return own;
}

static void add_facet(filling *f, long k) {
  const tp_problem *problem = f->e->problem;
  const tp_facet *facet = problem->contact.facets + k;
  const long ends = facet->q0 == facet->q1 ? 1 : 2;
  for (long end = 0; end < ends; end++) {
    const long own = add_point(f, end == 0 ? facet->q0 : facet->q1, end == 0, k);
    set_direction(f->cones->tx + own, f->cones->ty + own, &problem->lattice, facet, f->mirrored);
  }
}

static void add_beyond(filling *f) {
  const tp_problem *problem = f->e->problem;
  f->cursor = 0;
  const long own = add_point(f, toe_point(problem, f->towards), !f->mirrored, -1);
  (void)beyond_direction(f->cones->tx + own, f->cones->ty + own, problem, f->towards);
}

/* Length of the facet of two points, over the length of its t. */
static void facet_length(arb_t length, const tp_cones *cones, long point, long bits) {
  arb_t dx, dy;
  arb_init(dx);
  arb_init(dy);
  arb_sub(dx, cones->x + point + 1, cones->x + point, bits);
  arb_sub(dy, cones->y + point + 1, cones->y + point, bits);
  arb_hypot(length, dx, dy, bits);
  arb_set_fmpz(dx, cones->tx + point);
  arb_set_fmpz(dy, cones->ty + point);
  arb_hypot(dx, dx, dy, bits);
  arb_div(length, length, dx, bits);
  arb_clear(dx);
  arb_clear(dy);
}

/* kPa on a metre of thickness, N per metre of facet. */
static void set_strength(arb_t bound, const arb_t length, const tp_quantity *kpa,
                         const tp_evaluation *e) {
  const long bits = e->rung.bits;
  fmpq_t factor;
  fmpq_init(factor);
  tp_problem_thickness(factor, e->problem);
  fmpq_mul(factor, factor, kpa->value);
  fmpq_mul_ui(factor, factor, 1000);
  arb_mul_fmpz(bound, length, fmpq_numref(factor), bits);
  arb_div_fmpz(bound, bound, fmpq_denref(factor), bits);
  fmpq_clear(factor);
}

static void fill_allowances(tp_cones *cones, const tp_evaluation *e) {
  const tp_loads_description *loads = &e->problem->scene->loads;
  arb_t length;
  arb_init(length);
  long own = 0;
  for (long k = 0; own < cones->allowance_count; k++) {
    if (cones->points[k].facet < 0 || cones->points[k].facet != cones->points[k + 1].facet)
      continue;
    tp_allowance *a = cones->allowances + own++;
    a->point = k;
    facet_length(length, cones, k, e->rung.bits);
    set_strength(a->shear, length, &loads->cohesion_kpa, e);
    set_strength(a->pull, length, &loads->bond_kpa, e);
  }
  arb_clear(length);
}

bool tp_limit_cones_init(tp_cones *cones, const tp_evaluation *e, tp_direction towards,
                         bool otherwise) {
  const tp_problem *problem = e->problem;
  const tp_contact *contact = &problem->contact;
  const tp_loads_description *loads = &problem->scene->loads;
  const bool goes_on = tp_limit_base_beyond_toe(problem, towards);
  /* strength of nothing adds no forces, and no ties of mechanisms that hold them */
  const bool strong = e->loaded != NULL && !(fmpq_is_zero(loads->cohesion_kpa.value) &&
                                             fmpq_is_zero(loads->bond_kpa.value));
  long count = otherwise && !goes_on ? 1 : 0, lengths = 0;
  for (long k = 0; k < contact->facet_count; k++) {
    const tp_facet *f = contact->facets + k;
    const bool dropped = otherwise && goes_on && lies_beyond(problem, f, towards);
    if (!restrains(f) || dropped) continue;
    count += f->q0 == f->q1 ? 1 : 2;
    if (f->q0 != f->q1) lengths++;
  }
  if (!tp_cones_init(cones, count, strong ? lengths : 0)) return false;
  filling f = {.cones = cones, .e = e, .towards = towards, .mirrored = towards == TP_TOWARDS_RIGHT};
  for (long k = 0; k < contact->facet_count; k++) {
    const tp_facet *facet = contact->facets + k;
    const bool dropped = otherwise && goes_on && lies_beyond(problem, facet, towards);
    if (restrains(facet) && !dropped) add_facet(&f, k);
  }
  if (otherwise && !goes_on) add_beyond(&f);
  fill_allowances(cones, e);
  return true;
}
