/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The scene of a row: the tree of the file that it is over, or an empty one, with the cells of the
 * row as scalars at their keys. */

#include "common/outside.h"
#include "survey/tree.h"

#include <stdlib.h>
#include <string.h>

/* ---- the side that it dips to ------------------------------------------------------------------
 */

/* Has the map none but these keys (which end with NULL)? */
static bool has_only(const tp_node *map, const char *const *keys) {
  if (map != NULL && map->kind != TP_NODE_MAPPING) return false;
  for (const tp_node *child = map != NULL ? map->first : NULL; child != NULL; child = child->next) {
    size_t k = 0;
    while (keys[k] != NULL && strcmp(keys[k], child->key) != 0) k++;
    if (keys[k] == NULL) return false;
  }
  return true;
}

static bool loads_have_no_side(const tp_node *root) {
  static const char *const of_loads[] = {"seismic", "water", "cohesion_kpa", "bond_kpa", NULL};
  static const char *const of_water[] = {"height", "uplift", "stays_level", "unit_weight_kn_m3",
                                         NULL};
  const tp_node *loads = tp_node_get(root, "loads");
  return has_only(loads, of_loads) && has_only(tp_node_get(loads, "water"), of_water);
}

/* What a case sets by its keys is among the numbers of the scene. */
static bool cases_have_no_side(const tp_node *cases) {
  static const char *const of_case[] = {
      "name", "required_fos", "partial_factors", "friction_angle_deg", "set", "loads", NULL};
  const tp_node *own = cases != NULL ? cases->first : NULL;
  while (own != NULL && own->kind == TP_NODE_MAPPING && has_only(own, of_case) &&
         loads_have_no_side(own)) {
    own = own->next;
  }
  return own == NULL;
}

/* Is the scene its own mirror image, by what it has? A key that is not listed here may have a side.
 */
static bool has_no_side(const tp_node *root) {
  static const char *const of_root[] = {
      "topple",          "title", "length_unit", "result_units",       "parameters",
      "block",           "slope", "loads",       "friction_angle_deg", "required_fos",
      "partial_factors", "cases", NULL};
  static const char *const of_block[] = {"slab", "thickness", "unit_weight_kn_m3", NULL};
  return has_only(root, of_root) && has_only(tp_node_get(root, "block"), of_block) &&
         tp_node_get(tp_node_get(root, "block"), "slab") != NULL && loads_have_no_side(root) &&
         cases_have_no_side(tp_node_get(root, "cases"));
}

/* Such a slab dips to the right where no side is named. */
static tp_status choose_side(tp_node *root, tp_message *message) {
  const tp_node *slope = tp_node_get(root, "slope");
  if (tp_node_get(slope, "dip_deg") == NULL || tp_node_get(slope, "towards") != NULL) return TP_OK;
  if (!has_no_side(root)) return TP_OK;
  return tp_tree_put(root, "slope.towards", "right", slope->mark, message);
}

/* ---- a row -------------------------------------------------------------------------------------
 */

/* More cells than the head has names. */
static tp_status check_width(const tp_survey *survey, size_t row, tp_message *message) {
  const size_t count = survey->cells.rows[row].count;
  for (size_t k = 0; k < count; k++) {
    const bool named = k < survey->column_count && survey->columns[k].head[0] != '\0';
    if (named || tp_cells_text(&survey->cells, row, k)[0] == '\0') continue;
    return tp_refuse(message, TP_FAULT_FORMAT, (tp_place){0},
                     "cell %zu, '%s', stands below no name; name its column, or put text with the "
                     "separator in it in quotes",
                     k + 1, tp_quote_all(tp_cells_text(&survey->cells, row, k)).text);
  }
  return TP_OK;
}

static bool is_scene_name(const char *name) {
  const char *ending = strrchr(name, '.');
  return ending != NULL && (strcmp(ending, ".yaml") == 0 || strcmp(ending, ".yml") == 0);
}

/* The file that the row is over, beside the table where the row names it; NULL: none. */
static tp_status choose_scene(char **path, const tp_survey *survey, size_t row,
                              tp_message *message) {
  const char *cell = tp_survey_cell(survey, row, TP_COLUMN_SCENE);
  if (cell != NULL && !is_scene_name(cell)) {
    return tp_refuse(message, TP_FAULT_KEY, (tp_place){0},
                     "'%s' is no scene; it ends in .yaml, and a drawing stands in a column outline",
                     tp_quote_all(cell).text);
  }
  const char *slash = strrchr(survey->path, '/');
  const size_t folder =
      cell != NULL && cell[0] != '/' && slash != NULL ? (size_t)(slash - survey->path) + 1 : 0;
  const char *name = cell != NULL ? cell : survey->scene;
  *path = NULL;
  if (name == NULL) return TP_OK;
  *path = calloc(folder + strlen(name) + 1, 1);
  if (*path == NULL) return tp_fail_memory(message, "the scene of a row");
  memcpy(*path, survey->path, folder);
  strcpy(*path + folder, name);
  return TP_OK;
}

static tp_status make_root(tp_node **root, const char *path, const tp_survey *survey, size_t row,
                           tp_message *message) {
  if (survey->root != NULL && tp_survey_cell(survey, row, TP_COLUMN_SCENE) == NULL) {
    *root = tp_tree_copy(NULL, survey->root);
    return *root != NULL ? TP_OK : tp_fail_memory(message, "the scene of a row");
  }
  if (path != NULL) return tp_node_read(root, path, message);
  *root = tp_node_add(NULL, NULL, TP_NODE_MAPPING, NULL);
  if (*root != NULL && tp_node_add(*root, "topple", TP_NODE_SCALAR, "1") != NULL) return TP_OK;
  return tp_fail_memory(message, "the scene of a row");
}

static tp_status fill(tp_node *root, tp_row_faults *faults, const tp_survey *survey, size_t row,
                      const char *scene, tp_message *message) {
  if (root->kind != TP_NODE_MAPPING) {
    return tp_refuse(message, TP_FAULT_FORMAT, (tp_place){scene, 0, 0},
                     "this is not a scene: it does not begin with 'topple: 1'");
  }
  tp_status status = tp_survey_put_outline(root, survey, row, scene, message);
  if (status == TP_OK) status = tp_survey_put_cells(root, faults, survey, row, message);
  return status == TP_OK ? choose_side(root, message) : status;
}

tp_status tp_survey_scene(tp_scene_text *text, tp_row_faults *faults, const tp_survey *survey,
                          size_t row, tp_message *message) {
  tp_node *root = NULL;
  tp_status status = check_width(survey, row, message);
  if (status == TP_OK) status = choose_scene(&text->name, survey, row, message);
  if (status != TP_OK) return status;
  status = make_root(&root, text->name, survey, row, message);
  if (text->name == NULL) text->name = strdup(survey->path);
  if (status == TP_OK && text->name == NULL) {
    status = tp_fail_memory(message, "the scene of a row");
  }
  if (status == TP_OK) status = fill(root, faults, survey, row, text->name, message);
  if (status == TP_OK && !tp_scene_text_write(text, root)) {
    status = tp_fail_memory(message, "the scene of a row");
  }
  tp_node_free(root);
  return status;
}
