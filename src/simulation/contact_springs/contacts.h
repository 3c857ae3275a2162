/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Contacts on springs: the length of a facet that each stands for, its normal spring without
 * tension, its shear spring with Coulomb's limit.
 *
 * A contact has the area of its tributary length times the thickness: half of what the facets of
 * the block and of the base that meet there have in common, as distinct elements take it, when it
 * closes; from then on it keeps it, so that its springs hold energy. A contact in a point stands
 * for a hundredth of the block's extent. Normal force k_n A times the overlap; shear force k_s A
 * times the shear displacement since it closed, at most tan(phi) times the normal force. Where they
 * are asked for, dashpots beside both springs resist their rates; the limits hold for the sums. */

#ifndef TP_CONTACT_SPRINGS_CONTACTS_H
#define TP_CONTACT_SPRINGS_CONTACTS_H

#include "contact_springs/candidates.h"
#include "contact_springs/contact.h"
#include "rigid_body/drive.h"

/* A pair that met in this step and was no contact before. */
typedef struct tp_fresh_contact {
  tp_pair pair;
  tp_meeting meeting;
} tp_fresh_contact;

typedef struct tp_spring_contacts {
  tp_features of_block, of_base;
  tp_near_pairs candidates;
  long *holders; /* by candidate: its contact, or -1 */
  long count, room;
  tp_spring_contact *items; /* in the order of their pairs */
  long fresh_count, fresh_room;
  tp_fresh_contact *fresh; /* scratch */
  double normal_pa_m, shear_pa_m, thickness_m, extent_m;
  double grace_m;   /* by which a contact may run past the end of a feature before it goes over */
  double deepest_m; /* no overlap is */
  double least_area_m2;                 /* of a contact in a point */
  double normal_dashpot, shear_dashpot; /* resist a step's displacement by so many springs */
  bool changed;                         /* contacts closed or opened in the last step */
} tp_spring_contacts;

/* Stiffness of the springs of a square metre, and the radius of corners. */
typedef struct tp_spring_stiffness {
  double normal_pa_m, shear_pa_m, rounding_m;
} tp_spring_stiffness;

TP_MUST_USE bool tp_spring_contacts_init(tp_spring_contacts *contacts, const tp_rigid_body *body,
                                         tp_spring_stiffness stiffness);
void tp_spring_contacts_clear(tp_spring_contacts *contacts);

/* The contacts of a new state, which came from the one before by a displacement and a turn. False
 * when memory is exhausted. */
TP_MUST_USE bool tp_spring_contacts_step(tp_spring_forces *forces, tp_spring_contacts *contacts,
                                         const tp_body_state *state, tp_xy displaced,
                                         double turned);

/* Of a contact in a point. */
double tp_spring_least_area(const tp_rigid_body *body);

/* Forget all contacts. */
void tp_spring_contacts_forget(tp_spring_contacts *contacts);

/* The stiffness about the centroid that bounds the highest frequency: the sum of (k_n + k_s) A of
 * all contacts, and of it times the square of the lever. */
void tp_spring_contacts_stiffness(double *straight_n_m, double *turning_nm,
                                  const tp_spring_contacts *contacts);

#endif
