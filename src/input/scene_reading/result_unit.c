/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Look-up of units by kind and name in units_table.h, the key result_units, and the call that sets
 * one. */

#include "scene_reading/result_unit.h"

#include "common/host.h"
#include "common/outside.h"
#include "scene/units_table.h"
#include "scene_building/build.h"
#include "scene_reading/read.h"

#include <stdio.h>
#include <string.h>

/* The quotient is rounded once, as both are whole numbers that a double holds. */
#define AS_UNIT(own_kind, own_name, numerator, denominator)                                        \
  {TP_UNIT_##own_kind, own_name, (double)(numerator) / (double)(denominator)},
static const tp_unit units[] = {TP_RESULT_UNITS(AS_UNIT)};
#undef AS_UNIT
enum { UNITS = sizeof units / sizeof units[0] };

const tp_unit *tp_result_unit_find(tp_unit_kind kind, const char *name) {
  for (int k = 0; k < UNITS; k++) {
    if (units[k].kind == kind && strcmp(units[k].name, name) == 0) return units + k;
  }
  return NULL;
}

const tp_unit *tp_result_unit_named(const char *name) {
  const tp_unit *unit = NULL;
  for (int kind = 0; kind < TP_UNIT_KINDS && unit == NULL; kind++) {
    unit = tp_result_unit_find((tp_unit_kind)kind, name);
  }
  return unit;
}

void tp_result_unit_names(char *list, size_t size, bool all, tp_unit_kind kind) {
  list[0] = '\0';
  for (int k = 0; k < UNITS; k++) {
    const size_t used = strlen(list);
    if (!all && units[k].kind != kind) continue;
    snprintf(list + used, size - used, "%s%s", used > 0 ? ", " : "", units[k].name);
  }
}

static tp_result_unit given(const tp_unit *unit) {
  return unit != NULL ? (tp_result_unit){unit->name, unit->si} : (tp_result_unit){NULL, 1};
}

tp_result_units tp_result_units_of(const tp_scene *scene) {
  const tp_unit *const *own = scene->result_units;
  return (tp_result_units){given(own[TP_UNIT_LENGTH]), given(own[TP_UNIT_FORCE]),
                           given(own[TP_UNIT_MOMENT]), given(own[TP_UNIT_STRESS])};
}

tp_status tp_read_result_units(const tp_reader *reader, const tp_node *node) {
  if (node == NULL) return TP_OK;
  tp_status status = tp_read_keys(reader, node, &tp_key_map_result_units, "result_units");
  for (int kind = 0; kind < TP_UNIT_KINDS && status == TP_OK; kind++) {
    const tp_node *own = tp_node_get(node, tp_key_map_result_units.keys[kind]);
    if (own == NULL) continue;
    const char *name = own->kind == TP_NODE_SCALAR ? own->text : "";
    const tp_unit *unit = tp_result_unit_find((tp_unit_kind)kind, name);
    reader->scene->result_units[kind] = unit;
    if (unit != NULL) continue;
    char list[200];
    tp_result_unit_names(list, sizeof list, false, (tp_unit_kind)kind);
    status = tp_read_fail(reader, TP_FAULT_UNIT, own,
                          "'%s' is not a unit of %s for reports; known are: %s",
                          tp_quote_all(name).text, tp_key_map_result_units.keys[kind], list);
  }
  return status;
}

tp_status tp_scene_set_result_unit(tp_scene *scene, const char *name, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  TP_REFUSE_NULL(message, name);
  tp_build build;
  const tp_status status = tp_build_begin(&build, scene, __func__, message);
  if (status != TP_OK) return status;
  const tp_unit *unit = tp_result_unit_named(name);
  if (unit != NULL) {
    scene->result_units[unit->kind] = unit;
    return TP_OK;
  }
  char list[300];
  tp_result_unit_names(list, sizeof list, true, TP_UNIT_LENGTH);
  return tp_refuse(message, TP_FAULT_UNIT, build.place,
                   "'%s' is not a unit for reports; known are: %s", tp_quote_all(name).text, list);
}
