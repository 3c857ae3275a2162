/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Rules of the derived quantities; what each is stands in quantities.c. `run` is a second value
 * where the quantity is a direction, and scratch otherwise. */

#ifndef TP_VERIFY_QUANTITY_RULES_H
#define TP_VERIFY_QUANTITY_RULES_H

#include "verify/subject.h"

#define TP_QUANTITY_RULE(name)                                                                     \
  tp_status name(fmpz_mpoly_q_t value, fmpz_mpoly_q_t run, tp_subject *s, tp_message *message)

/* arm_quantities.c */
TP_QUANTITY_RULE(tp_quantity_area);
TP_QUANTITY_RULE(tp_quantity_critical_angle);
TP_QUANTITY_RULE(tp_quantity_y_arm);
TP_QUANTITY_RULE(tp_quantity_fos);
TP_QUANTITY_RULE(tp_quantity_rounding_length);
TP_QUANTITY_RULE(tp_quantity_corner_radius);
TP_QUANTITY_RULE(tp_quantity_mean_height);

/* moment_quantities.c */
TP_QUANTITY_RULE(tp_quantity_fos_elements);
TP_QUANTITY_RULE(tp_quantity_stabilising);
TP_QUANTITY_RULE(tp_quantity_overturning);
TP_QUANTITY_RULE(tp_quantity_stabilising_area);
TP_QUANTITY_RULE(tp_quantity_overturning_area);

/* base_quantities.c */
TP_QUANTITY_RULE(tp_quantity_facet_angle);
TP_QUANTITY_RULE(tp_quantity_mean_square_slope);
TP_QUANTITY_RULE(tp_quantity_block_width);
TP_QUANTITY_RULE(tp_quantity_amplitude);

/* Moments x, y of a weight about the sharp corner, brought to the axis where rounding puts it. */
TP_MUST_USE tp_status tp_quantity_shift(fmpz_mpoly_q_t x, fmpz_mpoly_q_t y,
                                        const fmpz_mpoly_q_t weight, const tp_subject *s,
                                        tp_message *message);

/* Set the weights of the elements to their areas at the scene's values; false when memory is
 * exhausted. */
TP_MUST_USE bool tp_quantity_example_weights(tp_subject *s);

#endif
