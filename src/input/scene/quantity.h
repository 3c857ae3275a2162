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

#endif
