/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Friction of the contact: one angle, or a law, and what facets have of their own. */

#include "scene_reading/read.h"

#include <stdlib.h>
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
  static const char *const keys[] = {"law", "basic_angle_deg", "roughness_angle_deg", "facets",
                                     NULL};
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
  tp_friction_description *f = &reader->scene->friction;
  const tp_node *jrc = tp_node_get(node, "jrc"), *test = tp_node_get(node, "tilt_test");
  const tp_node *roughness = tp_node_get(node, "roughness_angle_deg");
  if ((jrc != NULL) + (test != NULL) + (roughness != NULL) != 1) {
    return tp_read_fail(reader, TP_FAULT_KEY, node,
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
  const tp_status status =
      tp_read_map(reader, reader->scene, test, &tp_key_map_friction_tilt_test, "tilt_test");
  if (status != TP_OK) return status;
  return tp_check_tilt_test(f->test_angle_deg.value, f->test_stress_kpa.value,
                            reader->scene->friction_angle_deg.value, f->jcs_mpa.value,
                            tp_read_place(reader, test), reader->message);
}

static tp_status read_barton(const tp_reader *reader, const tp_node *node) {
  static const char *const keys[] = {"law",       "residual_angle_deg",  "jrc",    "jcs_mpa",
                                     "tilt_test", "roughness_angle_deg", "facets", NULL};
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

tp_status tp_read_facet_number(const tp_reader *reader, long *number, const tp_node *node) {
  fmpq_t value;
  fmpq_init(value);
  tp_status status = tp_read_number(reader, value, node, "facet");
  if (status == TP_OK) {
    status = tp_check_facet_number(number, value, tp_read_place(reader, node), reader->message);
  }
  fmpq_clear(value);
  return status;
}

/* `facet` as one number, or as the first and the last of several. */
static tp_status read_numbers(const tp_reader *reader, tp_facet_friction_description *facets,
                              const tp_node *node) {
  const bool two = node->kind == TP_NODE_SEQUENCE && node->count == 2;
  const tp_status status = tp_read_facet_number(reader, &facets->first, two ? node->first : node);
  if (status != TP_OK || two) {
    return status == TP_OK ? tp_read_facet_number(reader, &facets->last, node->last) : status;
  }
  facets->last = facets->first;
  return TP_OK;
}

static tp_status read_own(const tp_reader *reader, tp_facet_friction_description *facets,
                          const tp_node *node) {
  facets->place = tp_read_place(reader, node);
  tp_status status = tp_read_keys(reader, node, &tp_key_map_friction_facets, "facets");
  if (status != TP_OK) return status;
  const tp_node *numbers = tp_node_get(node, "facet"), *x = tp_node_get(node, "x");
  if ((numbers != NULL) == (x != NULL)) {
    return tp_read_fail(reader, TP_FAULT_KEY, node,
                        "say which facets of the base: 'facet: 3', 'facet: [3, 7]' from one number "
                        "to another, or 'x: [10, 20]'");
  }
  status = numbers != NULL ? read_numbers(reader, facets, numbers)
                           : tp_read_point(reader, &facets->x0, &facets->x1, x, "x");
  if (status == TP_OK) status = tp_check_facet_range(facets, reader->message);
  return status == TP_OK ? read_required(reader, &facets->angle_deg, node, "angle_deg",
                                         "angle_deg: 20", TP_RULE_ANGLE_BELOW_90)
                         : status;
}

static tp_status read_facets(const tp_reader *reader, const tp_node *node) {
  tp_friction_description *f = &reader->scene->friction;
  if (node == NULL) return TP_OK;
  if (node->kind != TP_NODE_SEQUENCE || node->count == 0) {
    return tp_read_fail(reader, TP_FAULT_FORMAT, node,
                        "facets are a list of {facet: 3, angle_deg: 20}");
  }
  f->facets = calloc((size_t)node->count, sizeof *f->facets);
  if (f->facets == NULL) return tp_fail_memory(reader->message, "the friction of facets");
  tp_status status =
      tp_check_facet_friction(reader->scene, tp_read_place(reader, node), reader->message);
  for (const tp_node *n = node->first; n != NULL && status == TP_OK; n = n->next) {
    tp_facet_friction_description *own = f->facets + f->facet_count++;
    tp_facet_friction_description_init(own);
    status = read_own(reader, own, n);
  }
  return status;
}

static tp_status read_law(const tp_reader *reader, const tp_node *node) {
  const tp_node *law = NULL;
  const tp_status status = tp_read_required(reader, &law, node, "law", "law: barton");
  if (status != TP_OK) return status;
  const char *name = law->kind == TP_NODE_SCALAR ? law->text : "";
  if (strcmp(name, "patton") == 0) return read_patton(reader, node);
  if (strcmp(name, "barton") == 0) return read_barton(reader, node);
  return tp_read_fail(reader, TP_FAULT_KEY, law, "law must be patton (Eq. 6) or barton (Eq. 8)");
}

/* Of a smooth surface, or of the rough joint. */
static tp_status read_meaning(const tp_reader *reader, const tp_node *node) {
  tp_scene *scene = reader->scene;
  if (node == NULL) return TP_OK;
  const char *text = node->kind == TP_NODE_SCALAR ? node->text : "";
  scene->friction_is_basic = strcmp(text, "basic") == 0;
  scene->friction_is_apparent = strcmp(text, "apparent") == 0;
  scene->friction_is_place = tp_read_place(reader, node);
  if (scene->friction_is_basic || scene->friction_is_apparent) return TP_OK;
  return tp_read_fail(reader, TP_FAULT_KEY, node,
                      "friction_is must be 'basic', of a smooth surface, or 'apparent', measured "
                      "on the rough joint, which contains the roughness");
}

tp_status tp_read_friction(const tp_reader *reader, const tp_node *root) {
  static const char *const keys[] = {"law", "facets", NULL};
  const tp_node *angle = tp_node_get(root, "friction_angle_deg");
  const tp_node *node = tp_node_get(root, "friction");
  if (node != NULL && node->kind != TP_NODE_MAPPING) {
    return tp_read_fail(reader, TP_FAULT_KEY, node,
                        "friction must be a law, as {law: barton, residual_angle_deg: 28, jrc: 8, "
                        "jcs_mpa: 120}; a plain angle is friction_angle_deg");
  }
  const tp_node *facets = node != NULL ? tp_node_get(node, "facets") : NULL;
  const bool law = node != NULL && (facets == NULL || tp_node_get(node, "law") != NULL);
  if (law && angle != NULL) {
    return tp_read_fail(reader, TP_FAULT_KEY, node,
                        "give friction_angle_deg or friction, not both");
  }
  const tp_node *meaning = tp_node_get(root, "friction_is");
  if (meaning != NULL && angle == NULL && !law) {
    return tp_read_fail(reader, TP_FAULT_KEY, meaning,
                        "'friction_is' says what 'friction_angle_deg' or the law of 'friction' is "
                        "of; give one of them");
  }
  tp_status status = read_meaning(reader, meaning);
  if (status == TP_OK && law) status = read_law(reader, node);
  if (status == TP_OK && facets != NULL && !law) {
    status = tp_node_expect_keys(node, keys, "friction", reader->scene->path, reader->message);
  }
  return status == TP_OK ? read_facets(reader, facets) : status;
}
