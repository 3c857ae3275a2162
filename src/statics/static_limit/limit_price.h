/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The static limit alone, at one price: what accuracy costs there. */

#ifndef TP_STATIC_LIMIT_LIMIT_PRICE_H
#define TP_STATIC_LIMIT_LIMIT_PRICE_H

#include "evaluation/evaluation.h"

typedef enum tp_limit_price {
  TP_LIMIT_IN_DOUBLES, /* the simplex method in doubles: no bound */
  TP_LIMIT_CERTIFIED,  /* what that finds, proven in balls of the rung's bits */
  TP_LIMIT_EXACTLY     /* the program of all columns in rationals, then the same proof */
} tp_limit_price;

/* In degrees, for the scene's own base; `*found` is false where there is no such angle, where the
 * bits do not prove it, and for friction that depends on the load, whose limit is no single one.
 * TP_OUT_OF_MEMORY; TP_DEPENDENCY_FAILED where the exact solver did. */
TP_MUST_USE tp_status tp_evaluate_limit_at_price(arb_t degrees, bool *found,
                                                 const tp_evaluation *evaluation,
                                                 tp_direction towards, tp_limit_price price);

#endif
