/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Contact points from the facets in their order along x; each gets its kind (valley, peak, flat
 * end, flank; Fig. 8 and docs/mechanics.md section 3) from the exact heights of its neighbours. */

#include "base/contact.h"

#include "base/closeness.h"

#include <stdlib.h>
#include <string.h>

void tp_contact_clear(tp_contact *contact) {
  tp_facets_clear(&(tp_facets){.count = contact->facet_count, .items = contact->facets});
  free(contact->points);
  memset(contact, 0, sizeof *contact);
}

static int compare_heights(const tp_lattice *l, long a, long b) {
  return fmpz_cmp(l->y + a, l->y + b);
}

/* Heights of the neighbours on the underside relative to the point decide its kind. */
static tp_pivot_kind kind_between(int left, int right, bool has_left, bool has_right) {
  if (!has_left) left = right;
  if (!has_right) right = left;
  if (left > 0 && right > 0) return TP_PIVOT_VALLEY;
  if (left < 0 && right < 0) return TP_PIVOT_PEAK;
  if (left == 0 && right == 0) return has_left && has_right ? TP_PIVOT_FLANK : TP_PIVOT_FLAT_END;
  return left == 0 || right == 0 ? TP_PIVOT_FLAT_END : TP_PIVOT_FLANK;
}

/* A point of its own takes its kind from the outline, or from the profile where the block touches a
 * corner of it. */
static tp_pivot_kind kind_alone(const tp_lattice *l, long point, long outline_count, long ring,
                                long edge_count) {
  const bool of_outline = point < outline_count;
  const long before = of_outline ? (point == 0 ? outline_count - 1 : point - 1) : point - 1;
  const long after = of_outline ? (point + 1 == outline_count ? 0 : point + 1) : point + 1;
  const bool has_before = of_outline || point > ring;
  const bool has_after = of_outline || point < ring + edge_count;
  return kind_between(has_before ? compare_heights(l, before, point) : 0,
                      has_after ? compare_heights(l, after, point) : 0, has_before, has_after);
}

tp_outline_point tp_contact_on_outline(const tp_contact_point *point) {
  return (tp_outline_point){point->point, point->cut, point->after};
}

tp_outline_point tp_contact_end_on_outline(const tp_contact_point *point, bool left) {
  const bool other = point->also != NULL && point->also->after == left;
  return other ? *point->also : tp_contact_on_outline(point);
}

tp_outline_point tp_contact_extreme(const tp_contact *contact, bool left) {
  return tp_contact_end_on_outline(contact->points + (left ? 0 : contact->point_count - 1), left);
}

static tp_contact_point *add_point(tp_contact *contact, const tp_lattice *l, tp_outline_point at,
                                   long left, long right) {
  for (long k = contact->point_count - 1; k >= 0 && k >= contact->point_count - 2; k--) {
    tp_contact_point *known = contact->points + k;
    if (!tp_outline_point_is_same(l, tp_contact_on_outline(known), at)) continue;
    if (left >= 0) known->left = (int32_t)left;
    if (right >= 0) known->right = (int32_t)right;
    return known;
  }
  tp_contact_point *own = contact->points + contact->point_count++;
  *own = (tp_contact_point){.point = (int32_t)at.point,
                            .cut = at.cut,
                            .after = at.after,
                            .left = (int32_t)left,
                            .right = (int32_t)right};
  return own;
}

/* Heights of the facets' far ends relative to the point: facets run along their direction. */
static tp_pivot_kind kind_on_facets(const tp_contact *contact, const tp_lattice *l,
                                    const tp_contact_point *p) {
  const tp_facet *left = p->left >= 0 ? contact->facets + p->left : NULL;
  const tp_facet *right = p->right >= 0 ? contact->facets + p->right : NULL;
  return kind_between(left != NULL ? compare_heights(l, left->t0, left->t1) : 0,
                      right != NULL ? compare_heights(l, right->t1, right->t0) : 0, left != NULL,
                      right != NULL);
}

/* Of a point in which two roundings meet: the left end of its edge and the right end at once. */
static tp_pivot_kind kind_between_roundings(const tp_lattice *l, const tp_corner *corner) {
  return compare_heights(l, corner->vertex, corner->after) == 0 ? TP_PIVOT_FLAT_END
                                                                : TP_PIVOT_FLANK;
}

static tp_pivot_kind kind_of(const tp_contact *contact, const tp_contact_point *p,
                             const tp_base *base, const tp_lattice *l, long ring) {
  if (p->left >= 0 || p->right >= 0) return kind_on_facets(contact, l, p);
  if (p->cut != NULL) return kind_between_roundings(l, p->cut);
  return kind_alone(l, p->point, l->start[1], ring, base->edge_count);
}

static void collect_points(tp_contact *contact, const tp_base *base, const tp_lattice *l,
                           long ring) {
  for (long k = 0; k < contact->facet_count; k++) {
    const tp_facet *f = contact->facets + k;
    const bool single = f->q0 == f->q1;
    tp_contact_point *p = add_point(contact, l, tp_facet_begin(f), -1, single ? -1 : k);
    if (f->rounding != NULL && f->rounding->also.cut != NULL) p->also = &f->rounding->also;
    if (!single) add_point(contact, l, tp_facet_end(f), k, -1);
  }
  for (long k = 0; k < contact->point_count; k++) {
    tp_contact_point *p = contact->points + k;
    p->kind = kind_of(contact, p, base, l, ring);
  }
}

/* Is a direction farther from that of the mean plane than another: its angle 0 to 180 degrees, up
 * or down alike? */
static bool is_steeper(const fmpz_t dx, const fmpz_t dy, const fmpz_t other_dx,
                       const fmpz_t other_dy) {
  fmpz_t a, b;
  fmpz_init(a);
  fmpz_init(b);
  fmpz_abs(a, dy);
  fmpz_mul(a, a, other_dx);
  fmpz_abs(b, other_dy);
  fmpz_mul(b, b, dx);
  const int side = fmpz_cmp(a, b);
  fmpz_clear(a);
  fmpz_clear(b);
  return side > 0;
}

static void find_steepest(tp_contact *contact, const tp_lattice *l) {
  fmpz_t dx, dy, most_dx, most_dy;
  fmpz_init(dx);
  fmpz_init(dy);
  fmpz_init_set_ui(most_dx, 1);
  fmpz_init(most_dy);
  contact->steepest = -1;
  for (long k = 0; k < contact->facet_count; k++) {
    const tp_facet *f = contact->facets + k;
    if (f->q0 == f->q1) continue;
    fmpz_sub(dx, l->x + f->t1, l->x + f->t0);
    fmpz_sub(dy, l->y + f->t1, l->y + f->t0);
    if (contact->steepest >= 0 && !is_steeper(dx, dy, most_dx, most_dy)) continue;
    contact->steepest = k;
    fmpz_swap(most_dx, dx);
    fmpz_swap(most_dy, dy);
  }
  contact->steep =
      contact->steepest >= 0 && (fmpz_sgn(most_dx) <= 0 || fmpz_cmpabs(most_dy, most_dx) > 0);
  fmpz_clear(dx);
  fmpz_clear(dy);
  fmpz_clear(most_dx);
  fmpz_clear(most_dy);
}

/* What to do where nothing touches: rounding may have taken it all. */
static tp_status fail_apart(bool cut, const tp_section *section, const tp_base *base,
                            const tp_lattice *lattice, tp_message *message) {
  const tp_place place = tp_polyline_place(&base->ring, -1);
  if (cut) {
    return tp_refuse(
        message, TP_FAULT_GEOMETRY, place,
        "the block would touch its base with only corners that are rounded off; let it "
        "rest on what rounding leaves of its edges");
  }
  tp_closeness near;
  tp_near_miss miss = {.count = 0};
  char nearest[200] = "";
  tp_closeness_init(&near, section, base, lattice);
  if (!tp_near_miss_find(&miss, &near, true)) return tp_fail_memory(message, "the contact");
  if (miss.count > 0) tp_near_miss_text(nearest, sizeof nearest, &miss, &near);
  return tp_refuse(message, TP_FAULT_GEOMETRY, place,
                   "the block does not touch its base anywhere%s%s; both are given in the same "
                   "coordinates, and contact is exact: give them the same vertices, or say 'place: "
                   "rest', or 'contact: {within: …}'",
                   miss.count > 0 ? ": at the nearest " : "", nearest);
}

/* Neighbouring facets share their ends: about half of the room for points is left. */
static void give_back_rest(tp_contact *contact) {
  const size_t size = (size_t)contact->point_count * sizeof *contact->points;
  tp_contact_point *points = size > 0 ? realloc(contact->points, size) : NULL;
  if (points != NULL) contact->points = points;
}

tp_status tp_contact_init(tp_contact *contact, const tp_section *section, const tp_corners *corners,
                          const tp_base *base, const tp_lattice *lattice, tp_message *message) {
  memset(contact, 0, sizeof *contact);
  tp_facets facets = {0};
  const long ring = lattice->start[section->ring_count];
  tp_status status = base->mated ? tp_facets_of_mated(&facets, section, base, lattice, message)
                                 : tp_facets_of_profile(&facets, section, base, lattice, message);
  const bool touches = facets.count > 0;
  if (!tp_facets_cut(&facets, corners, lattice, lattice->start[1]) && status == TP_OK) {
    status = tp_fail_memory(message, "the contact");
  }
  if (status == TP_OK && facets.count == 0) {
    status = fail_apart(touches, section, base, lattice, message);
  }
  contact->facets = facets.items;
  contact->facet_count = facets.count;
  if (status == TP_OK) {
    contact->points = calloc(2 * (size_t)facets.count + 1, sizeof *contact->points);
  }
  if (contact->points != NULL) {
    collect_points(contact, base, lattice, ring);
    give_back_rest(contact);
    find_steepest(contact, lattice);
    return TP_OK;
  }
  tp_contact_clear(contact);
  return status != TP_OK ? status : tp_fail_memory(message, "the contact");
}

bool tp_contact_restrains(const tp_contact *contact) {
  for (long k = 0; k < contact->facet_count; k++) {
    if (contact->facets[k].t0 != contact->facets[k].t1) return true;
  }
  return false;
}

bool tp_contact_is_free_to_slip(const tp_contact *contact, const tp_lattice *lattice) {
  const tp_facet *first = NULL;
  for (long k = 0; k < contact->facet_count; k++) {
    const tp_facet *f = contact->facets + k;
    if (f->t0 == f->t1) continue;
    if (first == NULL) first = f;
    if (tp_lattice_cross(lattice, first->t0, first->t1, f->t0, f->t1) != 0 ||
        tp_lattice_dot(lattice, first->t0, first->t1, f->t0, f->t1) < 0) {
      return false;
    }
  }
  return first != NULL;
}
