/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Looks for names of parameters as whole words in the numbers of a profile's rule and refuses those
 * found. */

#include "derive/made_profile.h"

#include "common/outside.h"
#include "scene/setting.h"

#include <ctype.h>
#include <string.h>

static bool is_of_name(char c) {
  return isalnum((unsigned char)c) || c == '_';
}

/* The name as a whole word of the text. */
static bool stands_in(const char *name, const char *text) {
  const size_t length = strlen(name);
  for (const char *at = strstr(text, name); at != NULL; at = strstr(at + 1, name)) {
    if ((at == text || !is_of_name(at[-1])) && !is_of_name(at[length])) return true;
  }
  return false;
}

/* The names of files, and words that are no numbers, are not looked at. */
static bool is_number(const tp_node *node) {
  const char *key = node->key != NULL ? node->key : "";
  return strcmp(key, "measured") != 0 && strcmp(key, "left_end") != 0;
}

/* What stands at a number, or was set in its place; of one given by value no name. */
static const char *text_of(const tp_scene *scene, const tp_node *node) {
  const tp_override *own = tp_scene_override(scene, node);
  if (own == NULL) return node->text;
  return own->setting != NULL ? own->setting + tp_setting_key_length(own->setting) : "";
}

tp_status tp_made_profile_check(const tp_scene *scene, const tp_node *profile,
                                tp_message *message) {
  const tp_parameters *names = &scene->parameters;
  for (const tp_node *n = profile->first; n != NULL; n = n->next) {
    if (n->kind != TP_NODE_SCALAR) {
      const tp_status status = tp_made_profile_check(scene, n, message);
      if (status != TP_OK) return status;
      continue;
    }
    for (long k = 0; k < names->count && is_number(n); k++) {
      if (!stands_in(names->names[k], text_of(scene, n))) continue;
      return tp_fail(message, TP_NO_ANSWER, tp_node_place(n, scene->path),
                     "derive takes a profile made by rule by its numbers, and '%s' stands for any: "
                     "write the number here, or give the profile as points",
                     tp_quote_all(names->names[k]).text);
    }
  }
  return TP_OK;
}
