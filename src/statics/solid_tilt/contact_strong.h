/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Can a motion of a solid on contact points begin? That forces hold it is not enough: friction of
 * contacts that face different ways is not always there (docs/mechanics.md, "Onset of motion").
 *
 * Contacts of one direction and one friction, no two of which are on a line within the cones of
 * both, are taken as a plane: there what forces hold stays, where contact_plane.h proves it.
 * Contacts and loads that have a section (solid_contacts/solid_section.h) are decided in it. Else a
 * load that is held without any friction f moves nothing, as a . M a <= w . a = -f . a <= 0 for
 * every acceleration a that no contact stops; and on few contacts all their modes are excluded in
 * three dimensions (contact_exclusion.h). A load that no forces hold moves the solid. On points of
 * one line it is balanced at best. */

#ifndef TP_SOLID_TILT_CONTACT_STRONG_H
#define TP_SOLID_TILT_CONTACT_STRONG_H

#include "solid_tilt/contact_work.h"
#include "solid_tilt/solid_safety.h"

typedef struct tp_strong_side {
  bool is_on_line, is_plane, has_section;
  bool is_proven_plane;     /* if is_plane: contact_plane.h knows it as one */
  bool is_held;             /* in the state that was last asked for */
  tp_solid_section section; /* if has_section */
  tp_friction_cones smooth; /* the same points without friction; what they point to is borrowed */
  tp_hold without;          /* on these */
} tp_strong_side;

/* To be cleared also where it is false: memory is exhausted. */
TP_MUST_USE bool tp_contact_strong_init(tp_strong_side *strong, const tp_contact_work *work);
void tp_contact_strong_clear(tp_strong_side *strong);

/* Verdict and factors of a state. */
TP_MUST_USE bool tp_contact_strong_find(tp_state_ranges *state, tp_strong_side *strong,
                                        const tp_contact_work *work, const tp_weak_side *weak);

/* From which tilt and acceleration on a motion can begin, or up to which tilt none can, into the
 * results. */
TP_MUST_USE bool tp_contact_strong_onsets(const tp_strong_side *strong, tp_contact_work *work);

#endif
