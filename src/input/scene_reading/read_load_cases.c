/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The key cases of a scene: is it a list of maps, each with a name of its own and keys that a case
 * can have? What these say is read with the scene of the case (scene_varying/load_case.c). */

#include "scene_reading/read.h"

#include "common/outside.h"

#include <string.h>

enum { MOST_CASES = 1000, MOST_NAME = 60 };

static tp_status check_name(const tp_reader *reader, const tp_node *cases, const tp_node *own) {
  const tp_node *name = NULL;
  tp_status status = tp_read_required(reader, &name, own, "name", "name: wet");
  if (status != TP_OK) return status;
  if (name->kind != TP_NODE_SCALAR || name->text[0] == '\0' || strlen(name->text) > MOST_NAME) {
    return tp_read_fail(reader, TP_FAULT_KEY, name,
                        "the name of a case is a text of 1 to %d characters, as 'name: wet'",
                        MOST_NAME);
  }
  for (const tp_node *n = cases->first; n != own; n = n->next) {
    const tp_node *other = tp_node_get(n, "name");
    if (strcmp(other->text, name->text) != 0) continue;
    return tp_read_fail(reader, TP_FAULT_KEY, name,
                        "two cases are named '%s', the first in line %d; give each a name of its "
                        "own",
                        tp_quote_all(name->text).text, other->mark.line);
  }
  return TP_OK;
}

static tp_status check_case(const tp_reader *reader, const tp_node *cases, const tp_node *own) {
  if (own->kind == TP_NODE_MAPPING && tp_node_get(own, "block") != NULL) {
    return tp_read_fail(reader, TP_FAULT_KEY, tp_node_get(own, "block"),
                        "cases are of one block: change what acts on it, or write a second scene");
  }
  tp_status status = tp_read_keys(reader, own, &tp_key_map_cases, "a case");
  if (status == TP_OK) status = check_name(reader, cases, own);
  const tp_node *set = tp_node_get(own, "set");
  if (status == TP_OK && set != NULL && set->kind != TP_NODE_MAPPING) {
    status = tp_read_fail(reader, TP_FAULT_FORMAT, set,
                          "'set' is a map of keys to numbers: {friction_angle_deg: 28}");
  }
  if (status == TP_OK && tp_node_get(own, "required_fos") != NULL &&
      tp_node_get(own, "partial_factors") != NULL) {
    status = tp_read_fail(reader, TP_FAULT_KEY, tp_node_get(own, "required_fos"),
                          "give required_fos or partial_factors, not both: partial factors say "
                          "themselves what the factor must reach, 'resistance' included");
  }
  return status;
}

tp_status tp_read_load_cases(const tp_reader *reader, const tp_node *node) {
  if (node == NULL) return TP_OK;
  if (node->kind != TP_NODE_SEQUENCE || node->count == 0 || node->count > MOST_CASES) {
    return tp_read_fail(reader, TP_FAULT_FORMAT, node,
                        "cases are a list, of up to %d: [{name: wet, loads: {water: {height: 2}}}]",
                        MOST_CASES);
  }
  tp_status status = TP_OK;
  for (const tp_node *n = node->first; n != NULL && status == TP_OK; n = n->next) {
    status = check_case(reader, node, n);
  }
  reader->scene->load_cases = node;
  return status;
}
