/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The key tilt_test of a scene: how its test is simulated. */

#include "scene/check_tilt_test.h"
#include "scene/read.h"

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
    return tp_read_fail(reader, engine,
                        "engine must be path (quasi-static, from event to event) or dynamics");
  }
  if (method != NULL && !events && !springs) {
    return tp_read_fail(reader, method,
                        "method must be events (a rigid block on rigid contacts) or springs");
  }
  if (method != NULL && !dynamics) {
    return tp_read_fail(reader, method, "a method belongs to 'engine: dynamics'");
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
      return tp_read_fail(reader, protocol,
                          "protocol must be ramp (at a speed), steps (a fresh start at each angle) "
                          "or release (held at the tilt, let go)");
    }
    test->protocol = (tp_tilt_protocol)found;
    test->protocol_place = tp_node_place(protocol, reader->scene->path);
  }
  if (start == NULL) return TP_OK;
  test->set_down = strcmp(text_of(start), "set_down") == 0;
  test->start_place = tp_node_place(start, reader->scene->path);
  if (test->set_down || strcmp(text_of(start), "level") == 0) return TP_OK;
  return tp_read_fail(reader, start,
                      "start must be level (placed level, and tilted) or set_down (at the angle)");
}

tp_status tp_read_tilt_test(const tp_reader *reader, const tp_node *node) {
  static const char *const keys[] = {"engine",
                                     "method",
                                     "protocol",
                                     "start",
                                     "speed_deg_min",
                                     "until_deg",
                                     "tolerance_deg",
                                     "duration_s",
                                     "normal_stiffness_gpa_m",
                                     "shear_stiffness_gpa_m",
                                     "damping",
                                     "rounding",
                                     "time_step_s",
                                     "restitution",
                                     NULL};
  tp_tilt_test_description *test = &reader->scene->tilt_test;
  if (node == NULL) return TP_OK;
  test->place = tp_node_place(node, reader->scene->path);
  const struct {
    tp_quantity *quantity;
    const char *key;
    tp_rule rule;
  } numbers[] = {{&test->speed_deg_min, "speed_deg_min", TP_RULE_ABOVE_ZERO},
                 {&test->until_deg, "until_deg", TP_RULE_ANGLE_TO_90},
                 {&test->tolerance_deg, "tolerance_deg", TP_RULE_ABOVE_ZERO},
                 {&test->duration_s, "duration_s", TP_RULE_ABOVE_ZERO},
                 {&test->normal_stiffness_gpa_m, "normal_stiffness_gpa_m", TP_RULE_ABOVE_ZERO},
                 {&test->shear_stiffness_gpa_m, "shear_stiffness_gpa_m", TP_RULE_ABOVE_ZERO},
                 {&test->damping, "damping", TP_RULE_SHARE},
                 {&test->rounding, "rounding", TP_RULE_ABOVE_ZERO},
                 {&test->time_step_s, "time_step_s", TP_RULE_ABOVE_ZERO},
                 {&test->restitution, "restitution", TP_RULE_SHARE}};
  tp_status status =
      tp_node_expect_keys(node, keys, "tilt_test", reader->scene->path, reader->message);
  if (status == TP_OK) status = read_engine(reader, node);
  if (status == TP_OK) status = read_protocol(reader, node);
  for (size_t k = 0; k < sizeof numbers / sizeof numbers[0] && status == TP_OK; k++) {
    status = tp_read_quantity(reader, numbers[k].quantity, tp_node_get(node, numbers[k].key),
                              numbers[k].key, numbers[k].rule);
  }
  return status;
}
