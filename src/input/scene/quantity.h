/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A number of a scene as an exact rational with the place that gave it. */

#ifndef TP_SCENE_QUANTITY_H
#define TP_SCENE_QUANTITY_H

#include "common/message.h"

#include <flint/fmpq.h>

/* A quantity that a scene may give. */
typedef struct tp_quantity {
  bool given;
  fmpq_t value;
  tp_place place;
} tp_quantity;

/* Both have their value initialised. */
static inline void tp_quantity_copy(tp_quantity *copy, const tp_quantity *quantity) {
  copy->given = quantity->given;
  copy->place = quantity->place;
  fmpq_set(copy->value, quantity->value);
}

#endif
