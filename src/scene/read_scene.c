/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A scene file as a whole: units, parameters, tilt and friction. */

#include "host.h"
#include "scene/read.h"

#include "number/ratio.h"
#include "outside.h"

#include <stdlib.h>
#include <string.h>

static const struct {
  const char *name;
  long numerator, denominator; /* metres per unit */
} units[] = {{"mm", 1, 1000}, {"cm", 1, 100},    {"m", 1, 1},
             {"km", 1000, 1}, {"in", 127, 5000}, {"ft", 381, 1250}};

static tp_status read_length_unit(const tp_reader *reader, const tp_node *root) {
  const tp_node *node = tp_node_get(root, "length_unit");
  if (node == NULL) {
    return tp_read_fail(reader, root,
                        "'length_unit' is missing; say one of mm, cm, m, km, in, ft, for example "
                        "'length_unit: mm'");
  }
  for (size_t k = 0; node->kind == TP_NODE_SCALAR && k < sizeof units / sizeof units[0]; k++) {
    if (strcmp(node->text, units[k].name) != 0) continue;
    reader->scene->length_unit = units[k].name;
    fmpq_set_si(reader->scene->metres_per_unit, units[k].numerator,
                (unsigned long)units[k].denominator);
    return TP_OK;
  }
  return tp_read_fail(reader, node, "length_unit must be one of mm, cm, m, km, in, ft");
}

static tp_status read_parameters(const tp_reader *reader, const tp_node *node) {
  tp_parameters *parameters = &reader->scene->parameters;
  if (node == NULL) return TP_OK;
  if (node->kind != TP_NODE_MAPPING) {
    return tp_read_fail(reader, node, "parameters must be a map of names to numbers: {a: 30}");
  }
  parameters->names = calloc((size_t)node->count + 1, sizeof *parameters->names);
  parameters->values = calloc((size_t)node->count + 1, sizeof *parameters->values);
  if (parameters->names == NULL || parameters->values == NULL) {
    return tp_fail_memory(reader->message, "the parameters");
  }
  for (const tp_node *child = node->first; child != NULL; child = child->next) {
    if (!tp_expression_is_name(child->key) || tp_ratio_is_not_finite(child->key)) {
      return tp_read_fail(reader, child,
                          "'%s' cannot name a parameter; a name is made of letters, digits and _",
                          tp_quote_all(child->key).text);
    }
    fmpq_t value;
    fmpq_init(value);
    const tp_status status = tp_read_number(reader, value, child, child->key);
    const long k = parameters->count;
    fmpq_init(parameters->values + k);
    fmpq_swap(parameters->values + k, value);
    fmpq_clear(value);
    parameters->names[k] = status == TP_OK ? strdup(child->key) : NULL;
    parameters->count++;
    if (status != TP_OK) return status;
    if (parameters->names[k] == NULL) return tp_fail_memory(reader->message, "the parameters");
  }
  return TP_OK;
}

static tp_status read_tilt(const tp_reader *reader, const tp_node *node) {
  static const char *const keys[] = {"towards", "angle_deg", NULL};
  tp_scene *scene = reader->scene;
  scene->towards_left = scene->towards_right = true;
  if (node == NULL) return TP_OK;
  scene->tilt_place = tp_node_place(node, scene->path);
  const tp_status status = tp_node_expect_keys(node, keys, "tilt", scene->path, reader->message);
  if (status != TP_OK) return status;
  const tp_node *towards = tp_node_get(node, "towards");
  if (towards != NULL) {
    const char *text = towards->kind == TP_NODE_SCALAR ? towards->text : "";
    scene->towards_left = strcmp(text, "left") == 0 || strcmp(text, "both") == 0;
    scene->towards_right = strcmp(text, "right") == 0 || strcmp(text, "both") == 0;
    if (!scene->towards_left && !scene->towards_right) {
      return tp_read_fail(reader, towards, "towards must be left, right or both");
    }
  }
  return tp_read_angle(reader, &scene->tilt_angle_deg, tp_node_get(node, "angle_deg"), "angle_deg",
                       false);
}

static tp_status read_version(const tp_reader *reader, const tp_node *root) {
  const tp_node *node = tp_node_get(root, "topple");
  if (node == NULL) {
    return tp_read_fail(reader, root, "this is no scene: 'topple: 1' is missing");
  }
  if (node->kind != TP_NODE_SCALAR || strcmp(node->text, "1") != 0) {
    return tp_read_fail(reader, node, "this program reads scenes of version 1: 'topple: 1'");
  }
  return TP_OK;
}

static tp_status read_title(const tp_reader *reader, const tp_node *node) {
  if (node == NULL) return TP_OK;
  if (node->kind != TP_NODE_SCALAR) return tp_read_fail(reader, node, "title must be text");
  reader->scene->title = strdup(node->text);
  return reader->scene->title != NULL ? TP_OK : tp_fail_memory(reader->message, "the scene");
}

static tp_status read_root(const tp_reader *reader, const tp_node *root) {
  static const char *const keys[] = {
      "topple", "title", "length_unit",        "parameters", "block", "base",
      "loads",  "tilt",  "friction_angle_deg", "friction",   "frame", NULL};
  tp_scene *scene = reader->scene;
  const tp_node *block = NULL;
  if (root->kind != TP_NODE_MAPPING) {
    return tp_read_fail(reader, root, "this is no scene: it does not begin with 'topple: 1'");
  }
  tp_status status = read_version(reader, root);
  if (status == TP_OK)
    status = tp_node_expect_keys(root, keys, "the scene", scene->path, reader->message);
  if (status == TP_OK) status = read_title(reader, tp_node_get(root, "title"));
  if (status == TP_OK) status = read_length_unit(reader, root);
  if (status == TP_OK) status = read_parameters(reader, tp_node_get(root, "parameters"));
  if (status == TP_OK)
    status =
        tp_read_required(reader, &block, root, "block", "block: {slab: {width: 50, height: 100}}");
  if (status == TP_OK) status = tp_read_block(reader, block);
  if (status == TP_OK) status = tp_read_base(reader, tp_node_get(root, "base"));
  if (status == TP_OK) status = tp_read_loads(reader, tp_node_get(root, "loads"));
  if (status == TP_OK) status = tp_read_friction(reader, root);
  if (status == TP_OK) status = read_tilt(reader, tp_node_get(root, "tilt"));
  if (status == TP_OK) status = tp_read_frame(reader, tp_node_get(root, "frame"));
  return status == TP_OK ? tp_read_cautions(reader) : status;
}

static tp_scene *new_scene(const char *path) {
  tp_scene *scene = calloc(1, sizeof *scene);
  if (scene == NULL) return NULL;
  scene->path = strdup(path);
  if (scene->path == NULL) {
    free(scene);
    return NULL;
  }
  fmpq_init(scene->metres_per_unit);
  tp_block_description *block = &scene->block;
  fmpq_init(block->teeth.width);
  fmpq_init(block->teeth.height);
  fmpq_init(block->teeth.depth);
  fmpq_init(block->ellipse.width.value);
  fmpq_init(block->ellipse.height.value);
  fmpq_init(block->ellipse.flat.value);
  fmpq_init(block->thickness.value);
  fmpq_init(block->unit_weight_kn_m3.value);
  fmpq_init(scene->base.beyond_left.value);
  fmpq_init(scene->base.beyond_right.value);
  fmpq_init(scene->base.below.value);
  fmpq_init(scene->base.left_of.value);
  fmpq_init(scene->base.right_of.value);
  tp_loads_description_init(&scene->loads);
  fmpq_init(scene->friction_angle_deg.value);
  tp_friction_description_init(&scene->friction);
  fmpq_init(scene->tilt_angle_deg.value);
  return scene;
}

static void clear_block(tp_block_description *block) {
  tp_polyline_clear(&block->outline);
  fmpq_clear(block->teeth.width);
  fmpq_clear(block->teeth.height);
  fmpq_clear(block->teeth.depth);
  fmpq_clear(block->ellipse.width.value);
  fmpq_clear(block->ellipse.height.value);
  fmpq_clear(block->ellipse.flat.value);
  fmpq_clear(block->thickness.value);
  fmpq_clear(block->unit_weight_kn_m3.value);
  for (long k = 0; k < block->hole_count; k++) tp_polyline_clear(block->holes + k);
  for (long k = 0; k < block->part_count; k++) {
    tp_polyline_clear(&block->parts[k].outline);
    fmpq_clear(block->parts[k].unit_weight_kn_m3.value);
  }
  for (long k = 0; k < block->rounded.count; k++) {
    fmpq_clear(block->rounded.corners[k].x.value);
    fmpq_clear(block->rounded.corners[k].y.value);
    fmpq_clear(block->rounded.corners[k].radius.value);
  }
  free(block->rounded.corners);
  tp_arcs_clear(block);
  free(block->holes);
  free(block->parts);
}

void tp_scene_free(tp_scene *scene) {
  if (scene == NULL) return;
  clear_block(&scene->block);
  tp_loads_description_clear(&scene->loads);
  tp_polyline_clear(&scene->base.between);
  tp_polyline_clear(&scene->base.profile);
  tp_polyline_clear(&scene->mean_plane);
  fmpq_clear(scene->base.beyond_left.value);
  fmpq_clear(scene->base.beyond_right.value);
  fmpq_clear(scene->base.below.value);
  fmpq_clear(scene->base.left_of.value);
  fmpq_clear(scene->base.right_of.value);
  fmpq_clear(scene->metres_per_unit);
  fmpq_clear(scene->friction_angle_deg.value);
  tp_friction_description_clear(&scene->friction);
  fmpq_clear(scene->tilt_angle_deg.value);
  for (long k = 0; k < scene->parameters.count; k++) {
    free(scene->parameters.names[k]);
    fmpq_clear(scene->parameters.values + k);
  }
  free(scene->parameters.names);
  free(scene->parameters.values);
  for (long k = 0; k < scene->file_count; k++) free(scene->files[k]);
  free(scene->files);
  tp_notes_clear(&scene->notes);
  if (!scene->borrows_source) tp_node_free(scene->source);
  free(scene->title);
  free(scene->path);
  free(scene);
}

tp_status tp_scene_from_nodes(tp_scene **scene, const char *path, tp_node *root,
                              tp_message *message) {
  tp_scene *read = new_scene(path);
  if (read == NULL) return tp_fail_memory(message, "the scene");
  const tp_reader reader = {read, message};
  read->source = root;
  read->borrows_source = true;
  const tp_status status = read_root(&reader, root);
  if (status == TP_OK) {
    *scene = read;
  } else {
    tp_scene_free(read);
  }
  return status;
}

/* The scene owns its nodes, or they go with it. */
static tp_status keep_nodes(tp_scene **scene, const char *path, tp_node *root,
                            tp_message *message) {
  tp_scene *read = NULL;
  const tp_status status = tp_scene_from_nodes(&read, path, root, message);
  if (status == TP_OK && read != NULL) {
    read->borrows_source = false;
    *scene = read;
  } else {
    tp_node_free(root);
  }
  return status;
}

tp_status tp_scene_read(tp_scene **scene, const char *path, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  TP_REFUSE_NULL(message, path);
  tp_node *root = NULL;
  const tp_status status = tp_node_read(&root, path, message);
  return status == TP_OK ? keep_nodes(scene, path, root, message) : status;
}

tp_status tp_scene_read_text(tp_scene **scene, const char *text, const char *name,
                             tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  TP_REFUSE_NULL(message, text);
  TP_REFUSE_NULL(message, name);
  tp_node *root = NULL;
  const tp_status status = tp_node_read_text(&root, text, name, message);
  return status == TP_OK ? keep_nodes(scene, name, root, message) : status;
}
