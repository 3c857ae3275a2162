/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Messages and motions of a solid on its contacts. */

#include "solid_tilt/contact_work.h"

#include "solid_tilt/contact_motion.h"

tp_status tp_contacts_fail_memory(const tp_contact_work *w) {
  return tp_fail_memory(w->message, "the contacts of a solid");
}

void tp_contacts_motion(tp_solid_motion *motion, const tp_contact_work *w,
                        const double twist[TP_WRENCH]) {
  tp_contact_motion(motion, &w->points, w->surface, w->given->metres_per_unit, twist);
}

tp_solid_section_inertia tp_contacts_inertia(const tp_contact_work *w) {
  tp_solid_section_inertia inertia;
  for (int k = 0; k < 6; k++) inertia.second[k] = tp_surface_nearest(w->points.inertia + k);
  return inertia;
}
