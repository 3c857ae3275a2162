/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Refuses Barton's law (Eq. 8) where all facets are upright or points and no contact width is
 * given: the mean normal stress has no area then. */

#include "problem/contact_width.h"

tp_status tp_contact_width_check(const tp_contact *contact, const tp_lattice *l,
                                 const tp_scene *scene, tp_message *message) {
  if (!scene->friction.load_dependent || scene->friction.contact_width.given) return TP_OK;
  for (long k = 0; k < contact->facet_count; k++) {
    const tp_facet *f = contact->facets + k;
    if (!fmpz_equal(l->x + f->q0, l->x + f->q1)) return TP_OK;
  }
  return tp_refuse(message, TP_FAULT_GEOMETRY, scene->friction_angle_deg.place,
                   "the block touches its base in points or upright faces alone, on which the law "
                   "barton finds no mean normal stress: say how wide the contact is along the mean "
                   "plane, 'contact: {width: …}' in %s, or give a 'friction_angle_deg'",
                   scene->length_unit);
}
