/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Reads the keys sensitivity and reliability of a study file, with its methods for rare events, and
 * checks that all variables have distributions; design_values is read by study/design_read.c. */

#include "study/analyses.h"

#include "common/outside.h"
#include "sampling/sobol_points.h"
#include "study/outcome.h"

#include <string.h>

enum { SENSITIVITY_LEAST = 16, RESULTS_MOST = 10000000 };

/* All that varies has a distribution, and of indices none depends on another. */
static tp_status check_drawn(const tp_study_reader *reader, const tp_node *node) {
  const tp_study *study = reader->study;
  for (size_t k = 0; k < study->variable_count; k++) {
    if (study->variables[k].source == TP_VARIABLE_DRAWN) continue;
    return tp_study_fail(reader, node,
                         "'%s' is for numbers that are drawn from distributions; '%s' varies by a "
                         "%s",
                         node->key, tp_quote_all(study->variables[k].node->key).text,
                         study->variables[k].kind);
  }
  return TP_OK;
}

static tp_status read_sensitivity(const tp_study_reader *reader, const tp_node *node) {
  static const char *const keys[] = {"samples", NULL};
  tp_study *study = reader->study;
  tp_status status = tp_node_expect_keys(node, keys, "sensitivity", study->path, reader->message);
  const tp_node *samples = tp_node_get(node, "samples");
  if (status == TP_OK && samples == NULL) {
    return tp_study_fail(reader, node,
                         "'samples' is missing here, for example 'sensitivity: "
                         "{samples: 1000}'");
  }
  if (status == TP_OK) status = check_drawn(reader, node);
  if (status == TP_OK && study->correlation != NULL) {
    return tp_study_fail(reader, node,
                         "Sobol' indices have no meaning for numbers that depend on "
                         "each other; leave out 'sensitivity' or 'correlations'");
  }
  if (status == TP_OK && study->method == TP_DRAW_SOBOL && 2 * study->drawn > TP_SOBOL_DIMENSIONS) {
    return tp_study_fail(reader, node,
                         "Sobol' indices take two dimensions for each number, and "
                         "Sobol' points have %d; draw by latin_hypercube",
                         TP_SOBOL_DIMENSIONS);
  }
  if (status != TP_OK) return status;
  return tp_study_read_whole(reader, &study->sensitivity, samples, "samples", SENSITIVITY_LEAST,
                             RESULTS_MOST / (study->drawn + 2));
}

tp_status tp_study_read_quantity(const tp_study_reader *reader, tp_study_quantity *quantity,
                                 const tp_node *node) {
  enum { LEAST = 4 }; /* and a support where one is asked for */
  const char *known[TP_STUDY_QUANTITIES + 1] = {NULL};
  size_t count = 0;
  for (int q = 0; q < TP_STUDY_QUANTITIES; q++) {
    if (!tp_study_has_quantity(reader->study, (tp_study_quantity)q)) continue;
    known[count] = tp_study_quantity_name((tp_study_quantity)q);
    if (node->kind == TP_NODE_SCALAR && strcmp(node->text, known[count]) == 0) {
      *quantity = (tp_study_quantity)q;
      return TP_OK;
    }
    count++;
  }
  const char *nearest = node->kind == TP_NODE_SCALAR ? tp_nearest(node->text, known) : NULL;
  if (tp_study_is_of_solid(reader->study)) {
    return tp_study_fail(reader, node, "of a solid a quantity is %s, %s or %s", known[0], known[1],
                         known[2]);
  }
  return tp_study_fail(reader, node, "%sa quantity is %s, %s, %s%s%s or %s%s%s%s",
                       tp_study_is_of_many(reader->study) ? "of many blocks " : "", known[0],
                       known[1], known[2], count > LEAST ? ", " : "", count > LEAST ? known[3] : "",
                       known[count - 1], nearest != NULL ? "; did you mean '" : "",
                       nearest != NULL ? nearest : "", nearest != NULL ? "'?" : "");
}

/* {samples: 1000}; 0 where it is not there. */
static tp_status read_rare(const tp_study_reader *reader, uint64_t *count, const tp_node *map,
                           const char *key, uint64_t least) {
  static const char *const keys[] = {"samples", NULL};
  const tp_node *node = tp_node_get(map, key);
  if (node == NULL) return TP_OK;
  const tp_status status =
      tp_node_expect_keys(node, keys, key, reader->study->path, reader->message);
  const tp_node *samples = tp_node_get(node, "samples");
  if (status != TP_OK) return status;
  if (samples == NULL) {
    return tp_study_fail(reader, node,
                         "'samples' is missing here, for example '%s: {samples: "
                         "1000}'",
                         key);
  }
  return tp_study_read_whole(reader, count, samples, "samples", least, RESULTS_MOST);
}

static tp_status read_rares(const tp_study_reader *reader, const tp_node *node) {
  enum { IMPORTANCE_LEAST = 2, SUBSET_LEAST = 100, SUBSET_STEP = 10 };
  tp_study *study = reader->study;
  tp_status status = read_rare(reader, &study->importance, node, "importance", IMPORTANCE_LEAST);
  if (status == TP_OK) status = read_rare(reader, &study->subset, node, "subset", SUBSET_LEAST);
  if (status == TP_OK && study->subset % SUBSET_STEP != 0) {
    return tp_study_fail(reader, tp_node_get(node, "subset"),
                         "subset simulation takes a multiple "
                         "of 10 samples");
  }
  return status;
}

static tp_status read_reliability(const tp_study_reader *reader, const tp_node *node) {
  static const char *const keys[] = {"quantity", "importance", "subset", NULL};
  tp_study *study = reader->study;
  tp_status status = tp_node_expect_keys(node, keys, "reliability", study->path, reader->message);
  const tp_node *quantity = tp_node_get(node, "quantity");
  if (status == TP_OK && quantity == NULL) {
    return tp_study_fail(reader, node,
                         "'quantity' is missing here, for example 'reliability: "
                         "{quantity: limit_deg}'");
  }
  if (status == TP_OK) status = tp_study_read_quantity(reader, &study->relied, quantity);
  if (status == TP_OK && study->relied == TP_STUDY_ACCELERATION_G) {
    return tp_study_fail(reader, quantity,
                         "reliability is of an angle at the tilt, or of a factor of safety; take "
                         "fos with the earthquake in the scene");
  }
  if (status == TP_OK && study->relied == TP_STUDY_SUPPORT_N_M) {
    return tp_study_fail(reader, quantity,
                         "reliability is of an angle at the tilt, or of a factor of safety; take "
                         "fos with the support as one of the scene's loads: forces");
  }
  if (status == TP_OK) status = check_drawn(reader, node);
  if (status == TP_OK && !tp_study_has_stance(study)) {
    return tp_study_fail(reader, node,
                         "reliability is that at the scene's tilt, and the scene has "
                         "none: 'tilt: {towards: left, angle_deg: 20}'");
  }
  if (status == TP_OK) status = read_rares(reader, node);
  study->relies = status == TP_OK;
  return status;
}

tp_status tp_study_read_analyses(const tp_study_reader *reader, const tp_node *root) {
  const tp_node *sensitivity = tp_node_get(root, "sensitivity");
  const tp_node *reliability = tp_node_get(root, "reliability");
  tp_status status = sensitivity != NULL ? read_sensitivity(reader, sensitivity) : TP_OK;
  if (status == TP_OK && reliability != NULL) status = read_reliability(reader, reliability);
  return status;
}
