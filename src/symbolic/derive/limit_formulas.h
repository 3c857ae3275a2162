/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The linear program of the static limit in symbols (linear_program/cones.h says the same in
 * numbers): the columns of all contact points, and what follows from the two of an optimal basis.
 */

#ifndef TP_DERIVE_LIMIT_FORMULAS_H
#define TP_DERIVE_LIMIT_FORMULAS_H

#include "derive/model.h"
#include "derive/vector_formulas.h"
#include "linear_program/cones.h"

/* A contact point, the end of a facet, and the direction t of that; x mirrored towards the right, t
 * reversed there, so that it points up-dip. */
typedef struct tp_contact_formulas {
  size_t facet;
  bool at_right_end, known; /* it has a formula */
  fmpz_mpoly_q_t x, y, tx, ty;
} tp_contact_formulas;

/* All of a contact in the order of static_limit/limit_cones.h. */
typedef struct tp_contacts_formulas {
  long count;
  tp_contact_formulas *items;
} tp_contacts_formulas;

/* 3 A2 and the sums of formulas.h: the weight and its moments; x6 mirrored towards the right. */
typedef struct tp_weight_formulas {
  fmpz_mpoly_q_t w, x6, y6;
} tp_weight_formulas;

/* Two columns of an optimal basis, the twist (v_x, v_y, omega) normal to both, and the direction of
 * the limit, tan(alpha) = sine / cosine. */
typedef struct tp_limit_formulas {
  const tp_model *model;
  tp_direction towards;
  long friction; /* the symbol tan(phi) */
  tp_contacts_formulas contacts;
  tp_weight_formulas weight;
  tp_cone_edge edges[2];
  tp_vector_formulas basis[2], twist;
  fmpz_mpoly_q_t sine, cosine;
} tp_limit_formulas;

/* Of the edges along which the forces of a limit act; on failure nothing is to be cleared. */
TP_MUST_USE tp_status tp_limit_formulas_init(tp_limit_formulas *formulas, const tp_model *model,
                                             tp_direction towards, long friction,
                                             const tp_reaction forces[2], tp_message *message);
void tp_limit_formulas_clear(tp_limit_formulas *formulas);

/* False when memory is exhausted. */
TP_MUST_USE bool tp_contacts_formulas_init(tp_contacts_formulas *contacts, const tp_model *model,
                                           tp_direction towards);
void tp_contacts_formulas_clear(tp_contacts_formulas *contacts, const tp_field *field);

void tp_weight_formulas_init(tp_weight_formulas *weight, const tp_model *model,
                             tp_direction towards);
void tp_weight_formulas_clear(tp_weight_formulas *weight, const tp_field *field);

/* The column of an edge of the cone there; `friction` is the symbol tan(phi). */
void tp_contact_formulas_edge(tp_vector_formulas *force, const tp_contact_formulas *contact,
                              long friction, bool against, const tp_field *field);

/* The factors on both columns at the limit, times cos(alpha) / weight: not below zero either. */
void tp_limit_formulas_factors(fmpz_mpoly_q_t factors[2], const tp_limit_formulas *formulas);

#endif
