/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Numbers, points and truth values out of nodes, exact, each complaint with its place. */

#include "scene_reading/read.h"

#include "common/outside.h"
#include "scene/setting.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

tp_status tp_read_fail(const tp_reader *reader, tp_fault fault, const tp_node *node,
                       const char *format, ...) {
  char text[800];
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
  return tp_refuse(reader->message, fault, tp_node_place(node, reader->scene->path), "%s", text);
}

tp_place tp_read_place(const tp_reader *reader, const tp_node *node) {
  const tp_override *own = tp_scene_override(reader->scene, node);
  return own != NULL && own->setting != NULL ? (tp_place){own->setting, 0, 0}
                                             : tp_node_place(node, reader->scene->path);
}

/* Without a letter no parameter stands in it; what has an exponent may be thought to name one. */
static bool may_name(const char *text) {
  return text[strspn(text, "0123456789.+-*/^() \t")] != '\0';
}

/* As if its formula stood in the file. */
static tp_status evaluate_setting(const tp_reader *reader, tp_override *own) {
  return tp_setting_evaluate(own->value, own->setting, &reader->scene->parameters, reader->message);
}

/* What the scene has instead of the text; else what it says. */
static tp_status read_text(const tp_reader *reader, fmpq_t value, const tp_node *node) {
  tp_scene *scene = reader->scene;
  for (long k = 0; k < scene->override_count; k++) {
    tp_override *own = scene->overrides + k;
    if (own->node != node) continue;
    own->used = reader->reading->varies = true;
    const tp_status status = own->setting != NULL ? evaluate_setting(reader, own) : TP_OK;
    if (status == TP_OK) fmpq_set(value, own->value);
    return status;
  }
  tp_place place = tp_node_place(node, scene->path);
  place.column += node->text_offset;
  if (scene->parameters.count > 0 && may_name(node->text)) reader->reading->varies = true;
  return tp_expression_evaluate(value, node->text, place, &scene->parameters, reader->message);
}

tp_status tp_read_number(const tp_reader *reader, fmpq_t value, const tp_node *node,
                         const char *name) {
  if (node->kind != TP_NODE_SCALAR) {
    return tp_read_fail(reader, TP_FAULT_FORMAT, node, "%s must be a number, not a list or a map",
                        tp_quote_all(name).text);
  }
  const tp_status status = read_text(reader, value, node);
  if (status != TP_OK) return status;
  return tp_check_range(value, name, tp_read_place(reader, node), reader->message);
}

tp_status tp_read_by_rule(const tp_reader *reader, fmpq_t value, const tp_node *node,
                          const char *name, tp_rule rule) {
  const tp_status status = tp_read_number(reader, value, node, name);
  if (status != TP_OK) return status;
  return tp_check_rule(rule, value, name, tp_read_place(reader, node), reader->message);
}

tp_status tp_read_quantity(const tp_reader *reader, tp_quantity *quantity, const tp_node *node,
                           const char *name, tp_rule rule) {
  if (node == NULL) return TP_OK;
  const tp_status status = tp_read_by_rule(reader, quantity->value, node, name, rule);
  if (status == TP_OK) {
    quantity->given = true;
    quantity->place = tp_read_place(reader, node);
  }
  return status;
}

tp_status tp_read_keys(const tp_reader *reader, const tp_node *node, const tp_key_map *map,
                       const char *what) {
  return tp_node_expect_keys(node, map->keys, what, reader->scene->path, reader->message);
}

tp_status tp_read_bool(const tp_reader *reader, bool *value, const tp_node *node,
                       const char *name) {
  if (node->kind == TP_NODE_SCALAR && strcmp(node->text, "true") == 0) {
    *value = true;
  } else if (node->kind == TP_NODE_SCALAR && strcmp(node->text, "false") == 0) {
    *value = false;
  } else {
    return tp_read_fail(reader, TP_FAULT_FORMAT, node, "%s must be true or false", name);
  }
  return TP_OK;
}

static tp_status miss(const tp_reader *reader, const tp_node *map, const char *key,
                      const char *example) {
  return tp_read_fail(reader, TP_FAULT_KEY, map, "'%s' is missing here, for example '%s'", key,
                      example);
}

static tp_status read_value(const tp_reader *reader, void *value, const tp_node *map,
                            const tp_key_value *own) {
  const tp_node *node = tp_node_get(map, own->key);
  if (node == NULL && own->example != NULL) return miss(reader, map, own->key, own->example);
  if (node == NULL) return TP_OK;
  switch (own->kind) {
  case TP_KEY_QUANTITY:
    return tp_read_quantity(reader, value, node, own->key, own->rule);
  case TP_KEY_NUMBER:
    return tp_read_by_rule(reader, *(fmpq_t *)value, node, own->key, own->rule);
  case TP_KEY_TRUTH:
    break;
  }
  return tp_read_bool(reader, value, node, own->key);
}

tp_status tp_read_values(const tp_reader *reader, void *of, const tp_node *node,
                         const tp_key_map *map) {
  tp_status status = TP_OK;
  for (size_t k = 0; k < map->count && status == TP_OK; k++) {
    const tp_key_value *own = map->values + k;
    status = read_value(reader, (char *)of + own->offset, node, own);
  }
  return status;
}

tp_status tp_read_map(const tp_reader *reader, void *of, const tp_node *node, const tp_key_map *map,
                      const char *what) {
  const tp_status status = tp_read_keys(reader, node, map, what);
  return status == TP_OK ? tp_read_values(reader, of, node, map) : status;
}

tp_status tp_read_required(const tp_reader *reader, const tp_node **child, const tp_node *mapping,
                           const char *key, const char *example) {
  *child = tp_node_get(mapping, key);
  if (*child != NULL) return TP_OK;
  return miss(reader, mapping, key, example);
}

tp_status tp_read_point(const tp_reader *reader, tp_quantity *x, tp_quantity *y,
                        const tp_node *node, const char *name) {
  if (node->kind != TP_NODE_SEQUENCE || node->count != 2) {
    return tp_read_fail(reader, TP_FAULT_FORMAT, node, "'%s' is a point, written [x, y]", name);
  }
  const tp_status status = tp_read_quantity(reader, x, node->first, "x", TP_RULE_ANY);
  return status == TP_OK ? tp_read_quantity(reader, y, node->last, "y", TP_RULE_ANY) : status;
}
