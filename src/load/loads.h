/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The loads of a scene, one file each. Every one is a wrench in the frame of load/wrench.h. */

#ifndef TP_LOADS_H
#define TP_LOADS_H

#include "load/setting.h"
#include "load/wrench.h"

typedef enum tp_load_kind {
  TP_LOAD_WEIGHT,
  TP_LOAD_SEISMIC,
  TP_LOAD_WATER,
  TP_LOAD_UPLIFT,
  TP_LOAD_PRESSURE,
  TP_LOAD_SURCHARGE,
  TP_LOAD_ANCHOR
} tp_load_kind;

/* One load: `active` takes its moment from those that overturn, `passive` adds it to those that
 * stabilise; any other is on the side that its sign says. */
typedef struct tp_load {
  tp_load_kind kind;
  tp_place place;
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

/* The loads, added to a wrench. */
void tp_load_weight(tp_wrench *wrench, const tp_load_setting *setting);
void tp_load_seismic(tp_wrench *wrench, const tp_load_setting *setting);
void tp_load_water(tp_wrench *wrench, const tp_load_setting *setting);
void tp_load_uplift(tp_wrench *wrench, const tp_load_setting *setting);
void tp_load_pressure(tp_wrench *wrench, const tp_line_load *load, const tp_load_setting *setting);
void tp_load_surcharge(tp_wrench *wrench, const tp_line_load *load, const tp_load_setting *setting);
void tp_load_anchor(tp_wrench *wrench, const tp_anchor_description *anchor,
                    const tp_load_setting *setting);

#endif
