/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The linear program of the static limit in symbols (linear_program/cones.h says the same in
 * numbers): the columns of all contact points, and what follows from the two of an optimal basis.
 */

#ifndef TP_DERIVE_LIMIT_FORMULAS_H
#define TP_DERIVE_LIMIT_FORMULAS_H

#include "derive/model.h"

/* A force along an edge of a friction cone: its components and its moment about the origin; x
 * mirrored towards the right. */
typedef struct tp_force_formulas {
  fmpz_mpoly_q_t x, y, moment;
} tp_force_formulas;

/* A contact point and the direction t of its facet; x mirrored towards the right, t reversed there,
 * so that it points up-dip. */
typedef struct tp_contact_formulas {
  fmpz_mpoly_q_t x, y, tx, ty;
} tp_contact_formulas;

/* Two columns of an optimal basis, the twist (v_x, v_y, omega) normal to both, and the direction of
 * the limit, tan(alpha) = sine / cosine. */
typedef struct tp_limit_formulas {
  const tp_model *model;
  tp_direction towards;
  long friction; /* the symbol tan(phi) */
  tp_force_formulas basis[2];
  fmpz_mpoly_q_t twist[3];
  fmpz_mpoly_q_t sine, cosine;
} tp_limit_formulas;

/* An edge of a cone of the contact. */
typedef struct tp_cone_edge {
  size_t facet;
  bool at_right_end, against_slip;
} tp_cone_edge;

TP_MUST_USE tp_status tp_limit_formulas_init(tp_limit_formulas *formulas, const tp_model *model,
                                             tp_direction towards, long friction,
                                             const tp_cone_edge basis[2], tp_message *message);
void tp_limit_formulas_clear(tp_limit_formulas *formulas);

void tp_force_formulas_init(tp_force_formulas *force, const tp_field *field);
void tp_force_formulas_clear(tp_force_formulas *force, const tp_field *field);

void tp_contact_formulas_init(tp_contact_formulas *contact, const tp_field *field);
void tp_contact_formulas_clear(tp_contact_formulas *contact, const tp_field *field);

/* An end of a facet of the contact; false where it has no formula. */
bool tp_contact_formulas_set(tp_contact_formulas *contact, const tp_model *model,
                             tp_direction towards, size_t facet, bool at_right_end);

/* The column of an edge of the cone there; `friction` is the symbol tan(phi). */
void tp_force_formulas_at(tp_force_formulas *force, const tp_contact_formulas *contact,
                          long friction, bool against_slip, const tp_field *field);

/* The column of an edge; false where its facet has no formula. */
bool tp_force_formulas_set(tp_force_formulas *force, const tp_limit_formulas *formulas,
                           const tp_cone_edge *edge);

/* Its power on the twist, not below zero where the basis is optimal. */
void tp_limit_formulas_power(fmpz_mpoly_q_t power, const tp_limit_formulas *formulas,
                             const tp_force_formulas *force);

/* The factors on both columns at the limit, times cos(alpha) / weight: not below zero either. */
void tp_limit_formulas_factors(fmpz_mpoly_q_t factors[2], const tp_limit_formulas *formulas);

#endif
