/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Numbers, points and truth values out of nodes, exact, each complaint with its place. */

#include "scene/read.h"

#include "outside.h"
#include "scene/csv.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

tp_status tp_read_fail(const tp_reader *reader, const tp_node *node, const char *format, ...) {
  char text[800];
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
  return tp_fail(reader->message, TP_BAD_INPUT, tp_node_place(node, reader->scene->path), "%s",
                 text);
}

tp_place tp_read_place(const tp_reader *reader, const tp_node *node) {
  return tp_node_place(node, reader->scene->path);
}

tp_status tp_read_number(const tp_reader *reader, fmpq_t value, const tp_node *node,
                         const char *name) {
  if (node->kind != TP_NODE_SCALAR) {
    return tp_read_fail(reader, node, "%s must be a number, not a list or a map",
                        tp_quote_all(name).text);
  }
  tp_place place = tp_node_place(node, reader->scene->path);
  place.column += node->text_offset;
  const tp_status status =
      tp_expression_evaluate(value, node->text, place, &reader->scene->parameters, reader->message);
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

tp_status tp_read_bool(const tp_reader *reader, bool *value, const tp_node *node,
                       const char *name) {
  if (node->kind == TP_NODE_SCALAR && strcmp(node->text, "true") == 0) {
    *value = true;
  } else if (node->kind == TP_NODE_SCALAR && strcmp(node->text, "false") == 0) {
    *value = false;
  } else {
    return tp_read_fail(reader, node, "%s must be true or false", name);
  }
  return TP_OK;
}

tp_status tp_read_required(const tp_reader *reader, const tp_node **child, const tp_node *mapping,
                           const char *key, const char *example) {
  *child = tp_node_get(mapping, key);
  if (*child != NULL) return TP_OK;
  return tp_read_fail(reader, mapping, "'%s' is missing here, for example '%s'", key, example);
}

/* A file name that a scene gives, relative to the scene's folder; kept by the scene. */
static const char *keep_path(tp_scene *scene, const char *name) {
  const char *slash = strrchr(scene->path, '/');
  const size_t folder = name[0] == '/' || slash == NULL ? 0 : (size_t)(slash - scene->path) + 1;
  char **files = realloc(scene->files, ((size_t)scene->file_count + 1) * sizeof *files);
  if (files == NULL) return NULL;
  scene->files = files;
  char *path = malloc(folder + strlen(name) + 1);
  if (path == NULL) return NULL;
  memcpy(path, scene->path, folder);
  strcpy(path + folder, name);
  files[scene->file_count++] = path;
  return path;
}

tp_status tp_read_point(const tp_reader *reader, tp_quantity *x, tp_quantity *y,
                        const tp_node *node, const char *name) {
  if (node->kind != TP_NODE_SEQUENCE || node->count != 2) {
    return tp_read_fail(reader, node, "'%s' is a point, written [x, y]", name);
  }
  const tp_status status = tp_read_quantity(reader, x, node->first, "x", TP_RULE_ANY);
  return status == TP_OK ? tp_read_quantity(reader, y, node->last, "y", TP_RULE_ANY) : status;
}

static tp_status read_vertex(const tp_reader *reader, tp_polyline *line, const tp_node *node,
                             const char *name) {
  if (node->kind != TP_NODE_SEQUENCE || node->count != 2) {
    return tp_read_fail(reader, node, "a vertex of %s is written [x, y]", name);
  }
  fmpq_t x, y;
  fmpq_init(x);
  fmpq_init(y);
  tp_status status = tp_read_number(reader, x, node->first, "x");
  if (status == TP_OK) status = tp_read_number(reader, y, node->last, "y");
  if (status == TP_OK && !tp_polyline_append(line, x, y, node->mark)) {
    status = tp_fail_memory(reader->message, name);
  }
  fmpq_clear(x);
  fmpq_clear(y);
  return status;
}

tp_status tp_read_points(const tp_reader *reader, tp_polyline *line, const tp_node *node,
                         bool closed, const char *name) {
  tp_polyline points = {.file = reader->scene->path, .mark = node->mark};
  tp_status status = TP_OK;
  if (node->kind == TP_NODE_SCALAR) {
    const char *path = keep_path(reader->scene, node->text);
    if (path == NULL) return tp_fail_memory(reader->message, name);
    status = tp_csv_read(&points, path, closed, &reader->scene->notes, reader->message);
  } else if (node->kind == TP_NODE_SEQUENCE) {
    for (const tp_node *p = node->first; p != NULL && status == TP_OK; p = p->next) {
      status = read_vertex(reader, &points, p, name);
    }
    if (closed) tp_polyline_drop_closing_point(&points);
  } else {
    status =
        tp_read_fail(reader, node, "%s must be a list of [x, y] or the name of a CSV file", name);
  }
  if (status == TP_OK) {
    *line = points;
  } else {
    tp_polyline_clear(&points);
  }
  return status;
}
