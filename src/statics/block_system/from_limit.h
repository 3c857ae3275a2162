/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Motions from beyond the limit of what forces can hold, where there always is one, followed down;
 * and exclusions of motions, up to the limit. */

#ifndef TP_BLOCK_SYSTEM_FROM_LIMIT_H
#define TP_BLOCK_SYSTEM_FROM_LIMIT_H

#include "block_system/moving.h"
#include "block_system/standing.h"

/* Numbers along which blocks stand or move: from where they lie. */
typedef struct tp_moving_range {
  double from, least, limit, width, step;
} tp_moving_range;

/* Down to `least`. */
TP_MUST_USE tp_status tp_moving_from_limit(tp_moving_search *moving, const tp_moving_range *range,
                                           double least, tp_message *message);

/* The motion that is found followed down as far as it goes; then one from the limit as well: the
 * lesser of both is kept. */
TP_MUST_USE tp_status tp_moving_least(tp_moving_search *moving, const tp_moving_range *range,
                                      tp_message *message);

/* From `range->from`, where no motion can begin: up to where that is proven, at most to the limit
 * or to a motion that is found. */
TP_MUST_USE tp_status tp_standing_to_limit(double *standing, tp_moving_search *moving,
                                           tp_standing_search *search, const tp_moving_range *range,
                                           tp_message *message);

#endif
