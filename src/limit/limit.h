/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The static limit: the tilt beyond which no forces of the base hold the block (docs/mechanics.md
 * section 6), by one linear program where the loads turn with the tilt as the weight does, and by a
 * search in the tilt where some of them do not. */

#ifndef TP_LIMIT_H
#define TP_LIMIT_H

#include "limit/face.h"
#include "load/wrench.h"
#include "number/work.h"
#include "topple.h"

/* A question: cones, loads as functions of the tilt, and how far the tilt may go (degrees, where
 * loads have terms in 1 / cos; exact). */
typedef struct tp_limit_question {
  const tp_cones *cones;
  struct tp_sketch *sketch; /* of these cones, where it is made already; else NULL */
  const tp_wrench *load;
  double range_deg;
  tp_judge judge;
  tp_work *work;        /* what its proofs may take, and have taken; NULL: anything */
  bool without_doubles; /* by a program of all columns at full precision from the start */
} tp_limit_question;

typedef struct tp_limit_answer {
  tp_limit_kind kind;
  arb_t sine, cosine; /* of the limit, times any positive factor where no load is fixed */
  arb_t degrees;
  bool bracketed;     /* proven as held at the lower end of `degrees` and not at the upper one */
  bool adds_friction; /* `degrees` is this inclination and the friction angle added: */
  arb_t inclination;
  tp_face face;
  bool tie; /* `other` is the mechanism at the same limit */
  tp_face other;
  long violated;        /* a column against which the last face tried is not admissible, or -1 */
  arb_struct forces[2]; /* factors on the columns of `face` */
} tp_limit_answer;

bool tp_limit_answer_init(tp_limit_answer *answer, const tp_cones *cones);
void tp_limit_answer_clear(tp_limit_answer *answer);

typedef enum tp_limit_outcome {
  TP_LIMIT_PROVEN,
  TP_LIMIT_OPEN, /* more bits are needed */
  TP_LIMIT_OUT_OF_MEMORY,
  TP_LIMIT_FAILED /* the exact solver did */
} tp_limit_outcome;

TP_MUST_USE tp_limit_outcome tp_limit_find(tp_limit_answer *answer,
                                           const tp_limit_question *question);

#endif
