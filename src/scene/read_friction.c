/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Friction of the contact: one angle, or a law. */

#include "scene/read.h"

#include <string.h>

tp_status tp_read_angle(const tp_reader *reader, tp_quantity *angle, const tp_node *node,
                        const char *name, bool excluded) {
  const tp_status status = tp_read_quantity(reader, angle, node, name);
  if (status != TP_OK || !angle->given) return status;
  const int side = fmpq_cmp_ui(angle->value, 90);
  if (fmpq_sgn(angle->value) >= 0 && (side < 0 || (side == 0 && !excluded))) return TP_OK;
  return tp_read_fail(reader, node, "%s must lie in [0°, 90°%s", name, excluded ? ")" : "]");
}

static tp_status read_required_angle(const tp_reader *reader, tp_quantity *angle,
                                     const tp_node *mapping, const char *key, const char *example) {
  const tp_node *node = NULL;
  const tp_status status = tp_read_required(reader, &node, mapping, key, example);
  return status == TP_OK ? tp_read_angle(reader, angle, node, key, true) : status;
}

static tp_status read_required_positive(const tp_reader *reader, tp_quantity *quantity,
                                        const tp_node *mapping, const char *key,
                                        const char *example) {
  const tp_node *node = NULL;
  const tp_status status = tp_read_required(reader, &node, mapping, key, example);
  if (status != TP_OK) return status;
  quantity->given = true;
  quantity->place = tp_node_place(node, reader->scene->path);
  return tp_read_positive(reader, quantity->value, node, key);
}

/* phi_b + i, Eq. (6). */
static tp_status read_patton(const tp_reader *reader, const tp_node *node) {
  static const char *const keys[] = {"law", "basic_angle_deg", "roughness_angle_deg", NULL};
  tp_quantity *angle = &reader->scene->friction_angle_deg;
  tp_friction_description *f = &reader->scene->friction;
  tp_status status =
      tp_node_expect_keys(node, keys, "friction", reader->scene->path, reader->message);
  if (status == TP_OK) {
    status = read_required_angle(reader, angle, node, "basic_angle_deg", "basic_angle_deg: 30");
  }
  if (status == TP_OK) {
    status = read_required_angle(reader, &f->roughness_angle_deg, node, "roughness_angle_deg",
                                 "roughness_angle_deg: 10");
  }
  if (status != TP_OK) return status;
  fmpq_add(angle->value, angle->value, f->roughness_angle_deg.value);
  if (fmpq_cmp_ui(angle->value, 90) < 0) return TP_OK;
  return tp_read_fail(reader, node, "basic_angle_deg + roughness_angle_deg must lie below 90°");
}

/* Eq. (9) divides by log10(JCS / sigma): a test at JCS has no answer, one above it a negative JRC.
 */
static tp_status expect_stress_below_strength(const tp_reader *reader, const tp_node *test) {
  const tp_friction_description *f = &reader->scene->friction;
  fmpq_t strength;
  fmpq_init(strength);
  fmpq_mul_ui(strength, f->jcs_mpa.value, 1000);
  const bool below = fmpq_cmp(f->test_stress_kpa.value, strength) < 0;
  fmpq_clear(strength);
  if (below) return TP_OK;
  return tp_read_fail(reader, test, "the normal stress of a tilt test must be below jcs_mpa");
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
    return tp_read_angle(reader, &f->roughness_angle_deg, roughness, "roughness_angle_deg", true);
  }
  if (jrc != NULL) {
    const tp_status status = tp_read_quantity(reader, &f->jrc, jrc, "jrc");
    if (status != TP_OK || (fmpq_sgn(f->jrc.value) >= 0 && fmpq_cmp_ui(f->jrc.value, 100) <= 0)) {
      return status;
    }
    return tp_read_fail(reader, jrc, "jrc must lie in [0, 100]");
  }
  tp_status status =
      tp_node_expect_keys(test, test_keys, "tilt_test", reader->scene->path, reader->message);
  if (status == TP_OK) {
    status = read_required_angle(reader, &f->test_angle_deg, test, "angle_deg", "angle_deg: 55");
  }
  if (status == TP_OK) {
    status = read_required_positive(reader, &f->test_stress_kpa, test, "normal_stress_kpa",
                                    "normal_stress_kpa: 2.3");
  }
  if (status == TP_OK &&
      fmpq_cmp(f->test_angle_deg.value, reader->scene->friction_angle_deg.value) < 0) {
    status = tp_read_fail(reader, test, "a tilt test slides at residual_angle_deg or above");
  }
  if (status == TP_OK) status = expect_stress_below_strength(reader, test);
  return status;
}

static tp_status read_barton(const tp_reader *reader, const tp_node *node) {
  static const char *const keys[] = {"law",       "residual_angle_deg",  "jrc", "jcs_mpa",
                                     "tilt_test", "roughness_angle_deg", NULL};
  tp_friction_description *f = &reader->scene->friction;
  tp_status status =
      tp_node_expect_keys(node, keys, "friction", reader->scene->path, reader->message);
  f->load_dependent = true;
  if (status == TP_OK) {
    status = read_required_angle(reader, &reader->scene->friction_angle_deg, node,
                                 "residual_angle_deg", "residual_angle_deg: 28");
  }
  if (status == TP_OK) {
    status = read_required_positive(reader, &f->jcs_mpa, node, "jcs_mpa", "jcs_mpa: 120");
  }
  if (status == TP_OK) status = read_roughness(reader, node);
  if (status == TP_OK && !reader->scene->block.unit_weight_kn_m3.given) {
    status = tp_read_fail(reader, node,
                          "the law barton depends on the normal stress: give the block its "
                          "unit_weight_kn_m3");
  }
  return status;
}

tp_status tp_read_friction(const tp_reader *reader, const tp_node *root) {
  const tp_node *angle = tp_node_get(root, "friction_angle_deg");
  const tp_node *node = tp_node_get(root, "friction");
  if (node == NULL) {
    return tp_read_angle(reader, &reader->scene->friction_angle_deg, angle, "friction_angle_deg",
                         true);
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

static void for_each(tp_friction_description *f, void (*visit)(fmpq_t)) {
  visit(f->jrc.value);
  visit(f->jcs_mpa.value);
  visit(f->roughness_angle_deg.value);
  visit(f->test_angle_deg.value);
  visit(f->test_stress_kpa.value);
}

void tp_friction_description_init(tp_friction_description *f) {
  for_each(f, fmpq_init);
}

void tp_friction_description_clear(tp_friction_description *f) {
  for_each(f, fmpq_clear);
}
