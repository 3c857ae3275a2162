/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What accuracy costs: one number by several ways at several prices, each timed and compared with
 * the exact value. */

#ifndef TP_ACCURACY_ACCURACY_H
#define TP_ACCURACY_ACCURACY_H

#include "number/ladder.h"

#include <arb.h>

/* An angle in degrees at one price. `*found` is false where it is not known at that price, or not
 * at all. */
typedef tp_status (*tp_priced)(arb_t degrees, bool *found, const void *subject, tp_rung rung);

/* By rising price. */
typedef struct tp_accuracy_prices {
  const tp_rung *rungs;
  size_t count;
} tp_accuracy_prices;

/* Those of a method: all, or few, for a sweep. */
tp_accuracy_prices tp_accuracy_prices_of(tp_accuracy_method method, bool few);

typedef struct tp_accuracy_way {
  tp_accuracy_method method;
  tp_priced evaluate;
  const void *subject;
  tp_level truth_level; /* at which its exact value is found */
  size_t vertices;
  tp_accuracy_prices prices;
} tp_accuracy_way;

/* NULL when memory is exhausted. */
tp_accuracy *tp_accuracy_new(void);

/* Run the way at each of its rungs; nothing is added where it leads to no angle. */
TP_MUST_USE tp_status tp_accuracy_measure(tp_accuracy *accuracy, const tp_accuracy_way *way);

/* Add the runs of some methods for a scene, those of a mask by method that it calls for, at all
 * prices or few. */
TP_MUST_USE tp_status tp_accuracy_add_scene(tp_accuracy *accuracy, const tp_scene *scene,
                                            unsigned methods, bool few, tp_message *message);

#endif
