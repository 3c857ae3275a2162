/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A contact on its springs, and what contacts add up to. */

#ifndef TP_CONTACT_SPRINGS_CONTACT_H
#define TP_CONTACT_SPRINGS_CONTACT_H

#include "contact_springs/candidates.h"
#include "rigid_body/drive.h"

typedef struct tp_spring_contact {
  tp_pair pair;
  tp_pair story;  /* the pair as which it closed: it runs along the boundary since */
  tp_meeting now; /* with its tangent, and its lever about the centroid: */
  tp_xy tangent, lever;
  double area;              /* m2 */
  double sheared;           /* of the block along the tangent, elastic, m */
  double friction;          /* tan(phi) */
  double normal_n, shear_n; /* shear: on the block along the tangent */
  double closing_m_s;       /* when it closed */
  double slipped;           /* m, without sign, since it was last observed */
  long facet;
  enum { TP_CONTACT_HOLDS, TP_CONTACT_OPENED, TP_CONTACT_PASSED } state;
} tp_spring_contact;

/* Forces of all contacts on the block, and energies in joule. */
typedef struct tp_spring_forces {
  tp_body_force sum;
  double held;              /* in springs */
  double taken_by_friction; /* in this step, as the next */
  double taken_by_dashpots;
} tp_spring_forces;

#endif
