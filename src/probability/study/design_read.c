/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The key design_values of a study: for each the number, the probability wanted, the quantity, and
 * where to look. */

#include "common/outside.h"
#include "study/analyses.h"
#include "study/outcome.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { DESIGNS_MOST = 20 };

static tp_status read_variable(const tp_study_reader *reader, tp_wanted_design *design,
                               const tp_node *map) {
  const tp_study *study = reader->study;
  const tp_node *node = tp_node_get(map, "of");
  const char *known[TP_STUDY_VARIABLES + 1] = {NULL};
  if (node == NULL || node->kind != TP_NODE_SCALAR) {
    return tp_study_fail(reader, node != NULL ? node : map,
                         "'of' names the number, for example 'of: friction_angle_deg'");
  }
  for (size_t k = 0; k < study->variable_count; k++) {
    known[k] = study->variables[k].node->key;
    design->variable = k;
    if (strcmp(node->text, known[k]) == 0) return TP_OK;
  }
  const char *nearest = tp_nearest(node->text, known);
  return tp_study_fail(reader, node, "'%s' does not vary in this study%s%s%s",
                       tp_quote_all(node->text).text, nearest != NULL ? "; did you mean '" : "",
                       nearest != NULL ? tp_quote_all(nearest).text : "",
                       nearest != NULL ? "'?" : "");
}

/* One sample at least is to be expected on either side of it. */
static tp_status read_probability(const tp_study_reader *reader, tp_wanted_design *design,
                                  const tp_node *map) {
  const tp_study *study = reader->study;
  const tp_node *node = tp_node_get(map, "probability");
  if (node == NULL) {
    return tp_study_fail(reader, map, "'probability' is missing here, as 'probability: 0.05'");
  }
  const tp_status status = tp_study_read_number(reader, &design->probability, node, "probability");
  if (status != TP_OK) return status;
  const double p = design->probability;
  if (!(p > 0 && p < 1)) {
    return tp_study_fail(reader, node, "a probability wanted lies between 0 and 1");
  }
  const uint64_t kept = study->samples < TP_STUDY_KEPT ? study->samples : TP_STUDY_KEPT;
  if ((double)kept * fmin(p, 1 - p) >= 1) return TP_OK;
  return tp_study_fail(
      reader, node,
      "%zu samples are too few for a probability of %g; take %.0f at least, of which "
      "the first %d count here",
      (size_t)study->samples, p, ceil(1 / fmin(p, 1 - p)), TP_STUDY_KEPT);
}

/* What is certain to stand, unless something else is asked for. */
static tp_status read_quantity(const tp_study_reader *reader, tp_wanted_design *design,
                               const tp_node *map) {
  const tp_scene *scene = reader->study->scene;
  const tp_node *node = tp_node_get(map, "quantity");
  design->quantity = tp_study_is_of_many(reader->study) || tp_study_is_of_solid(reader->study)
                         ? TP_STUDY_LIMIT_DEG
                     : scene->friction_angle_deg.given ? TP_STUDY_ONSET_DEG
                                                       : TP_STUDY_MOMENTS_DEG;
  if (node == NULL) return TP_OK;
  const tp_status status = tp_study_read_quantity(reader, &design->quantity, node);
  if (status == TP_OK && design->quantity == TP_STUDY_SUPPORT_N_M) {
    return tp_study_fail(reader, node,
                         "design values are of angles, factors of safety and accelerations; take "
                         "fos with the support as one of the scene's loads: forces");
  }
  if (status != TP_OK || !tp_study_quantity_is_factor(design->quantity) ||
      tp_study_has_stance(reader->study)) {
    return status;
  }
  return tp_study_fail(reader, node,
                       "a factor of safety is that at the scene's tilt, and the scene has none: "
                       "'tilt: {towards: left, angle_deg: 20}'");
}

static tp_status read_range(const tp_study_reader *reader, tp_wanted_design *design,
                            const tp_node *map) {
  const tp_node *from = tp_node_get(map, "from"), *to = tp_node_get(map, "to");
  design->ranged = from != NULL || to != NULL;
  if (!design->ranged) return TP_OK;
  if (from == NULL || to == NULL) {
    return tp_study_fail(reader, map, "'from' and 'to' go together: where to look for it");
  }
  tp_status status = tp_study_read_number(reader, &design->from, from, "from");
  if (status == TP_OK) status = tp_study_read_number(reader, &design->to, to, "to");
  if (status != TP_OK || design->from < design->to) return status;
  return tp_study_fail(reader, to, "'to' must be above 'from'");
}

static tp_status read_design(const tp_study_reader *reader, tp_wanted_design *design,
                             const tp_node *map) {
  static const char *const keys[] = {"of", "probability", "quantity", "from", "to", NULL};
  tp_status status =
      tp_node_expect_keys(map, keys, "design_values", reader->study->path, reader->message);
  if (status == TP_OK) status = read_variable(reader, design, map);
  if (status == TP_OK) status = read_probability(reader, design, map);
  if (status == TP_OK) status = read_quantity(reader, design, map);
  return status == TP_OK ? read_range(reader, design, map) : status;
}

tp_status tp_study_read_designs(const tp_study_reader *reader, const tp_node *root) {
  tp_study *study = reader->study;
  const tp_node *node = tp_node_get(root, "design_values");
  if (node == NULL) return TP_OK;
  if (node->kind != TP_NODE_SEQUENCE || node->count == 0 || node->count > DESIGNS_MOST) {
    return tp_study_fail(reader, node,
                         "design_values is a list of up to %d, for example '[{of: "
                         "friction_angle_deg, probability: 0.05}]'",
                         DESIGNS_MOST);
  }
  study->designs = calloc((size_t)node->count, sizeof *study->designs);
  if (study->designs == NULL) return tp_fail_memory(reader->message, "the study");
  tp_status status = TP_OK;
  for (const tp_node *own = node->first; own != NULL && status == TP_OK; own = own->next) {
    status = read_design(reader, study->designs + study->design_count++, own);
  }
  return status;
}
