/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Many blocks out of a drawing: each closed outline on one of their layers, or of ground. A block
 * is called by its layer and its number there, in the order of the drawing; ground is `ground`. */

#include "scene_reading/read.h"

#include "common/outside.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

enum { MOST_NAME = 160 };
static const char *const keys[] = {"blocks", "ground"};

/* A layer, or a list of them. */
static const tp_node *first_layer(const tp_node *drawing, const char *key) {
  const tp_node *node = tp_node_get(drawing, key);
  return node != NULL && node->kind == TP_NODE_SEQUENCE ? node->first : node;
}

static bool is_list(const tp_node *drawing, const char *key) {
  const tp_node *node = tp_node_get(drawing, key);
  return node != NULL && node->kind == TP_NODE_SEQUENCE;
}

/* Ground has a name where none is said. */
long tp_drawn_layer_count(const tp_node *drawing, const char *key) {
  const tp_node *node = tp_node_get(drawing, key);
  if (node == NULL) return strcmp(key, "ground") == 0;
  return node->kind == TP_NODE_SEQUENCE ? node->count : 1;
}

tp_status tp_read_drawn_layers(const tp_reader *reader, const char **layers,
                               const tp_node *drawing) {
  static const char *const others[] = {"block", "base", "hole", "part", NULL};
  const tp_node *other = tp_node_first_of(drawing, others);
  if (other != NULL) {
    return tp_read_fail(reader, TP_FAULT_KEY, other,
                        "a drawing is of one block, by its 'block' and 'base', or of many, by "
                        "'blocks' and 'ground': leave out '%s'",
                        other->key);
  }
  const tp_node *blocks = NULL;
  const tp_status status =
      tp_read_required(reader, &blocks, drawing, "blocks", "blocks: [ROCK, CLAY]");
  if (status != TP_OK) return status;
  long count = 0;
  for (int k = 0; k < 2; k++) {
    const tp_node *n = first_layer(drawing, keys[k]);
    if (n == NULL) layers[count++] = "GROUND";
    for (; n != NULL; n = is_list(drawing, keys[k]) ? n->next : NULL) {
      if (n->kind != TP_NODE_SCALAR || n->text[0] == '\0') {
        return tp_read_fail(reader, TP_FAULT_FORMAT, n,
                            "'%s' is a layer of the drawing, or a list of layers: [ROCK, CLAY]",
                            keys[k]);
      }
      layers[count++] = n->text;
    }
  }
  return TP_OK;
}

long tp_drawn_layer_of(const tp_node *drawing, const char *name) {
  long number = 0;
  for (int k = 0; k < 2; k++) {
    const tp_node *n = first_layer(drawing, keys[k]);
    if (n == NULL && ++number > 0 && strcasecmp(name, "GROUND") == 0) return number;
    for (; n != NULL; n = is_list(drawing, keys[k]) ? n->next : NULL) {
      number++;
      if (n->kind == TP_NODE_SCALAR && strcasecmp(name, n->text) == 0) return number;
    }
  }
  return 0;
}

static char *name_of(const char *layer, bool ground, long number) {
  char text[MOST_NAME];
  if (!ground) {
    snprintf(text, sizeof text, "%s %ld", tp_quote_all(layer).text, number);
  } else if (number == 1) {
    snprintf(text, sizeof text, "ground");
  } else {
    snprintf(text, sizeof text, "ground %ld", number);
  }
  return strdup(text);
}

/* The outlines of a drawing as blocks; `counts` are of its layers, of which all of ground are one.
 */
static tp_status list_parts(const tp_reader *reader, long block_layers, long *counts,
                            const tp_quantity *unit_weight) {
  tp_scene *scene = reader->scene;
  const tp_drawn *drawn = scene->drawn;
  for (long k = 0; k < drawn->part_count; k++) {
    const tp_polyline *outline = drawn->parts + k;
    const tp_place place = {drawn->path, outline->mark.line, outline->mark.column};
    const bool ground = drawn->part_words[k] >= block_layers;
    tp_listed_block *own = tp_scene_next_block(scene, place, unit_weight);
    own->fixed = ground;
    own->layer = drawn->part_words[k] + 1;
    own->name = name_of(drawn->part_layers[k], ground,
                        ++counts[ground ? block_layers : drawn->part_words[k]]);
    scene->block.form = TP_OUTLINE_VERTICES;
    scene->block.outline = tp_polyline_share(outline);
    tp_scene_list_block(scene, own);
    if (own->name == NULL) return tp_fail_memory(reader->message, "the blocks");
  }
  return TP_OK;
}

tp_status tp_read_drawn_blocks(const tp_reader *reader, const tp_node *drawing,
                               const tp_quantity *unit_weight) {
  tp_block_list *many = &reader->scene->many;
  const long block_layers = tp_drawn_layer_count(drawing, "blocks");
  long *counts = calloc((size_t)block_layers + 1, sizeof *counts);
  many->blocks = calloc((size_t)reader->scene->drawn->part_count + 1, sizeof *many->blocks);
  const bool room = counts != NULL && many->blocks != NULL;
  const tp_status status = room ? list_parts(reader, block_layers, counts, unit_weight)
                                : tp_fail_memory(reader->message, "the blocks");
  free(counts);
  return status;
}
