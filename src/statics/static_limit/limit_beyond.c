/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Walks the outline down-dip from the toe along the sole of the block and adds the facets that a
 * longer base would have, by signs of whole numbers; the next flank or level ground ends the walk
 * (docs/mechanics.md section 6). */

#include "static_limit/limit_beyond.h"

#include <stdlib.h>

const tp_contact_point *tp_limit_toe(const tp_problem *problem, tp_direction towards) {
  const tp_contact *contact = &problem->contact;
  return contact->points + (towards == TP_TOWARDS_LEFT ? 0 : contact->point_count - 1);
}

bool tp_limit_base_beyond_toe(const tp_problem *problem, tp_direction towards) {
  const tp_lattice *l = &problem->lattice;
  const long ring = l->start[problem->section.ring_count];
  const bool left = towards == TP_TOWARDS_LEFT;
  const long toe = tp_contact_extreme(&problem->contact, left).point;
  if (left) return fmpz_cmp(l->x + ring, l->x + toe) < 0;
  return fmpz_cmp(l->x + ring + problem->base.edge_count, l->x + toe) > 0;
}

void tp_limit_direction(fmpz_t tx, fmpz_t ty, const tp_lattice *l, const tp_facet *f,
                        tp_direction towards) {
  fmpz_sub(tx, l->x + f->t1, l->x + f->t0);
  fmpz_sub(ty, l->y + f->t1, l->y + f->t0);
  if (towards == TP_TOWARDS_RIGHT) fmpz_neg(ty, ty);
}

/* The outline, walked down-dip from the toe. */
typedef struct walk {
  const tp_problem *problem;
  tp_direction towards;
  long count, last; /* vertices; the end of the underside down-dip */
} walk;

/* The end of the underside: the lowest of the vertices farthest to that side. */
static long end_of_underside(const tp_lattice *l, bool left) {
  long best = 0;
  for (long k = 1; k < l->start[1]; k++) {
    const int side = fmpz_cmp(l->x + k, l->x + best);
    if ((left ? side < 0 : side > 0) || (side == 0 && fmpz_cmp(l->y + k, l->y + best) < 0)) {
      best = k;
    }
  }
  return best;
}

/* The vertex of the outline in a point, or the one at the start of the edge that holds it inside;
 * -1 where it lies on neither. */
static long edge_at(bool *inside, const tp_lattice *l, long point) {
  const long count = l->start[1];
  *inside = false;
  for (long k = 0; k < count; k++) {
    if (tp_lattice_same_point(l, k, point)) return k;
  }
  *inside = true;
  for (long k = 0; k < count; k++) {
    const long next = k + 1 == count ? 0 : k + 1;
    if (tp_lattice_cross(l, k, next, k, point) == 0 && tp_lattice_dot(l, k, point, k, next) > 0 &&
        tp_lattice_dot(l, next, point, next, k) > 0) {
      return k;
    }
  }
  return -1;
}

/* Is the edge a sole: nearer level than upright, the block above it? */
static bool is_sole(const tp_lattice *l, long from, long to) {
  fmpz_t dx, dy;
  fmpz_init(dx);
  fmpz_init(dy);
  fmpz_sub(dx, l->x + to, l->x + from);
  fmpz_sub(dy, l->y + to, l->y + from);
  const bool sole = fmpz_sgn(dx) > 0 && fmpz_cmpabs(dy, dx) <= 0;
  fmpz_clear(dx);
  fmpz_clear(dy);
  return sole;
}

/* The facet of the contact that begins at the toe; NULL where it touches in a point. */
static const tp_facet *facet_at_toe(const tp_problem *problem, tp_direction towards) {
  const tp_contact_point *toe = tp_limit_toe(problem, towards);
  const long facet = towards == TP_TOWARDS_LEFT ? toe->right : toe->left;
  return facet >= 0 ? problem->contact.facets + facet : NULL;
}

/* Add the piece of an edge of the outline between two points; does the walk go on over it? */
static bool step(bool *done, tp_limit_beyond *b, const walk *w, long edge, long q0, long q1,
                 bool straight) {
  const tp_lattice *l = &w->problem->lattice;
  const long next = (edge + 1) % w->count;
  if (tp_section_is_arc(&w->problem->section, edge)) return false;
  const tp_facet *before =
      b->sole.count > 0 ? b->sole.items + b->sole.count - 1 : facet_at_toe(w->problem, w->towards);
  const bool goes_on =
      straight || (before != NULL && tp_lattice_cross(l, before->t0, before->t1, edge, next) == 0);
  if (!goes_on && !is_sole(l, edge, next)) return false;
  *done = tp_facets_append(&b->sole, tp_facet_of(q0, q1, edge, next, 0));
  return *done;
}

/* Along the underside from the toe, at or after vertex `at`; the point where it ends is returned.
 */
static long walk_sole(bool *done, tp_limit_beyond *b, const walk *w, long at, bool inside) {
  const bool left = w->towards == TP_TOWARDS_LEFT;
  long end = tp_contact_extreme(&w->problem->contact, left).point;
  if (inside) {
    const long next = (at + 1) % w->count;
    if (!step(done, b, w, at, left ? at : end, left ? end : next, true)) return end;
    end = left ? at : next;
  } else {
    end = at;
  }
  while (end != w->last) {
    const long edge = left ? (end + w->count - 1) % w->count : end;
    const long next = (edge + 1) % w->count;
    if (!step(done, b, w, edge, edge, next, false)) break;
    end = left ? edge : next;
  }
  return end;
}

/* Does the point of the outline lie on its underside? */
static bool is_below(const walk *w, long at, bool inside) {
  const tp_lattice *l = &w->problem->lattice;
  const bool left = w->towards == TP_TOWARDS_LEFT;
  const long other = end_of_underside(l, !left);
  const long first = left ? w->last : other, last = left ? other : w->last;
  const long span = (last - first + w->count) % w->count;
  const long offset = (at - first + w->count) % w->count;
  return inside ? offset < span : offset <= span;
}

/* Past the end of the sole: the next flank of a toothed base, level ground otherwise; it presses
 * where the last facet rises from there. */
static void set_flank(tp_limit_beyond *b, const tp_problem *problem, tp_direction towards,
                      const tp_facet *last) {
  const tp_scene *scene = problem->scene;
  tp_limit_direction(b->tx, b->ty, &problem->lattice, last, towards);
  b->rises = fmpz_sgn(b->ty) > 0;
  if (scene->block.form == TP_OUTLINE_TEETH && problem->base.mated) {
    fmpz_neg(b->ty, b->ty);
  } else {
    fmpz_one(b->tx);
    fmpz_zero(b->ty);
  }
}

bool tp_limit_beyond_init(tp_limit_beyond *b, const tp_problem *problem, tp_direction towards) {
  const tp_lattice *l = &problem->lattice;
  const bool left = towards == TP_TOWARDS_LEFT;
  const tp_outline_point toe = tp_contact_extreme(&problem->contact, left);
  *b = (tp_limit_beyond){.at = toe};
  fmpz_init(b->tx);
  fmpz_init(b->ty);
  const tp_facet *last = facet_at_toe(problem, towards);
  bool done = true;
  if (!problem->base.mated) { /* a base mated from end to end has no sole past it */
    bool inside = false;
    const long at = edge_at(&inside, l, toe.point);
    const walk w = {problem, towards, l->start[1], end_of_underside(l, left)};
    if (at >= 0 && is_below(&w, at, inside)) {
      const long end = walk_sole(&done, b, &w, at, inside);
      if (b->sole.count > 0) {
        last = b->sole.items + b->sole.count - 1;
        b->at = (tp_outline_point){.point = end};
      }
    }
  }
  const bool rounded_off =
      b->at.cut != NULL ||
      (b->at.point < l->start[1] && tp_corners_at(&problem->corners, b->at.point) != NULL);
  if (last != NULL && !rounded_off) set_flank(b, problem, towards, last);
  done = done && tp_facets_cut(&b->sole, &problem->corners, l, l->start[1]);
  if (!done) tp_limit_beyond_clear(b);
  return done;
}

void tp_limit_beyond_clear(tp_limit_beyond *b) {
  tp_facets_clear(&b->sole);
  fmpz_clear(b->tx);
  fmpz_clear(b->ty);
}
