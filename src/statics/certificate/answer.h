/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A limit with its mechanism: the tilt as a ball, the face of the cone of forces through which the
 * loads leave it there, its twist, and the two forces that still hold. What is proven, and by whom,
 * is in certificate/prove.h, extremes.h and bracket.h. */

#ifndef TP_CERTIFICATE_ANSWER_H
#define TP_CERTIFICATE_ANSWER_H

#include "certificate/face.h"
#include "certificate/question.h"
#include "topple.h"

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

#endif
