/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Names of blocks sorted once, and found by halving. */

#include "scene/block_names.h"

#include "common/nearest.h"
#include "common/outside.h"

#include <stdlib.h>
#include <string.h>

static int compare_names(const void *first, const void *second) {
  const tp_block_name *a = first, *b = second;
  const int order = strcmp(a->name, b->name);
  return order != 0 ? order : (a->number > b->number) - (a->number < b->number);
}

static int compare_name(const void *name, const void *item) {
  return strcmp(name, ((const tp_block_name *)item)->name);
}

static tp_status check_names(const tp_scene *scene, const tp_block_name *names,
                             tp_message *message) {
  const tp_block_list *many = &scene->many;
  for (long k = 1; k < many->count; k++) {
    if (strcmp(names[k - 1].name, names[k].name) != 0) continue;
    return tp_refuse(message, TP_FAULT_KEY, many->blocks[names[k].number].place,
                     "two blocks are named '%s', the first %s %d; give each a name of its own",
                     tp_quote_all(names[k].name).text,
                     scene->source != NULL ? "in line" : "is block",
                     many->blocks[names[k - 1].number].place.line);
  }
  return TP_OK;
}

tp_status tp_block_names_sort(tp_block_name **names, const tp_scene *scene, tp_message *message) {
  const tp_block_list *many = &scene->many;
  tp_block_name *own = calloc((size_t)many->count + 1, sizeof *own);
  if (own == NULL) return tp_fail_memory(message, "the blocks");
  for (long k = 0; k < many->count; k++) own[k] = (tp_block_name){many->blocks[k].name, k};
  qsort(own, (size_t)many->count, sizeof *own, compare_names);
  const tp_status status = check_names(scene, own, message);
  if (status == TP_OK) {
    *names = own;
  } else {
    free(own);
  }
  return status;
}

/* The name nearest to one that is none; NULL: none is near. */
static const char *nearest_of(const tp_scene *scene, const char *text, const tp_block_name *names) {
  const char *best = NULL;
  size_t least = tp_word_reach(text);
  for (long k = 0; k < scene->many.count; k++) {
    const size_t away = tp_word_distance(text, names[k].name);
    if (away >= least) continue;
    least = away;
    best = names[k].name;
  }
  return best;
}

bool tp_block_name_is(const tp_scene *scene, const char *name, const tp_block_name *names) {
  return bsearch(name, names, (size_t)scene->many.count, sizeof *names, compare_name) != NULL;
}

tp_status tp_block_name_find(long *number, const tp_scene *scene, const tp_node *node,
                             const tp_block_name *names, tp_message *message) {
  const char *text = node->kind == TP_NODE_SCALAR ? node->text : "";
  const tp_block_name *found =
      bsearch(text, names, (size_t)scene->many.count, sizeof *names, compare_name);
  if (found != NULL) {
    *number = found->number;
    return TP_OK;
  }
  const char *near = nearest_of(scene, text, names);
  const tp_place place = tp_node_place(node, scene->path);
  if (near == NULL) {
    return tp_refuse(message, TP_FAULT_KEY, place, "no block is named '%s'",
                     tp_quote_all(text).text);
  }
  return tp_refuse(message, TP_FAULT_KEY, place, "no block is named '%s'; did you mean '%s'?",
                   tp_quote_all(text).text, tp_quote_all(near).text);
}
