/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The quantities that a block offers to claims; what each is stands in quantities.c. */

#ifndef TP_VERIFY_QUANTITIES_H
#define TP_VERIFY_QUANTITIES_H

#include "verify/subject.h"

/* Add their names; false when memory is exhausted. */
TP_MUST_USE bool tp_quantities_add(tp_subject *subject);

/* Values for symbols that nothing else gives one, for examples of what a formula comes to: weights
 * are areas, r is a fiftieth of the block's width, alpha 20 degrees, i 10 without a block. False
 * when memory is exhausted. */
TP_MUST_USE bool tp_quantities_example_values(tp_subject *subject);

#endif
