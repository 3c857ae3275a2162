/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Friction of the contact: one angle, or a law. */

#include "scene/read.h"

#include <string.h>

static tp_status read_required(const tp_reader *reader, tp_quantity *quantity,
                               const tp_node *mapping, const char *key, const char *example,
                               tp_rule rule) {
  const tp_node *node = NULL;
  const tp_status status = tp_read_required(reader, &node, mapping, key, example);
  return status == TP_OK ? tp_read_quantity(reader, quantity, node, key, rule) : status;
}

/* phi_b + i, Eq. (6). */
static tp_status read_patton(const tp_reader *reader, const tp_node *node) {
  static const char *const keys[] = {"law", "basic_angle_deg", "roughness_angle_deg", NULL};
  tp_quantity *angle = &reader->scene->friction_angle_deg;
  tp_friction_description *f = &reader->scene->friction;
  tp_status status =
      tp_node_expect_keys(node, keys, "friction", reader->scene->path, reader->message);
  if (status == TP_OK) {
    status = read_required(reader, angle, node, "basic_angle_deg", "basic_angle_deg: 30",
                           TP_RULE_ANGLE_BELOW_90);
  }
  if (status == TP_OK) {
    status = read_required(reader, &f->roughness_angle_deg, node, "roughness_angle_deg",
                           "roughness_angle_deg: 10", TP_RULE_ANGLE_BELOW_90);
  }
  if (status != TP_OK) return status;
  fmpq_add(angle->value, angle->value, f->roughness_angle_deg.value);
  return tp_check_patton(angle->value, tp_read_place(reader, node), reader->message);
}

/* JRC by itself, from a tilt test by Eq. (9), or from the roughness angle by Eq. (10). */
static tp_status read_roughness(const tp_reader *reader, const tp_node *node) {
  static const char *const test_keys[] = {"angle_deg", "normal_stress_kpa", NULL};
  tp_friction_description *f = &reader->scene->friction;
  const tp_node *jrc = tp_node_get(node, "jrc"), *test = tp_node_get(node, "tilt_test");
  const tp_node *roughness = tp_node_get(node, "roughness_angle_deg");
  if ((jrc != NULL) + (test != NULL) + (roughness != NULL) != 1) {
    return tp_read_fail(reader, node,
                        "the law barton needs one of jrc, tilt_test (Eq. 9) and "
                        "roughness_angle_deg (Eq. 10): 'jrc: 8'");
  }
  if (roughness != NULL) {
    return tp_read_quantity(reader, &f->roughness_angle_deg, roughness, "roughness_angle_deg",
                            TP_RULE_ANGLE_BELOW_90);
  }
  if (jrc != NULL) {
    return tp_read_quantity(reader, &f->jrc, jrc, "jrc", TP_RULE_JRC);
  }
  tp_status status =
      tp_node_expect_keys(test, test_keys, "tilt_test", reader->scene->path, reader->message);
  if (status == TP_OK) {
    status = read_required(reader, &f->test_angle_deg, test, "angle_deg", "angle_deg: 55",
                           TP_RULE_ANGLE_BELOW_90);
  }
  if (status == TP_OK) {
    status = read_required(reader, &f->test_stress_kpa, test, "normal_stress_kpa",
                           "normal_stress_kpa: 2.3", TP_RULE_ABOVE_ZERO);
  }
  if (status != TP_OK) return status;
  return tp_check_tilt_test(f->test_angle_deg.value, f->test_stress_kpa.value,
                            reader->scene->friction_angle_deg.value, f->jcs_mpa.value,
                            tp_read_place(reader, test), reader->message);
}

static tp_status read_barton(const tp_reader *reader, const tp_node *node) {
  static const char *const keys[] = {"law",       "residual_angle_deg",  "jrc", "jcs_mpa",
                                     "tilt_test", "roughness_angle_deg", NULL};
  tp_friction_description *f = &reader->scene->friction;
  tp_status status =
      tp_node_expect_keys(node, keys, "friction", reader->scene->path, reader->message);
  f->load_dependent = true;
  if (status == TP_OK) {
    status = read_required(reader, &reader->scene->friction_angle_deg, node, "residual_angle_deg",
                           "residual_angle_deg: 28", TP_RULE_ANGLE_BELOW_90);
  }
  if (status == TP_OK) {
    status =
        read_required(reader, &f->jcs_mpa, node, "jcs_mpa", "jcs_mpa: 120", TP_RULE_ABOVE_ZERO);
  }
  if (status == TP_OK) status = read_roughness(reader, node);
  if (status != TP_OK) return status;
  return tp_check_law_weighed(reader->scene, tp_read_place(reader, node), reader->message);
}

tp_status tp_read_friction(const tp_reader *reader, const tp_node *root) {
  const tp_node *angle = tp_node_get(root, "friction_angle_deg");
  const tp_node *node = tp_node_get(root, "friction");
  if (node == NULL) {
    return tp_read_quantity(reader, &reader->scene->friction_angle_deg, angle, "friction_angle_deg",
                            TP_RULE_ANGLE_BELOW_90);
  }
  if (angle != NULL) {
    return tp_read_fail(reader, node, "give friction_angle_deg or friction, not both");
  }
  if (node->kind != TP_NODE_MAPPING) {
    return tp_read_fail(reader, node,
                        "friction must be a law, as {law: barton, residual_angle_deg: 28, jrc: 8, "
                        "jcs_mpa: 120}; a plain angle is friction_angle_deg");
  }
  const tp_node *law = NULL;
  const tp_status status = tp_read_required(reader, &law, node, "law", "law: barton");
  if (status != TP_OK) return status;
  const char *name = law->kind == TP_NODE_SCALAR ? law->text : "";
  if (strcmp(name, "patton") == 0) return read_patton(reader, node);
  if (strcmp(name, "barton") == 0) return read_barton(reader, node);
  return tp_read_fail(reader, law, "law must be patton (Eq. 6) or barton (Eq. 8)");
}
