/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The static limit of a case, in doubles with bounds: searched in doubles, and
 * then proven as certificate/face.h does, by a mechanism that no edge of a friction cone resists
 * and by forces that hold. */

#ifndef TP_CASE_FILTER_LIMIT_FILTER_H
#define TP_CASE_FILTER_LIMIT_FILTER_H

#include "case_filter/edge_faces.h"

typedef struct tp_limit_filter {
  tp_near value; /* the tangent of the limit */
  tp_mechanism mechanism;
} tp_limit_filter;

/* The tangent of the limit, of a block that holds up to there and has one. False where doubles do
 * not tell. */
bool tp_limit_filter_find(tp_limit_filter *found, const tp_edge_set *set);

/* Do some forces hold it at the tilt? True where that is proven. */
bool tp_limit_filter_holds(const tp_edge_set *set, tp_near tangent);

/* Likewise on level ground and at all tilts from there up to one at which some do. */
bool tp_limit_filter_holds_to(const tp_edge_set *set, tp_near tangent);

#endif
