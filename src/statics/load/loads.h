/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The loads that a scene calls for, in its order. */

#ifndef TP_LOAD_LOADS_H
#define TP_LOAD_LOADS_H

#include "load/setting.h"

typedef enum tp_load_kind {
  TP_LOAD_WEIGHT,
  TP_LOAD_SEISMIC,
  TP_LOAD_WATER,
  TP_LOAD_UPLIFT,
  TP_LOAD_ICE,
  TP_LOAD_PRESSURE,
  TP_LOAD_SURCHARGE,
  TP_LOAD_SUPPORT,
  TP_LOAD_ANCHOR
} tp_load_kind;

/* One load: `active` takes its moment from those that overturn, `passive` adds it to those that
 * stabilise; any other is on the side that its sign says. */
typedef struct tp_load {
  tp_load_kind kind;
  tp_place place;
  const tp_line_load *line;            /* of a pressure, also of a support, or a surcharge */
  const tp_anchor_description *anchor; /* of an anchor: */
  long row;                            /* of its rows, counted from 0 */
  bool active, passive;
  double began; /* by tp_clock_now */
  tp_wrench wrench;
} tp_load;

const char *tp_load_name(tp_load_kind kind);

/* Does the scene call for any load? */
bool tp_loads_are_called_for(const tp_loads_description *loads);

/* How many loads there are, the weight among them, and to fill as many, initialised, in. */
long tp_loads_count(const tp_loads_description *loads);
void tp_loads_evaluate(tp_load *loads, const tp_load_setting *setting);

#endif
