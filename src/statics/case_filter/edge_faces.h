/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Edges of friction cones, and the faces that two of them span, in doubles with bounds. */

#ifndef TP_CASE_FILTER_EDGE_FACES_H
#define TP_CASE_FILTER_EDGE_FACES_H

#include "case_filter/capacities.h"

enum { TP_FILTER_EDGES = 2 * TP_PLAN_POINTS };

/* The edges of the plan with a friction. */
typedef struct tp_edge_set {
  const tp_contact_plan *plan;
  const tp_case_shape *shape;
  const tp_contact_rest *rest;
  const tp_filter_loads *loads;
  const tp_filter_capacities *capacities;
  tp_near friction;
  tp_near of[TP_FILTER_EDGES][3];
} tp_edge_set;

void tp_edge_set_init(tp_edge_set *set, const tp_filter_case *of);

/* Do two pass through one point of contact? Does a third lie in their face, by construction? */
bool tp_edges_meet(const tp_edge_set *set, int i, int j);
bool tp_edges_hold_third(const tp_edge_set *set, int i, int j, int third);

/* How the block goes that two edges do not resist, and the twist, either way. */
tp_mechanism tp_edges_mechanism(const tp_edge_set *set, int i, int j);
void tp_edges_twist(tp_near v[3], const tp_edge_set *set, int i, int j);

/* b = f_i e_i + f_j e_j with both above zero, for certain, of what lies in the face. */
bool tp_edges_press(const tp_near e_i[3], const tp_near e_j[3], const tp_near b[3]);

/* b = f_i e_i + f_j e_j + f_k e_k with all above zero, for certain, of some three edges. */
bool tp_edges_bear(const tp_edge_set *set, const tp_near b[3]);

#endif
