/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Accelerations M^-1 of a unit of a reaction, of each of its two blocks that is not at rest; in
 * doubles. */

#ifndef TP_CONTACT_MODES_PUSHED_H
#define TP_CONTACT_MODES_PUSHED_H

#include "contact_modes/reactions.h"

typedef struct tp_pushed {
  long row[2]; /* -1: it is at rest */
  double y[2][3];
} tp_pushed;

tp_pushed tp_pushed_by(const tp_bearing_reaction *reaction, const tp_modes_node *node,
                       const tp_resting *resting);

/* What a row of a contact gives of them, and loads by row. */
double tp_pushed_along(const tp_pushed *pushed, const tp_force_column *column);
double tp_pushed_power(const tp_pushed *pushed, const tp_near *loads);

#endif
