/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What a number of a scene bears upon, by the names that stand in its expressions. */

#include "scene_reading/key.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

/* The number itself, and the parameters found so far that depend on it. */
typedef struct reached {
  const tp_node *number;
  const char **names;
  size_t count;
} reached;

static bool is_of_name(char c) {
  return isalnum((unsigned char)c) || c == '_';
}

/* Does the text name one of them? What stands behind a digit, as e5 in 2e5, counts as a name. */
static bool names_one(const char *text, const reached *r) {
  while (*text != '\0') {
    while (*text != '\0' && (!is_of_name(*text) || isdigit((unsigned char)*text))) text++;
    size_t length = 0;
    while (is_of_name(text[length])) length++;
    for (size_t k = 0; k < r->count && length > 0; k++) {
      if (strlen(r->names[k]) == length && strncmp(r->names[k], text, length) == 0) return true;
    }
    text += length;
  }
  return false;
}

static bool is_reached(const tp_node *node, const reached *r) {
  if (node == r->number) return true;
  if (node->kind == TP_NODE_SCALAR) return names_one(node->text, r);
  for (const tp_node *child = node->first; child != NULL; child = child->next) {
    if (is_reached(child, r)) return true;
  }
  return false;
}

/* Each parameter may name those before it. */
static void follow_parameters(reached *r, const tp_node *parameters) {
  for (const tp_node *p = parameters->first; p != NULL; p = p->next) {
    if (is_reached(p, r)) r->names[r->count++] = p->key;
  }
}

/* A section whose key `own` is one thing, and all its others another. */
static void look_inside(bool *own, bool *other, const tp_node *section, const char *key,
                        const reached *r) {
  for (const tp_node *child = section->first; child != NULL; child = child->next) {
    if (!is_reached(child, r)) continue;
    *(child->key != NULL && strcmp(child->key, key) == 0 ? own : other) = true;
  }
}

tp_status tp_key_reach(tp_reach *reach, const tp_node *root, const tp_node *number,
                       tp_message *message) {
  const tp_node *parameters = tp_node_get(root, "parameters");
  reached r = {.number = number};
  *reach = (tp_reach){.other = false};
  r.names = calloc(parameters != NULL ? (size_t)parameters->count + 1 : 1, sizeof *r.names);
  if (r.names == NULL) return tp_fail_memory(message, "the names in the scene");
  if (parameters != NULL) follow_parameters(&r, parameters);
  for (const tp_node *section = root->first; section != NULL; section = section->next) {
    if (section == parameters || !is_reached(section, &r)) continue;
    if (strcmp(section->key, "friction_angle_deg") == 0 || strcmp(section->key, "friction") == 0) {
      reach->friction = true;
    } else if (strcmp(section->key, "tilt") == 0) {
      look_inside(&reach->tilt, &reach->other, section, "angle_deg", &r);
    } else if (strcmp(section->key, "loads") == 0) {
      look_inside(&reach->friction, &reach->other, section, "cohesion_kpa", &r);
    } else if (strcmp(section->key, "title") != 0) {
      reach->other = true;
    }
  }
  free(r.names);
  return TP_OK;
}
