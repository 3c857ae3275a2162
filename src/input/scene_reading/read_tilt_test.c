/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Reads the key tilt_test of a scene: engine, protocol, numbers of the test and locked-in
 * tractions. */

#include "scene/check_tilt_test.h"
#include "scene_reading/read.h"

#include <stdlib.h>
#include <string.h>

static const char *text_of(const tp_node *node) {
  return node != NULL && node->kind == TP_NODE_SCALAR ? node->text : "";
}

/* engine and method. */
static tp_status read_engine(const tp_reader *reader, const tp_node *node) {
  tp_tilt_test_description *test = &reader->scene->tilt_test;
  const tp_node *engine = tp_node_get(node, "engine"), *method = tp_node_get(node, "method");
  const bool path = strcmp(text_of(engine), "path") == 0,
             dynamics = strcmp(text_of(engine), "dynamics") == 0;
  const bool events = strcmp(text_of(method), "events") == 0,
             springs = strcmp(text_of(method), "springs") == 0;
  if (engine != NULL && !path && !dynamics) {
    return tp_read_fail(reader, TP_FAULT_KEY, engine,
                        "engine must be path (quasi-static, from event to event) or dynamics");
  }
  if (method != NULL && !events && !springs) {
    return tp_read_fail(reader, TP_FAULT_KEY, method,
                        "method must be events (a rigid block on rigid contacts) or springs");
  }
  if (method != NULL && !dynamics) {
    return tp_read_fail(reader, TP_FAULT_KEY, method, "a method belongs to 'engine: dynamics'");
  }
  if (engine == NULL) return TP_OK;
  test->engine = path ? TP_TILT_PATH : springs ? TP_TILT_SPRINGS : TP_TILT_RIGID;
  test->engine_place = tp_node_place(engine, reader->scene->path);
  return TP_OK;
}

static tp_status read_protocol(const tp_reader *reader, const tp_node *node) {
  static const char *const names[] = {"ramp", "steps", "release"};
  tp_tilt_test_description *test = &reader->scene->tilt_test;
  const tp_node *protocol = tp_node_get(node, "protocol"), *start = tp_node_get(node, "start");
  if (protocol != NULL) {
    int found = 0;
    while (found < 3 && strcmp(text_of(protocol), names[found]) != 0) found++;
    if (found == 3) {
      return tp_read_fail(reader, TP_FAULT_KEY, protocol,
                          "protocol must be ramp (at a speed), steps (a fresh start at each angle) "
                          "or release (held at the tilt, then released)");
    }
    test->protocol = (tp_tilt_protocol)found;
    test->protocol_place = tp_node_place(protocol, reader->scene->path);
  }
  if (start == NULL) return TP_OK;
  test->set_down = strcmp(text_of(start), "set_down") == 0;
  test->start_place = tp_node_place(start, reader->scene->path);
  if (test->set_down || strcmp(text_of(start), "level") == 0) return TP_OK;
  return tp_read_fail(reader, TP_FAULT_KEY, start,
                      "start must be level (placed level, and tilted) or set_down (at the angle)");
}

static tp_status read_traction(const tp_reader *reader, tp_traction_description *own,
                               const tp_node *node) {
  own->place = tp_read_place(reader, node);
  tp_status status = tp_read_keys(reader, node, &tp_key_map_tilt_test_tractions, "tractions");
  if (status != TP_OK) return status;
  const tp_node *facet = tp_node_get(node, "facet"), *normal = tp_node_get(node, "normal_kpa");
  const tp_node *shear = tp_node_get(node, "shear_kpa");
  if (facet == NULL || normal == NULL || shear == NULL) {
    return tp_read_fail(reader, TP_FAULT_FORMAT, node,
                        "stress locked in on a facet is {facet: 1, normal_kpa: [20, 10], "
                        "shear_kpa: 5}: normal at its left end and its right one, shear above 0 "
                        "where it pushes the block to the right");
  }
  status = tp_read_facet_number(reader, &own->facet, facet);
  if (status == TP_OK) {
    status = tp_read_point(reader, &own->first_kpa, &own->last_kpa, normal, "normal_kpa");
  }
  return status == TP_OK
             ? tp_read_quantity(reader, &own->shear_kpa, shear, "shear_kpa", TP_RULE_ANY)
             : status;
}

static tp_status read_tractions(const tp_reader *reader, const tp_node *node) {
  tp_tilt_test_description *test = &reader->scene->tilt_test;
  if (node == NULL) return TP_OK;
  if (node->kind != TP_NODE_SEQUENCE || node->count == 0) {
    return tp_read_fail(reader, TP_FAULT_FORMAT, node,
                        "tractions are a list of {facet: 1, normal_kpa: [20, 10], shear_kpa: 5}");
  }
  test->tractions = calloc((size_t)node->count, sizeof *test->tractions);
  if (test->tractions == NULL) return tp_fail_memory(reader->message, "the tractions");
  tp_status status = TP_OK;
  for (const tp_node *n = node->first; n != NULL && status == TP_OK; n = n->next) {
    tp_traction_description *own = test->tractions + test->traction_count++;
    tp_traction_description_init(own);
    status = read_traction(reader, own, n);
  }
  return status;
}

tp_status tp_read_tilt_test(const tp_reader *reader, const tp_node *node) {
  tp_tilt_test_description *test = &reader->scene->tilt_test;
  if (node == NULL) return TP_OK;
  test->place = tp_node_place(node, reader->scene->path);
  tp_status status = tp_read_keys(reader, node, &tp_key_map_tilt_test, "tilt_test");
  if (status == TP_OK) status = read_engine(reader, node);
  if (status == TP_OK) status = read_protocol(reader, node);
  if (status == TP_OK) status = tp_read_values(reader, reader->scene, node, &tp_key_map_tilt_test);
  return status == TP_OK ? read_tractions(reader, tp_node_get(node, "tractions")) : status;
}
