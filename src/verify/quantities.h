/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Rules of the derived quantities; what each is stands in quantities.c. `run` is a second value
 * where the quantity is a direction, and scratch otherwise. */

#ifndef TP_QUANTITIES_H
#define TP_QUANTITIES_H

#include "verify/subject.h"

#define TP_QUANTITY_RULE(name)                                                                     \
  tp_status name(fmpz_mpoly_q_t value, fmpz_mpoly_q_t run, tp_subject *s, tp_message *message)

TP_QUANTITY_RULE(tp_quantity_fos_elements);
TP_QUANTITY_RULE(tp_quantity_stabilising);
TP_QUANTITY_RULE(tp_quantity_overturning);
TP_QUANTITY_RULE(tp_quantity_stabilising_area);
TP_QUANTITY_RULE(tp_quantity_overturning_area);
TP_QUANTITY_RULE(tp_quantity_facet_angle);
TP_QUANTITY_RULE(tp_quantity_mean_square_slope);
TP_QUANTITY_RULE(tp_quantity_block_width);
TP_QUANTITY_RULE(tp_quantity_amplitude);

/* A quantity that this block does not have. */
tp_status tp_quantity_fail(const tp_subject *s, tp_message *message, const char *problem);

/* Values for symbols that nothing else gives one, for examples of what a formula comes to: weights
 * are areas, r is a fiftieth of the block's width, alpha 20 degrees, i 10 without a block. False
 * when memory is exhausted. */
TP_MUST_USE bool tp_quantities_example_values(tp_subject *s);

/* Moments x, y of a weight about the sharp corner, brought to the axis where rounding puts it. */
TP_MUST_USE tp_status tp_quantity_shift(fmpz_mpoly_q_t x, fmpz_mpoly_q_t y,
                                        const fmpz_mpoly_q_t weight, const tp_subject *s,
                                        tp_message *message);

#endif
