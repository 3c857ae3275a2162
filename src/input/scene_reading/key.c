/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Walk from the root along the words of a key, the parameters first for a single word; the reach of
 * a key is found from the group that it stands in. */

#include "scene_reading/key.h"

#include "common/outside.h"

#include <stdlib.h>
#include <string.h>

/* By the first `length` bytes of a way: a key of a map, or a number in a list, counted from 1. */
static const tp_node *child(const tp_node *node, const char *key, size_t length) {
  const tp_node *found = node->first;
  if (node->kind == TP_NODE_SEQUENCE) {
    char *end = NULL;
    long index = strtol(key, &end, 10);
    if (end == key || end != key + length) return NULL;
    while (found != NULL && --index > 0) found = found->next;
    return index == 0 ? found : NULL;
  }
  while (node->kind == TP_NODE_MAPPING && found != NULL &&
         (strncmp(found->key, key, length) != 0 || found->key[length] != '\0')) {
    found = found->next;
  }
  return node->kind == TP_NODE_MAPPING ? found : NULL;
}

static void add_keys(const char **known, size_t *count, const tp_node *of) {
  for (const tp_node *n = of->first; n != NULL && of->kind == TP_NODE_MAPPING; n = n->next) {
    known[(*count)++] = n->key;
  }
}

/* Among the keys of `at`, and of `other`; `near`: may the message name one that is there? */
static tp_status fail(const tp_node *at, const tp_node *other, const char *way, size_t length,
                      bool near, const char *file, tp_message *message) {
  const char **known = calloc((size_t)(at->count + other->count) + 1, sizeof *known);
  char *key = strndup(way, length);
  if (known == NULL || key == NULL) {
    free(known);
    free(key);
    return tp_fail_memory(message, "a key");
  }
  size_t count = 0;
  add_keys(known, &count, at);
  if (other != at) add_keys(known, &count, other);
  const char *nearest = near ? tp_nearest(key, known) : NULL;
  free(known);
  const tp_quote quoted = tp_quote_all(key);
  free(key);
  return tp_refuse(message, TP_FAULT_KEY, tp_node_place(at, file), "there is no '%s' here%s%s%s",
                   quoted.text, nearest != NULL ? "; did you mean '" : "",
                   nearest != NULL ? tp_quote_all(nearest).text : "", nearest != NULL ? "'?" : "");
}

/* A passive bolt counts up to its capacity, and has no force that could be another. */
static bool is_force_of_capacity(const tp_node *at, const char *key) {
  return strcmp(key, "force_kn") == 0 && at->kind == TP_NODE_MAPPING &&
         tp_node_get(at, "capacity_kn") != NULL;
}

tp_status tp_key_find(const tp_node **node, const tp_node *root, const char *key, const char *file,
                      tp_message *message) {
  const tp_node *parameters = tp_node_get(root, "parameters");
  const tp_node *at = root;
  if (strchr(key, '.') == NULL && parameters != NULL &&
      child(parameters, key, strlen(key)) != NULL) {
    at = child(parameters, key, strlen(key));
    key = NULL;
  }
  while (key != NULL) {
    const size_t length = strcspn(key, ".");
    const bool is_last = key[length] == '\0';
    const tp_node *next = child(at, key, length);
    if (next == NULL && is_force_of_capacity(at, key)) {
      return tp_refuse(message, TP_FAULT_KEY, tp_node_place(at, file),
                       "this bolt has no 'force_kn' and counts up to its 'capacity_kn': name that "
                       "key instead, or give it a 'force_kn' too, of any size up to the capacity");
    }
    if (next == NULL) {
      const bool parameter =
          at == root && is_last && parameters != NULL && parameters->kind == TP_NODE_MAPPING;
      const bool scene = tp_node_get(root, "topple") != NULL;
      return fail(parameter ? parameters : at, at, key, length, scene, file, message);
    }
    at = next;
    key = is_last ? NULL : key + length + 1;
  }
  if (at->kind != TP_NODE_SCALAR) {
    return tp_refuse(message, TP_FAULT_KEY, tp_node_place(at, file),
                     "this is a list or a map; a single number can be found");
  }
  *node = at;
  return TP_OK;
}
