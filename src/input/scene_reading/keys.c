/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Keys that a mapping may have, and the nearest known one to a misspelt key. */

#include "scene/node.h"

#include "common/nearest.h"
#include "common/outside.h"

#include <stdio.h>
#include <string.h>

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
