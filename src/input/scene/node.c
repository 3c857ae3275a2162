/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Events of libyaml built into a tree, with bounds on bytes, depth and keys of a mapping. */

#include "scene/node.h"

#include "common/input_file.h"
#include "common/outside.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <yaml.h>

enum {
  MOST_DEPTH = 32, /* far beyond any scene; what walks the tree recurs so deep at most */
  MOST_KEYS = 1000 /* of one mapping, which is looked through for every key */
};
static const size_t most_bytes = (size_t)256 << 20; /* some millions of vertices */

typedef struct source {
  FILE *file;
  const char *path;
  size_t bytes;
  bool too_large, failed;
} source;

static int read_bytes(void *data, unsigned char *buffer, size_t size, size_t *size_read) {
  source *from = data;
  *size_read = fread(buffer, 1, size, from->file);
  from->bytes += *size_read;
  from->failed = ferror(from->file) != 0;
  from->too_large = from->bytes > most_bytes;
  return !from->failed && !from->too_large;
}

static tp_mark mark_of(yaml_mark_t mark) {
  return (tp_mark){(int)mark.line + 1, (int)mark.column + 1};
}

tp_place tp_node_place(const tp_node *node, const char *file) {
  return (tp_place){file, node->mark.line, node->mark.column};
}

void tp_node_free(tp_node *root) {
  if (root == NULL) return;
  for (tp_node *child = root->first; child != NULL;) { /* depth is bounded by MOST_DEPTH */
    tp_node *next = child->next;
    tp_node_free(child);
    child = next;
  }
  free(root->text);
  free(root->key);
  free(root);
}

tp_node *tp_node_add(tp_node *mapping, const char *key, tp_node_kind kind, const char *text) {
  tp_node *node = calloc(1, sizeof *node);
  if (node == NULL) return NULL;
  *node = (tp_node){.kind = kind,
                    .text = text != NULL ? strdup(text) : NULL,
                    .key = key != NULL ? strdup(key) : NULL,
                    .parent = mapping};
  if ((text != NULL && node->text == NULL) || (key != NULL && node->key == NULL)) {
    tp_node_free(node);
    return NULL;
  }
  if (mapping == NULL) return node;
  if (mapping->last != NULL) {
    mapping->last->next = node;
  } else {
    mapping->first = node;
  }
  mapping->last = node;
  mapping->count++;
  return node;
}

const tp_node *tp_node_get(const tp_node *mapping, const char *key) {
  if (mapping == NULL || mapping->kind != TP_NODE_MAPPING) return NULL;
  for (const tp_node *child = mapping->first; child != NULL; child = child->next) {
    if (strcmp(child->key, key) == 0) return child;
  }
  return NULL;
}

const tp_node *tp_node_first_of(const tp_node *mapping, const char *const *keys) {
  const tp_node *found = NULL;
  for (; *keys != NULL && found == NULL; keys++) found = tp_node_get(mapping, *keys);
  return found;
}

bool tp_node_is_within(const tp_node *node, const tp_node *outer) {
  while (node != NULL && node != outer) node = node->parent;
  return node != NULL;
}

/* The tree under construction: the collections that it is within, and a key that waits for its
 * value. */
typedef struct builder {
  const char *path;
  tp_message *message;
  tp_node *root;
  tp_node *within[MOST_DEPTH];
  int depth;
  char *key;
  tp_mark key_mark;
} builder;

static tp_place at(const builder *b, tp_mark mark) {
  return (tp_place){b->path, mark.line, mark.column};
}

/* Does the file say that it is for this program? Nothing is quoted of a file that does not. */
static bool is_ours(const builder *b) {
  return tp_node_get(b->within[0], "topple") != NULL ||
         tp_node_get(b->within[0], "topple_claims") != NULL;
}

static tp_status take_key(builder *b, const char *text, tp_mark mark) {
  const tp_node *mapping = b->within[b->depth - 1];
  const tp_node *twin = tp_node_get(mapping, text);
  if (twin != NULL && !is_ours(b)) {
    return tp_refuse(b->message, TP_FAULT_KEY, at(b, mark),
                     "a key is given twice, first in line %d; keep one of them",
                     twin->key_mark.line);
  }
  if (twin != NULL) {
    return tp_refuse(b->message, TP_FAULT_KEY, at(b, mark),
                     "the key '%s' is given twice, first in line %d; keep one of them",
                     tp_quote_all(text).text, twin->key_mark.line);
  }
  if (mapping->count >= MOST_KEYS) {
    return tp_refuse(b->message, TP_FAULT_KEY, at(b, mark), "more than 1000 keys in one place");
  }
  b->key = strdup(text);
  b->key_mark = mark;
  return b->key != NULL ? TP_OK : tp_fail_memory(b->message, "the scene");
}

static bool wants_key(const builder *b) {
  return b->depth > 0 && b->within[b->depth - 1]->kind == TP_NODE_MAPPING && b->key == NULL;
}

static tp_status attach(builder *b, tp_node_kind kind, tp_mark mark, tp_node **attached) {
  if (wants_key(b)) {
    return tp_refuse(b->message, TP_FAULT_KEY, at(b, mark),
                     "a key must be a plain word, not a list or a map");
  }
  tp_node *node = calloc(1, sizeof *node);
  if (node == NULL) return tp_fail_memory(b->message, "the scene");
  node->kind = kind;
  node->mark = mark;
  node->key = b->key;
  node->key_mark = b->key_mark;
  b->key = NULL;
  if (b->depth == 0) {
    b->root = node;
  } else {
    tp_node *parent = b->within[b->depth - 1];
    if (parent->last == NULL) {
      parent->first = node;
    } else {
      parent->last->next = node;
    }
    parent->last = node;
    parent->count++;
    node->parent = parent;
  }
  *attached = node;
  return TP_OK;
}

static tp_status take_scalar(builder *b, const yaml_event_t *event) {
  const tp_mark mark = mark_of(event->start_mark);
  const char *text = (const char *)event->data.scalar.value;
  if (strlen(text) != event->data.scalar.length) {
    return tp_refuse(b->message, TP_FAULT_FORMAT, at(b, mark), "a zero byte stands in the text");
  }
  if (wants_key(b)) return take_key(b, text, mark);
  tp_node *node = NULL;
  const tp_status status = attach(b, TP_NODE_SCALAR, mark, &node);
  if (status != TP_OK || node == NULL) return status;
  node->text_offset = event->data.scalar.style != YAML_PLAIN_SCALAR_STYLE;
  node->text = strdup(text);
  return node->text != NULL ? TP_OK : tp_fail_memory(b->message, "the scene");
}

static tp_status enter_collection(builder *b, tp_node_kind kind, tp_mark mark) {
  tp_node *node = NULL;
  if (b->depth == MOST_DEPTH) {
    return tp_refuse(b->message, TP_FAULT_RANGE, at(b, mark), "nested deeper than %d levels",
                     MOST_DEPTH);
  }
  const tp_status status = attach(b, kind, mark, &node);
  if (status == TP_OK && node != NULL) b->within[b->depth++] = node;
  return status;
}

static tp_status take_event(builder *b, const yaml_event_t *event) {
  const tp_mark mark = mark_of(event->start_mark);
  switch (event->type) {
  case YAML_ALIAS_EVENT:
    return tp_refuse(b->message, TP_FAULT_FORMAT, at(b, mark),
                     "aliases are not taken; use a named parameter instead");
  case YAML_SCALAR_EVENT:
    return take_scalar(b, event);
  case YAML_SEQUENCE_START_EVENT:
    return enter_collection(b, TP_NODE_SEQUENCE, mark);
  case YAML_MAPPING_START_EVENT:
    return enter_collection(b, TP_NODE_MAPPING, mark);
  case YAML_SEQUENCE_END_EVENT:
  case YAML_MAPPING_END_EVENT:
    b->depth--;
    return TP_OK;
  case YAML_DOCUMENT_START_EVENT:
    if (b->root == NULL) return TP_OK;
    return tp_refuse(b->message, TP_FAULT_FORMAT, at(b, mark),
                     "a second document begins here; a file holds one scene");
  default:
    return TP_OK;
  }
}

static tp_status parser_failed(builder *b, const yaml_parser_t *parser, const source *from) {
  tp_mark mark = mark_of(parser->problem_mark);
  if (from->failed) return tp_fail_file(b->message, b->path, "read", errno);
  if (from->too_large) {
    return tp_refuse(b->message, TP_FAULT_FORMAT, (tp_place){b->path, 0, 0},
                     "larger than 256 MiB; give long outlines as CSV files");
  }
  if (parser->error == YAML_MEMORY_ERROR) return tp_fail_memory(b->message, "the scene");
  if (parser->error == YAML_READER_ERROR) mark = mark_of(parser->mark);
  return tp_refuse(b->message, TP_FAULT_FORMAT, at(b, mark), "not YAML: %s%s%s",
                   parser->context != NULL ? parser->context : "",
                   parser->context != NULL ? ", " : "",
                   parser->problem != NULL ? parser->problem : "malformed");
}

static tp_status build(builder *b, yaml_parser_t *parser, const source *from) {
  tp_status status = TP_OK;
  bool more = true;
  while (more && status == TP_OK) {
    yaml_event_t event;
    if (!yaml_parser_parse(parser, &event)) return parser_failed(b, parser, from);
    more = event.type != YAML_STREAM_END_EVENT;
    status = take_event(b, &event);
    yaml_event_delete(&event);
  }
  return status;
}

/* Closes the file. */
static tp_status read_file(tp_node **root, FILE *file, const char *path, tp_message *message) {
  builder b = {.path = path, .message = message};
  source from = {.file = file, .path = path};
  yaml_parser_t parser;
  if (!yaml_parser_initialize(&parser)) {
    fclose(from.file);
    return tp_fail_memory(message, "the YAML parser");
  }
  yaml_parser_set_input(&parser, read_bytes, &from);
  tp_status status = build(&b, &parser, &from);
  yaml_parser_delete(&parser);
  fclose(from.file);
  free(b.key);
  if (status == TP_OK && b.root == NULL) {
    status = tp_refuse(message, TP_FAULT_FORMAT, (tp_place){path, 1, 1},
                       "the file is empty; a scene begins with 'topple: 1'");
  }
  if (status == TP_OK) {
    *root = b.root;
  } else {
    tp_node_free(b.root);
  }
  return status;
}

tp_status tp_node_read(tp_node **root, const char *path, tp_message *message) {
  FILE *file = NULL;
  const tp_status status = tp_input_open(&file, path, message);
  return status != TP_OK ? status : read_file(root, file, path, message);
}

tp_status tp_node_read_text(tp_node **root, const char *text, const char *name,
                            tp_message *message) {
  FILE *file = fmemopen((void *)text, strlen(text), "rb"); /* it only reads */
  if (file == NULL) return tp_fail_memory(message, "a scene");
  return read_file(root, file, name, message);
}
