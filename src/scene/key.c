/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "scene/key.h"

#include "outside.h"

#include <stdlib.h>
#include <string.h>

enum { KEY_SIZE = 128 };

static tp_node *child(const tp_node *node, const char *key) {
  tp_node *found = node->first;
  if (node->kind == TP_NODE_SEQUENCE) {
    char *end = NULL;
    long index = strtol(key, &end, 10);
    if (end == key || *end != '\0') return NULL;
    while (found != NULL && --index > 0) found = found->next;
    return index == 0 ? found : NULL;
  }
  while (node->kind == TP_NODE_MAPPING && found != NULL && strcmp(found->key, key) != 0) {
    found = found->next;
  }
  return node->kind == TP_NODE_MAPPING ? found : NULL;
}

/* The next key of a way; the rest of it, or NULL at its end. */
static const char *split(char key[KEY_SIZE], const char *way) {
  const size_t length = strcspn(way, ".");
  snprintf(key, KEY_SIZE, "%.*s", (int)(length < KEY_SIZE ? length : KEY_SIZE - 1), way);
  return way[length] == '.' ? way + length + 1 : NULL;
}

/* `near`: may the message name a key that is there? */
static tp_status fail(const tp_node *at, const char *key, bool near, const char *file,
                      tp_message *message) {
  const char **known = calloc((size_t)at->count + 1, sizeof *known);
  if (known == NULL) return tp_fail_memory(message, "a key");
  size_t count = 0;
  for (const tp_node *n = at->first; n != NULL && at->kind == TP_NODE_MAPPING; n = n->next) {
    known[count++] = n->key;
  }
  const char *nearest = near ? tp_nearest(key, known) : NULL;
  free(known);
  return tp_fail(message, TP_BAD_INPUT, tp_node_place(at, file), "there is no '%s' here%s%s%s",
                 tp_quote_all(key).text, nearest != NULL ? "; did you mean '" : "",
                 nearest != NULL ? tp_quote_all(nearest).text : "", nearest != NULL ? "'?" : "");
}

tp_status tp_key_find(tp_node **node, tp_node *root, const char *key, const char *file,
                      tp_message *message) {
  char part[KEY_SIZE];
  const tp_node *parameters = tp_node_get(root, "parameters");
  tp_node *at = root;
  if (strchr(key, '.') == NULL && parameters != NULL && child(parameters, key) != NULL) {
    at = child(parameters, key);
    key = NULL;
  }
  while (key != NULL) {
    key = split(part, key);
    tp_node *next = child(at, part);
    if (next == NULL) {
      const bool parameter =
          at == root && key == NULL && parameters != NULL && parameters->kind == TP_NODE_MAPPING;
      const bool scene = tp_node_get(root, "topple") != NULL;
      return fail(parameter ? parameters : at, part, scene, file, message);
    }
    at = next;
  }
  if (at->kind != TP_NODE_SCALAR) {
    return tp_fail(message, TP_BAD_INPUT, tp_node_place(at, file),
                   "this is a list or a map; a single number can be found");
  }
  *node = at;
  return TP_OK;
}
