/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Reads a scene file as a whole: version, units, parameters, then section by section in fixed
 * order, and checks that every override was used. */

#include "scene/anchor.h"
#include "scene/check_tilt_test.h"
#include "scene_reading/read.h"

#include "common/outside.h"
#include "number/ratio.h"

#include <stdlib.h>
#include <string.h>

static tp_status read_length_unit(const tp_reader *reader, const tp_node *root) {
  const tp_node *node = tp_node_get(root, "length_unit");
  if (node == NULL && tp_node_get(root, "drawing") != NULL) return TP_OK; /* the drawing's */
  if (node == NULL) {
    return tp_read_fail(reader, TP_FAULT_UNIT, root,
                        "'length_unit' is missing; say one of mm, cm, m, km, in, ft, for example "
                        "'length_unit: mm'");
  }
  return tp_scene_use_unit(reader->scene, node->kind == TP_NODE_SCALAR ? node->text : "",
                           tp_read_place(reader, node), reader->message);
}

static tp_status read_parameters(const tp_reader *reader, const tp_node *node) {
  tp_parameters *parameters = &reader->scene->parameters;
  if (node == NULL) return TP_OK;
  if (node->kind != TP_NODE_MAPPING) {
    return tp_read_fail(reader, TP_FAULT_FORMAT, node,
                        "parameters must be a map of names to numbers: {a: 30}");
  }
  parameters->names = calloc((size_t)node->count + 1, sizeof *parameters->names);
  parameters->values = calloc((size_t)node->count + 1, sizeof *parameters->values);
  if (parameters->names == NULL || parameters->values == NULL) {
    return tp_fail_memory(reader->message, "the parameters");
  }
  for (const tp_node *child = node->first; child != NULL; child = child->next) {
    if (!tp_expression_is_name(child->key) || tp_ratio_is_not_finite(child->key)) {
      return tp_read_fail(reader, TP_FAULT_KEY, child,
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
  tp_scene *scene = reader->scene;
  if (node == NULL) return TP_OK;
  scene->tilt_place = tp_node_place(node, scene->path);
  const tp_status status = tp_read_keys(reader, node, &tp_key_map_tilt, "tilt");
  if (status != TP_OK) return status;
  const tp_node *towards = tp_node_get(node, "towards");
  if (towards != NULL) {
    const char *text = towards->kind == TP_NODE_SCALAR ? towards->text : "";
    scene->towards_left = strcmp(text, "left") == 0 || strcmp(text, "both") == 0;
    scene->towards_right = strcmp(text, "right") == 0 || strcmp(text, "both") == 0;
    if (!scene->towards_left && !scene->towards_right) {
      return tp_read_fail(reader, TP_FAULT_KEY, towards, "towards must be left, right or both");
    }
  }
  return tp_read_values(reader, scene, node, &tp_key_map_tilt);
}

static tp_status read_version(const tp_reader *reader, const tp_node *root) {
  const tp_node *node = tp_node_get(root, "topple");
  if (node == NULL) {
    return tp_read_fail(reader, TP_FAULT_KEY, root, "this is not a scene: 'topple: 1' is missing");
  }
  if (node->kind != TP_NODE_SCALAR || strcmp(node->text, "1") != 0) {
    return tp_read_fail(reader, TP_FAULT_FORMAT, node,
                        "this program reads scenes of version 1: 'topple: 1'");
  }
  return TP_OK;
}

static tp_status read_title(const tp_reader *reader, const tp_node *node) {
  if (node == NULL) return TP_OK;
  if (node->kind != TP_NODE_SCALAR)
    return tp_read_fail(reader, TP_FAULT_KEY, node, "title must be text");
  reader->scene->title = strdup(node->text);
  return reader->scene->title != NULL ? TP_OK : tp_fail_memory(reader->message, "the scene");
}

/* The block may be all in a drawing. */
static tp_status read_block(const tp_reader *reader, const tp_node *root) {
  const tp_node *block = tp_node_get(root, "block");
  if (block == NULL && reader->scene->drawn != NULL) {
    block = tp_node_get(root, "drawing");
  } else {
    const tp_status status =
        tp_read_required(reader, &block, root, "block", "block: {slab: {width: 50, height: 100}}");
    if (status != TP_OK) return status;
  }
  return tp_read_block(reader, block);
}

/* The block on its base, the blocks, or a solid. */
static tp_status read_bodies(const tp_reader *reader, const tp_node *root) {
  const tp_node *joints = tp_node_get(root, "joints");
  if (tp_node_get(root, "solid") != NULL) return tp_read_solid(reader, root);
  if (tp_read_blocks_given(root) != NULL) return tp_read_blocks(reader, root);
  if (joints != NULL) {
    return tp_read_fail(reader, TP_FAULT_KEY, joints,
                        "'joints' are between the blocks of 'blocks', which this scene has not");
  }
  tp_status status = read_block(reader, root);
  if (status == TP_OK) status = tp_read_base(reader, tp_node_get(root, "base"));
  if (status == TP_OK) status = tp_read_contact(reader, tp_node_get(root, "contact"));
  return status == TP_OK ? tp_read_joint(reader, tp_node_get(root, "joint")) : status;
}

static tp_status read_root(const tp_reader *reader, const tp_node *root) {
  tp_scene *scene = reader->scene;
  if (root->kind != TP_NODE_MAPPING) {
    return tp_read_fail(reader, TP_FAULT_FORMAT, root,
                        "this is not a scene: it does not begin with 'topple: 1'");
  }
  tp_status status = read_version(reader, root);
  if (status == TP_OK) status = tp_read_keys(reader, root, &tp_key_map_scene, "the scene");
  if (status == TP_OK) status = read_title(reader, tp_node_get(root, "title"));
  if (status == TP_OK) status = read_length_unit(reader, root);
  if (status == TP_OK) status = tp_read_result_units(reader, tp_node_get(root, "result_units"));
  if (status == TP_OK) status = tp_read_report(reader, tp_node_get(root, "report"));
  if (status == TP_OK) status = read_parameters(reader, tp_node_get(root, "parameters"));
  if (status == TP_OK) status = tp_read_drawing(reader, tp_node_get(root, "drawing"));
  if (status == TP_OK) status = read_bodies(reader, root);
  if (status == TP_OK) status = tp_read_loads(reader, tp_node_get(root, "loads"));
  if (status == TP_OK) status = tp_read_block_loads(reader, root);
  if (status == TP_OK) status = tp_read_values(reader, scene, root, &tp_key_map_scene);
  if (status == TP_OK) status = tp_read_friction(reader, root);
  if (status == TP_OK) {
    status = tp_read_partial_factors(reader, tp_node_get(root, "partial_factors"));
  }
  if (status == TP_OK) status = tp_read_load_cases(reader, tp_node_get(root, "cases"));
  if (status == TP_OK) status = tp_check_contact_width(reader->scene, reader->message);
  if (status == TP_OK) status = read_tilt(reader, tp_node_get(root, "tilt"));
  if (status == TP_OK) status = tp_read_frame(reader, tp_node_get(root, "frame"));
  if (status == TP_OK) status = tp_read_slope(reader, tp_node_get(root, "slope"));
  if (status == TP_OK) status = tp_check_solid_keys(reader, root);
  if (status == TP_OK) status = tp_check_block_shaking(scene, reader->message);
  if (status == TP_OK) status = tp_anchors_check(scene, reader->message);
  if (status == TP_OK) status = tp_read_tilt_test(reader, tp_node_get(root, "tilt_test"));
  if (status == TP_OK) status = tp_read_shaking(reader, tp_node_get(root, "shaking"));
  if (status == TP_OK) status = tp_read_section_used(reader, tp_node_get(root, "section"));
  if (status == TP_OK) status = tp_check_simulation(scene, reader->message);
  return status == TP_OK ? tp_scene_cautions(&scene->notes, scene, reader->message) : status;
}

/* One number was given for a node that holds none. */
static tp_status check_used(const tp_scene *scene, tp_message *message) {
  for (long k = 0; k < scene->override_count; k++) {
    if (scene->overrides[k].used) continue;
    return tp_refuse(message, TP_FAULT_KEY, tp_node_place(scene->overrides[k].node, scene->path),
                     "this is not a number of the scene");
  }
  return TP_OK;
}

/* The file and the overrides become the scene's, or are given back. */
static tp_status read_file(tp_scene **scene, tp_scene_file *file, bool again,
                           tp_override *overrides, long count, tp_message *message) {
  tp_scene *read = tp_scene_make(file->path);
  if (read == NULL) {
    tp_overrides_free(overrides, count);
    tp_scene_file_free(file);
    return tp_fail_memory(message, "the scene");
  }
  read->file = file;
  read->source = file->root;
  read->load_case = file->load_case;
  read->overrides = overrides;
  read->override_count = count;
  tp_reading reading = {.again = again};
  const tp_reader reader = {read, message, &reading};
  tp_status status = read_root(&reader, file->root);
  if (status == TP_OK) status = check_used(read, message);
  if (status == TP_OK) {
    *scene = read;
  } else {
    tp_scene_free(read);
  }
  return status;
}

tp_status tp_scene_read_again(tp_scene **scene, tp_scene_file *file, tp_override *overrides,
                              long count, tp_message *message) {
  return read_file(scene, tp_scene_file_share(file), true, overrides, count, message);
}

tp_status tp_scene_read_nodes(tp_scene **scene, const char *path, tp_node *root,
                              tp_override *overrides, long count, tp_message *message) {
  tp_scene_file *file = tp_scene_file_make(path, root);
  if (file != NULL) return read_file(scene, file, false, overrides, count, message);
  tp_node_free(root);
  tp_overrides_free(overrides, count);
  return tp_fail_memory(message, "the scene");
}
