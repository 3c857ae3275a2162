/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Triples of balls: a force with its moment, or a twist (v_x, v_y, omega) about the origin. Their
 * dot product is a power. */

#ifndef TP_PLANE_VECTOR_H
#define TP_PLANE_VECTOR_H

#include "number/judge.h"
#include "plane/contact_rows.h"

#include <arb.h>

typedef struct tp_vector {
  arb_struct of[3];
} tp_vector;

void tp_vector_init(tp_vector *v);
void tp_vector_clear(tp_vector *v);
void tp_vector_cross(tp_vector *product, const tp_vector *a, const tp_vector *b, long bits);
void tp_vector_dot(arb_t product, const tp_vector *a, const tp_vector *b, long bits);
void tp_vector_neg(tp_vector *v);

/* An upper bound of log2 of the largest entry. */
double tp_vector_log2_size(const tp_vector *v);

/* The sign by the judge of what is made of products of the entries of two. */
int tp_vector_judge(const tp_judge *judge, const arb_t of, const tp_vector *a, const tp_vector *b);

#endif
