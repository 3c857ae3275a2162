/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Keys that a mapping may have, and the nearest known one to a misspelt key; else a key of that
 * name that stands elsewhere. */

#include "scene/node.h"

#include "common/nearest.h"
#include "common/outside.h"
#include "terms/table.h"

#include <stdio.h>
#include <string.h>
#include <strings.h>

const char *tp_nearest(const char *word, const char *const *candidates) {
  const char *best = NULL;
  size_t least = tp_word_reach(word);
  for (; *candidates != NULL; candidates++) {
    if (strlen(word) > 2 && strncmp(word, *candidates, strlen(word)) == 0) return *candidates;
    const size_t away = tp_word_distance(word, *candidates);
    if (away < least) {
      least = away;
      best = *candidates;
    }
  }
  return best;
}

/* Does the known key add a unit to the given one, as in angle and angle_deg? */
static bool lacks_unit(const char *given, const char *known) {
  const size_t length = strlen(given);
  return strncmp(given, known, length) == 0 && known[length] == '_';
}

/* The key with the shortest path of all files that has this name, in capitals or not, with a unit
 * or without. */
static const tp_file_key *key_elsewhere(const char *name) {
  const tp_file_key *found = NULL;
  for (size_t k = 0; k < tp_file_key_count; k++) {
    const tp_file_key *key = tp_file_keys + k;
    const char *dot = strrchr(key->path, '.'), *last = dot != NULL ? dot + 1 : key->path;
    if (strcasecmp(name, last) != 0 && !lacks_unit(name, last)) continue;
    if (found == NULL || strlen(key->path) < strlen(found->path)) found = key;
  }
  return found;
}

tp_status tp_node_expect_keys(const tp_node *node, const char *const *keys, const char *what,
                              const char *file, tp_message *message) {
  if (node->kind != TP_NODE_MAPPING) {
    return tp_refuse(message, TP_FAULT_KEY, tp_node_place(node, file),
                     "%s must be a map of keys such as '%s: …'", what, keys[0]);
  }
  for (const tp_node *child = node->first; child != NULL; child = child->next) {
    const tp_place place = {file, child->key_mark.line, child->key_mark.column};
    size_t k = 0;
    while (keys[k] != NULL && strcmp(keys[k], child->key) != 0) k++;
    if (keys[k] != NULL) continue;
    const char *nearest = tp_nearest(child->key, keys);
    if (nearest != NULL && lacks_unit(child->key, nearest)) {
      return tp_refuse(message, TP_FAULT_UNIT, place,
                       "'%s' lacks its unit: write '%s' (a key that holds a quantity ends in its "
                       "unit)",
                       tp_quote_all(child->key).text, nearest);
    }
    if (nearest != NULL) {
      return tp_refuse(message, TP_FAULT_KEY, place, "unknown key '%s' in %s; did you mean '%s'?",
                       tp_quote_all(child->key).text, what, nearest);
    }
    const tp_file_key *elsewhere = key_elsewhere(child->key);
    if (elsewhere != NULL) {
      const char *kind =
          strcmp(elsewhere->file, "claims") == 0 ? "file of claims" : elsewhere->file;
      return tp_refuse(message, TP_FAULT_KEY, place, "unknown key '%s' in %s; a %s has '%s'",
                       tp_quote_all(child->key).text, what, kind, elsewhere->path);
    }
    char list[400] = "";
    for (k = 0; keys[k] != NULL; k++) {
      const size_t used = strlen(list);
      snprintf(list + used, sizeof list - used, "%s%s", k > 0 ? ", " : "", keys[k]);
    }
    return tp_refuse(message, TP_FAULT_KEY, place, "unknown key '%s' in %s; known are: %s",
                     tp_quote_all(child->key).text, what, list);
  }
  return TP_OK;
}
