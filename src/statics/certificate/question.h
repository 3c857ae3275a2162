/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What is asked of the linear program of contact forces, and the loads in it as wrenches. */

#ifndef TP_CERTIFICATE_QUESTION_H
#define TP_CERTIFICATE_QUESTION_H

#include "linear_program/cones.h"
#include "load/wrench.h"
#include "number/judge.h"
#include "number/work.h"
#include "plane/vector.h"

/* A question: cones, loads as functions of the tilt, and how far the tilt may go (degrees, where
 * loads have terms in 1 / cos; exact). */
typedef struct tp_limit_question {
  const tp_cones *cones;
  struct tp_scaled *scaled; /* of these cones, where it is made already; else NULL */
  const tp_wrench *load;
  double range_deg;
  tp_judge judge;
  tp_work *work;        /* what its proofs may take, and have taken; NULL: anything */
  bool without_forces;  /* only where the limit lies and what moves: not how large its forces are */
  bool without_doubles; /* by a program of all columns at full precision from the start */
} tp_limit_question;

/* Do all loads turn with the tilt, with no bounded force in play: is the limit one linear program
 * in tan(tilt)? */
bool tp_question_is_linear(const tp_limit_question *question);

/* The share of the loads that goes with one function of the tilt, and the loads at a tilt. */
void tp_question_load_term(tp_vector *term, const tp_wrench *load, int basis);
void tp_question_load_at(tp_vector *wrench, const tp_wrench *load, const arb_t sine,
                         const arb_t cosine, long bits);
void tp_question_load_at_degrees(tp_vector *wrench, const tp_limit_question *question,
                                 const arb_t degrees);

#endif
