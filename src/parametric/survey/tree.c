/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Scalars put into a tree of nodes at keys with dots. */

#include "survey/tree.h"

#include "common/outside.h"

#include <stdlib.h>
#include <string.h>

/* The child of a part of a key: by its name, or in a list by its number. */
tp_node *tp_tree_child(const tp_node *at, const char *part, size_t length) {
  tp_node *child = at->first;
  if (at->kind == TP_NODE_SEQUENCE) {
    long number = strspn(part, "0123456789") >= length ? strtol(part, NULL, 10) : 0;
    while (child != NULL && --number > 0) child = child->next;
    return number == 0 ? child : NULL;
  }
  while (child != NULL &&
         (strlen(child->key) != length || strncmp(child->key, part, length) != 0)) {
    child = child->next;
  }
  return child;
}

/* The scalar at the key, made with the maps on the way to it where there is none; NULL when memory
 * is exhausted or, `*possible` then false, where the key leads into a scalar or beyond a list. */
static tp_node *reach(tp_node *root, const char *key, tp_mark mark, bool *possible) {
  tp_node *at = root;
  for (const char *part = key; *part != '\0';) {
    const size_t length = strcspn(part, ".");
    tp_node *next = tp_tree_child(at, part, length);
    if (next == NULL) {
      const bool last = part[length] == '\0';
      *possible = at->kind == TP_NODE_MAPPING;
      char *name = *possible ? strndup(part, length) : NULL;
      next = name != NULL
                 ? tp_node_add(at, name, last ? TP_NODE_SCALAR : TP_NODE_MAPPING, last ? "" : NULL)
                 : NULL;
      free(name);
      if (next == NULL) return NULL;
      next->mark = mark;
    }
    at = next;
    part += length + (part[length] == '.');
  }
  *possible = at->kind == TP_NODE_SCALAR;
  return *possible ? at : NULL;
}

tp_status tp_tree_put(tp_node *root, const char *key, const char *text, tp_mark mark,
                      tp_message *message) {
  bool possible = true;
  tp_node *at = reach(root, key, mark, &possible);
  if (!possible) {
    return tp_refuse(message, TP_FAULT_KEY, (tp_place){0},
                     "'%s' names no number of the scene that the row is over; entries of a list "
                     "stand there",
                     tp_quote_all(key).text);
  }
  char *own = at != NULL ? strdup(text) : NULL;
  if (own == NULL) return tp_fail_memory(message, "the scene of a row");
  free(at->text);
  at->text = own;
  at->text_offset = 0;
  at->mark = mark;
  return TP_OK;
}

tp_node *tp_tree_copy(tp_node *parent, const tp_node *node) {
  tp_node *copy = tp_node_add(parent, node->key, node->kind, node->text);
  if (copy == NULL) return NULL;
  copy->mark = node->mark;
  copy->key_mark = node->key_mark;
  copy->text_offset = node->text_offset;
  for (const tp_node *child = node->first; child != NULL; child = child->next) {
    if (tp_tree_copy(copy, child) != NULL) continue;
    if (parent == NULL) tp_node_free(copy);
    return NULL;
  }
  return copy;
}

void tp_tree_drop(tp_node *parent, const char *key) {
  tp_node *before = NULL;
  for (tp_node *child = parent->first; child != NULL; before = child, child = child->next) {
    if (strcmp(child->key, key) != 0) continue;
    if (before != NULL) {
      before->next = child->next;
    } else {
      parent->first = child->next;
    }
    if (parent->last == child) parent->last = before;
    parent->count--;
    tp_node_free(child);
    return;
  }
}
