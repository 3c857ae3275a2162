/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A file with an outline, a drawing or a mesh as the block of a row. */

#include "format/mesh.h"
#include "format/read.h"
#include "survey/tree.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static size_t column_of(const tp_survey *survey, tp_column_kind kind) {
  size_t k = 0;
  while (k < survey->column_count && survey->columns[k].kind != kind) k++;
  return k;
}

static size_t folder_length(const char *path) {
  const char *slash = strrchr(path, '/');
  return slash != NULL ? (size_t)(slash - path) + 1 : 0;
}

/* The name of a file beside the table, as the scene has to call it, which is beside `scene`; to be
 * freed. Where the two lie in different folders it is the whole way to it. */
static char *name_from(const char *scene, const tp_survey *survey, const char *name) {
  const size_t folder = folder_length(survey->path), of_scene = folder_length(scene);
  if (name[0] == '/' || (folder == of_scene && strncmp(survey->path, scene, folder) == 0)) {
    return strdup(name);
  }
  char *own = strndup(folder > 0 ? survey->path : ".", folder > 0 ? folder : 1);
  char *whole = own != NULL ? realpath(own, NULL) : NULL;
  free(own);
  if (whole == NULL) return NULL;
  const size_t size = strlen(whole) + strlen(name) + 2;
  char *path = malloc(size);
  if (path != NULL) snprintf(path, size, "%s/%s", whole, name);
  free(whole);
  return path;
}

/* The outline takes the place of the block's form. */
tp_status tp_survey_put_outline(tp_node *root, const tp_survey *survey, size_t row,
                                const char *scene, tp_message *message) {
  static const char *const forms[] = {"slab", "teeth", "ellipse", "outline", "arcs"};
  const char *cell = tp_survey_cell(survey, row, TP_COLUMN_OUTLINE);
  if (cell == NULL) return TP_OK;
  const size_t column = column_of(survey, TP_COLUMN_OUTLINE);
  tp_node *block = tp_tree_child(root, "block", strlen("block"));
  for (size_t k = 0; block != NULL && block->kind == TP_NODE_MAPPING && k < 5; k++) {
    tp_tree_drop(block, forms[k]);
  }
  char *name = name_from(scene, survey, cell);
  if (name == NULL) return tp_fail_memory(message, "the scene of a row");
  const bool drawing = tp_drawing_is_named(cell), mesh = tp_mesh_format_of(cell) != TP_MESH_NONE;
  const tp_status status = tp_tree_put(root,
                                       drawing ? "drawing.file"
                                       : mesh  ? "block.outline.mesh"
                                               : "block.outline",
                                       name, tp_mark_of_column(column), message);
  free(name);
  return status;
}
