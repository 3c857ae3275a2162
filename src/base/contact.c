/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "base/contact.h"

#include <stdlib.h>
#include <string.h>

void tp_contact_clear(tp_contact *contact) {
  free(contact->facets);
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

static void add_point(tp_contact *contact, const tp_lattice *l, long point, long left, long right) {
  for (long k = contact->point_count - 1; k >= 0 && k >= contact->point_count - 2; k--) {
    tp_contact_point *known = contact->points + k;
    if (!tp_facet_same_point(l, known->point, point)) continue;
    if (left >= 0) known->left = left;
    if (right >= 0) known->right = right;
    return;
  }
  contact->points[contact->point_count++] =
      (tp_contact_point){.point = point, .left = left, .right = right};
}

static void collect_points(tp_contact *contact, const tp_base *base, const tp_lattice *l,
                           long ring) {
  for (long k = 0; k < contact->facet_count; k++) {
    const tp_facet *f = contact->facets + k;
    const bool single = f->q0 == f->q1;
    add_point(contact, l, f->q0, -1, single ? -1 : k);
    if (!single) add_point(contact, l, f->q1, k, -1);
  }
  for (long k = 0; k < contact->point_count; k++) {
    tp_contact_point *p = contact->points + k;
    if (p->left < 0 && p->right < 0) {
      p->kind = kind_alone(l, p->point, l->start[1], ring, base->edge_count);
    } else {
      const long left = p->left >= 0 ? contact->facets[p->left].q0 : p->point;
      const long right = p->right >= 0 ? contact->facets[p->right].q1 : p->point;
      p->kind = kind_between(compare_heights(l, left, p->point),
                             compare_heights(l, right, p->point), p->left >= 0, p->right >= 0);
    }
  }
}

tp_status tp_contact_init(tp_contact *contact, const tp_section *section, const tp_base *base,
                          const tp_lattice *lattice, tp_message *message) {
  memset(contact, 0, sizeof *contact);
  tp_facets facets = {0};
  const long ring = lattice->start[section->ring_count];
  tp_status status = base->mated ? tp_facets_of_mated(&facets, section, base, lattice, message)
                                 : tp_facets_of_profile(&facets, section, base, lattice, message);
  if (status == TP_OK && facets.count == 0) {
    status = tp_fail(message, TP_BAD_INPUT, tp_polyline_place(&base->ring, -1),
                     "the block does not touch its base anywhere; both are given in the same "
                     "coordinates, and contact is exact: give them the same vertices");
  }
  contact->facets = facets.items;
  contact->facet_count = facets.count;
  if (status == TP_OK) {
    contact->points = calloc(2 * (size_t)facets.count + 1, sizeof *contact->points);
  }
  if (contact->points != NULL) {
    collect_points(contact, base, lattice, ring);
    return TP_OK;
  }
  tp_contact_clear(contact);
  return status != TP_OK ? status : tp_fail_memory(message, "the contact");
}
