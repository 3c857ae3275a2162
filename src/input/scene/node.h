/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A YAML file as a tree of nodes that know their place.
 *
 * Scalars keep their raw text, so that 0.1 stays one tenth. Keys given twice, aliases, nesting
 * deeper than 32 and files beyond 256 MiB are refused. */

#ifndef TP_SCENE_NODE_H
#define TP_SCENE_NODE_H

#include "common/message.h"
#include "plane/polyline.h"

typedef enum tp_node_kind { TP_NODE_SCALAR, TP_NODE_SEQUENCE, TP_NODE_MAPPING } tp_node_kind;

typedef struct tp_node tp_node;
struct tp_node {
  tp_node_kind kind;
  tp_mark mark;
  char *text;      /* of a scalar */
  int text_offset; /* 1 where an opening quote stands before the text */
  char *key;       /* of a child of a mapping */
  tp_mark key_mark;
  long count; /* children */
  tp_node *first, *last, *next;
  const tp_node *parent; /* NULL: the root */
};

/* `*root` stays untouched on failure. */
TP_MUST_USE tp_status tp_node_read(tp_node **root, const char *path, tp_message *message);
void tp_node_free(tp_node *root);

/* The same from text that is not empty; `name` is what places refer to. */
TP_MUST_USE tp_status tp_node_read_text(tp_node **root, const char *text, const char *name,
                                        tp_message *message);

/* A node behind the other children of a mapping, or a root where that is NULL; its texts are
 * copied, NULL is none. NULL when memory is exhausted. */
tp_node *tp_node_add(tp_node *mapping, const char *key, tp_node_kind kind, const char *text);

/* The child of a mapping, or NULL, as of any other node, and of none. */
const tp_node *tp_node_get(const tp_node *mapping, const char *key);

/* The first of some keys (NULL-terminated) that it has, likewise. */
const tp_node *tp_node_first_of(const tp_node *mapping, const char *const *keys);

/* Is `node` a mapping with none but these keys (NULL-terminated)? An unknown key is reported with
 * the nearest known one. `what` names the mapping in the message. */
TP_MUST_USE tp_status tp_node_expect_keys(const tp_node *node, const char *const *keys,
                                          const char *what, const char *file, tp_message *message);

/* Nearest of the candidates (NULL-terminated) to a misspelt word, or NULL. */
const char *tp_nearest(const char *word, const char *const *candidates);

/* Is it the one node, or within it? */
bool tp_node_is_within(const tp_node *node, const tp_node *outer);

tp_place tp_node_place(const tp_node *node, const char *file);

#endif
