/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Numbers and points that a program gives, as exact rationals.
 *
 * A double is m 2^e with whole m and e, and is taken as that. A text is a decimal or a fraction of
 * decimals (number/ratio.h). What is no number, or no finite one, is refused. */

#ifndef TP_SCENE_EXACT_H
#define TP_SCENE_EXACT_H

#include "plane/polyline.h"

/* `name` is the argument, `call` the public call that has it. */
TP_MUST_USE tp_status tp_exact_read(fmpq_t value, tp_exact given, const char *name,
                                    const char *call, tp_message *message);

/* `line` stays untouched on failure. Places in it are those of `call`, followed by `number`, where
 * it is above zero, and by the number of the point. */
TP_MUST_USE tp_status tp_coordinates_read(tp_polyline *line, tp_coordinates given, bool closed,
                                          const char *name, const char *call, long number,
                                          tp_message *message);

#endif
