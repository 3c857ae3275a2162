/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The onset of motion alone, at one price: what accuracy costs there. */

#ifndef TP_ONSET_ONSET_PRICE_H
#define TP_ONSET_ONSET_PRICE_H

#include "evaluation/evaluation.h"

/* In degrees; `*found` is false where there is no such angle, where the bits leave the order of two
 * tilts open, where the proof is too dear, under cohesion or bonds, with which the limit comes in,
 * and for friction that depends on the load, whose onset is no single one. */
TP_MUST_USE tp_status tp_evaluate_onset_at_price(arb_t degrees, bool *found,
                                                 const tp_evaluation *evaluation,
                                                 tp_direction towards);

#endif
