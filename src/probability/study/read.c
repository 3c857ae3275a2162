/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A study file as a whole: its scene, how it is sampled, what varies, and the tilts. */

#include "common/host.h"
#include "common/outside.h"
#include "study/analyses.h"
#include "study/hash.h"
#include "study/plan.h"
#include "study/roughness.h"
#include "study/sample_filter.h"
#include "study/scene.h"
#include "study/variable.h"

#include <stdlib.h>
#include <string.h>

enum { CHUNK = 100, CHUNK_LARGE = 10000, CHUNKS = 100 };

static tp_status read_version(const tp_study_reader *reader, const tp_node *root) {
  static const char *const keys[] = {
      "topple_study", "title", "scene",        "samples",     "sampling",    "vary",
      "tilts_deg",    "until", "correlations", "sensitivity", "reliability", "design_values",
      "roughness",    "unit",  "set",          "case",        NULL};
  const tp_node *node = tp_node_get(root, "topple_study");
  if (node == NULL) {
    return tp_study_fail(reader, root, "this is not a study: 'topple_study: 1' is missing");
  }
  if (node->kind != TP_NODE_SCALAR || strcmp(node->text, "1") != 0) {
    return tp_study_fail(reader, node,
                         "this program reads studies of version 1: "
                         "'topple_study: 1'");
  }
  const tp_node *title = tp_node_get(root, "title");
  if (title != NULL && title->kind != TP_NODE_SCALAR) {
    return tp_study_fail(reader, title, "title must be text");
  }
  return tp_node_expect_keys(root, keys, "the study", reader->study->path, reader->message);
}

static tp_status find_key(const tp_study_reader *reader, tp_scene_key *key, const tp_node *node,
                          const char *text) {
  tp_message inner = {.text = ""};
  const tp_status status = tp_scene_key_find(key, reader->study->scene, text, &inner);
  return status == TP_OK ? TP_OK : tp_study_fail_of(reader, node, status, &inner);
}

/* ---- what varies -------------------------------------------------------------------------------
 */

static tp_status check_twice(const tp_study_reader *reader, size_t own) {
  const tp_study *study = reader->study;
  const tp_variable *variable = study->variables + own;
  for (size_t k = 0; k < own; k++) {
    if (study->variables[k].key.node != variable->key.node) continue;
    return tp_study_fail(reader, variable->node, "'%s' is the same number as '%s' above",
                         tp_quote_all(variable->node->key).text,
                         tp_quote_all(study->variables[k].node->key).text);
  }
  return TP_OK;
}

/* All columns go together. */
static tp_status count_cells(const tp_study_reader *reader, const tp_variable *variable) {
  tp_study *study = reader->study;
  if (variable->source == TP_VARIABLE_DRAWN) return TP_OK;
  if (variable->source == TP_VARIABLE_COLUMN && study->rows > 0) {
    if (study->rows == variable->count) return TP_OK;
    return tp_study_fail(reader, variable->node,
                         "this column has %zu rows, the one above %zu; columns go together row by "
                         "row",
                         variable->count, (size_t)study->rows);
  }
  if (variable->source == TP_VARIABLE_COLUMN) study->rows = variable->count;
  if (study->cells > TP_STUDY_SAMPLES / variable->count) {
    return tp_study_fail(reader, variable->node,
                         "lists and grids make too many samples: more "
                         "than 2^40");
  }
  study->cells *= variable->count;
  return TP_OK;
}

/* Does the scene's tilt depend on it? */
static tp_status look_at_tilt(const tp_study_reader *reader, const tp_variable *variable) {
  tp_reach reach;
  tp_study *study = reader->study;
  const tp_status status =
      tp_scene_key_reach(&reach, &variable->key, study->scene, reader->message);
  if (status == TP_OK) study->tilt_varies = study->tilt_varies || reach.tilt;
  return status;
}

static tp_status read_vary(const tp_study_reader *reader, const tp_node *root) {
  tp_study *study = reader->study;
  const tp_node *node = tp_node_get(root, "vary");
  if (node == NULL || node->kind != TP_NODE_MAPPING || node->count == 0 ||
      node->count > TP_STUDY_VARIABLES) {
    return tp_study_fail(reader, node != NULL ? node : root,
                         "'vary' is a map of up to %d keys of the scene, for example 'vary: "
                         "{friction_angle_deg: {normal: {mean: 30, deviation: 2}}}'",
                         TP_STUDY_VARIABLES);
  }
  study->variables = calloc((size_t)node->count, sizeof *study->variables);
  study->drawn_names = calloc((size_t)node->count, sizeof *study->drawn_names);
  if (study->variables == NULL || study->drawn_names == NULL) {
    return tp_fail_memory(reader->message, "the study");
  }
  tp_status status = TP_OK;
  for (const tp_node *own = node->first; own != NULL && status == TP_OK; own = own->next) {
    const size_t k = study->variable_count++;
    tp_variable *variable = study->variables + k;
    status = tp_variable_read(reader, variable, own);
    if (status == TP_OK) status = find_key(reader, &variable->key, own, own->key);
    if (status == TP_OK) status = check_twice(reader, k);
    if (status == TP_OK) status = look_at_tilt(reader, variable);
    if (status == TP_OK) status = count_cells(reader, variable);
    if (status != TP_OK || variable->source != TP_VARIABLE_DRAWN) continue;
    variable->dimension = study->drawn++;
    study->drawn_names[variable->dimension] = own->key;
  }
  return status;
}

/* ---- tilts, and when to stop -------------------------------------------------------------------
 */

static tp_status find_tilt(const tp_study_reader *reader, const tp_node *node) {
  tp_study *study = reader->study;
  tp_message inner = {.text = ""};
  if (tp_scene_key_find(&study->tilt_key, study->scene, "tilt.angle_deg", &inner) != TP_OK) {
    return tp_study_fail(reader, node,
                         "for other tilts the scene needs one of its own, 'tilt: "
                         "{towards: left, angle_deg: 20}'");
  }
  for (size_t k = 0; k < study->variable_count; k++) {
    if (study->variables[k].key.node != study->tilt_key.node) continue;
    return tp_study_fail(reader, node, "the tilt varies already, by '%s'; leave out one of them",
                         tp_quote_all(study->variables[k].node->key).text);
  }
  return TP_OK;
}

static tp_status read_tilts(const tp_study_reader *reader, const tp_node *root) {
  tp_study *study = reader->study;
  const tp_node *node = tp_node_get(root, "tilts_deg");
  if (node == NULL) return TP_OK;
  if (node->kind != TP_NODE_SEQUENCE || node->count == 0 || node->count > TP_STUDY_TILTS) {
    return tp_study_fail(reader, node, "tilts_deg is a list of up to %d tilts, as in [10, 20, 30]",
                         TP_STUDY_TILTS);
  }
  study->tilts = calloc((size_t)node->count, sizeof *study->tilts);
  if (study->tilts == NULL) return tp_fail_memory(reader->message, "the tilts");
  tp_status status = find_tilt(reader, node);
  for (const tp_node *own = node->first; own != NULL && status == TP_OK; own = own->next) {
    double *tilt = study->tilts + study->tilt_count;
    status = tp_study_read_number(reader, tilt, own, "tilts_deg");
    if (status == TP_OK && !(*tilt >= 0 && *tilt <= 90)) {
      status = tp_study_fail(reader, own, "a tilt lies between 0 and 90 degrees");
    } else if (status == TP_OK && study->tilt_count > 0 && *tilt <= tilt[-1]) {
      status = tp_study_fail(reader, own, "tilts_deg rises from one to the next");
    }
    study->tilt_count++;
  }
  return status;
}

static tp_status read_until(const tp_study_reader *reader, const tp_node *root) {
  static const char *const keys[] = {"half_width", NULL};
  tp_study *study = reader->study;
  const tp_node *node = tp_node_get(root, "until");
  if (node == NULL) return TP_OK;
  tp_status status = tp_node_expect_keys(node, keys, "until", study->path, reader->message);
  const tp_node *width = tp_node_get(node, "half_width");
  if (status == TP_OK && width == NULL) {
    return tp_study_fail(reader, node,
                         "'half_width' is missing here, for example 'until: "
                         "{half_width: 0.01}'");
  }
  if (status == TP_OK) {
    status = tp_study_read_number(reader, &study->half_width, width, "half_width");
  }
  if (status == TP_OK && !(study->half_width > 0 && study->half_width < 0.5)) {
    return tp_study_fail(reader, width, "a half-width of a probability lies between 0 and 0.5");
  }
  return status;
}

/* ---- all of it ---------------------------------------------------------------------------------
 */

static tp_status read_root(const tp_study_reader *reader, const tp_node *root) {
  tp_status status = read_version(reader, root);
  if (status == TP_OK) status = tp_study_read_scene(reader, root);
  if (status == TP_OK) status = read_vary(reader, root);
  if (status == TP_OK) status = tp_study_read_plan(reader, root);
  if (status == TP_OK) status = read_tilts(reader, root);
  if (status == TP_OK) status = read_until(reader, root);
  if (status == TP_OK) status = tp_study_read_analyses(reader, root);
  if (status == TP_OK) status = tp_study_read_designs(reader, root);
  if (status == TP_OK) status = tp_study_read_roughness(reader, root);
  if (status != TP_OK) return status;
  return tp_sample_filter_new(&reader->study->filter, reader->study, reader->message);
}

/* Threads meet at the end of a chunk, which takes as long as some fast samples: a hundredth of
 * large studies, but of those that may end sooner. */
static size_t chunk_unasked(const tp_study *study) {
  const uint64_t share = study->samples / CHUNKS;
  if (study->half_width > 0 || share <= CHUNK) return CHUNK;
  return share < CHUNK_LARGE ? (size_t)share : CHUNK_LARGE;
}

/* The nodes of a file, or of a text, and the hash of its bytes. */
static tp_status read_nodes(tp_study *study, const char *text, tp_message *message) {
  tp_status status = text == NULL ? tp_node_read(&study->root, study->path, message)
                                  : tp_node_read_text(&study->root, text, study->path, message);
  if (status == TP_OK && text == NULL) status = tp_hash_file(&study->hash, study->path, message);
  if (text != NULL) tp_hash_text(&study->hash, text);
  study->hash_of_file = study->hash;
  return status;
}

/* Of the file, or of the text, which is called so. */
static tp_status read_study(tp_study **study, const char *path, const char *text,
                            tp_message *message) {
  tp_study *own = calloc(1, sizeof *own);
  if (own == NULL) return tp_fail_memory(message, "the study");
  *own = (tp_study){.path = strdup(path),
                    .method = TP_DRAW_LATIN_HYPERCUBE,
                    .seed = 1,
                    .cells = 1,
                    .hash = TP_HASH_START};
  const tp_study_reader reader = {own, message};
  tp_status status =
      own->path != NULL ? read_nodes(own, text, message) : tp_fail_memory(message, "the study");
  if (status == TP_OK) status = read_root(&reader, own->root);
  if (status == TP_OK) {
    if (own->chunk == 0) own->chunk = chunk_unasked(own);
    *study = own;
  } else {
    tp_study_free(own);
  }
  return status;
}

tp_status tp_study_read(tp_study **study, const char *path, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, study);
  TP_REFUSE_NULL(message, path);
  return read_study(study, path, NULL, message);
}

tp_status tp_study_read_text(tp_study **study, const char *text, const char *name,
                             tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, study);
  TP_REFUSE_NULL(message, text);
  TP_REFUSE_NULL(message, name);
  return read_study(study, name, text, message);
}

void tp_study_free(tp_study *study) {
  if (study == NULL) return;
  for (size_t k = 0; k < study->variable_count; k++) tp_variable_clear(study->variables + k);
  free(study->variables);
  free((void *)study->drawn_names);
  free(study->correlation);
  free(study->tilts);
  tp_keyed_filter_free(study->filter);
  free(study->designs);
  tp_scene_free(study->scene);
  free(study->scene_path);
  tp_node_free(study->root);
  free(study->path);
  free(study);
}
