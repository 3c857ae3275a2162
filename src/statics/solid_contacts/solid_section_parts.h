/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What a section (solid_section.h) is made of, and vectors of three rationals. */

#ifndef TP_SOLID_CONTACTS_SOLID_SECTION_PARTS_H
#define TP_SOLID_CONTACTS_SOLID_SECTION_PARTS_H

#include "topple_basics.h"

#include <flint/fmpq.h>

enum { TP_SOLID_SECTION_CONTACTS = 32 };

/* Wrenches (F . u, F . (axis x u), M . axis) of a contact; also rows over accelerations. */
typedef struct tp_solid_section_contact {
  fmpq normal[3], slip[3]; /* of n and of axis x n */
  fmpq at[2];              /* along u and axis x u */
  fmpq friction;           /* tan(phi) over |axis| */
  int sides;               /* bits: 1 for a partner on the one side of the centroid, 2 the other */
} tp_solid_section_contact;

/* The edge n + slip tan(phi) t of a contact's force. */
typedef struct tp_solid_section_force {
  int contact, slip;
} tp_solid_section_force;

typedef struct tp_solid_section_mode {
  int ray_count, rays[2];
  int force_count;
  tp_solid_section_force forces[2 * TP_SOLID_SECTION_CONTACTS];
} tp_solid_section_mode;

/* An acceleration (v along u and axis x u, omega) that no contact stops, and M times it. */
typedef struct tp_solid_section_ray {
  fmpq twist[3], wrench[3];
} tp_solid_section_ray;

typedef struct tp_solid_section {
  fmpq axis[3], along[2][3]; /* u and axis x u */
  fmpq mass[3];              /* diagonal of M, per mass */
  int count;
  tp_solid_section_contact contacts[TP_SOLID_SECTION_CONTACTS];
  long ray_count, ray_room;
  tp_solid_section_ray *rays;
  long mode_count, mode_room;
  tp_solid_section_mode *modes;
} tp_solid_section;

void tp_rational3_init(fmpq v[3]);
void tp_rational3_clear(fmpq v[3]);
void tp_rational3_set(fmpq v[3], const fmpq from[3]);
void tp_rational3_cross(fmpq product[3], const fmpq a[3], const fmpq b[3]); /* none of both */
void tp_rational3_dot(fmpq_t product, const fmpq a[3], const fmpq b[3]);
int tp_rational3_sign(const fmpq a[3], const fmpq b[3]); /* of the product */
bool tp_rational3_is_zero(const fmpq v[3]);

#endif
