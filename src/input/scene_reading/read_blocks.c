/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Reads a scene of many blocks: the keys blocks, columns, jointed_slope, joints and block. Each
 * block is read as that of a scene of one block, and then moved to the list; joints name two of
 * them. */

#include "scene/block_names.h"
#include "scene_reading/read.h"

#include "common/outside.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const long most_blocks = 1000000;

static tp_status read_name(const tp_reader *reader, tp_listed_block *listed, const tp_node *node,
                           long number) {
  if (node == NULL) {
    enum { SIZE = 24 };
    char text[SIZE];
    snprintf(text, sizeof text, "%ld", number);
    listed->name = strdup(text);
  } else if (node->kind != TP_NODE_SCALAR || node->text[0] == '\0' ||
             strlen(node->text) > TP_MOST_BLOCK_NAME) {
    return tp_read_fail(reader, TP_FAULT_KEY, node,
                        "the name of a block is a text of 1 to %d characters, as 'name: B1'",
                        TP_MOST_BLOCK_NAME);
  } else {
    listed->name = strdup(node->text);
  }
  return listed->name != NULL ? TP_OK : tp_fail_memory(reader->message, "the blocks");
}

/* ---- blocks ------------------------------------------------------------------------------------
 */

static tp_status check_shape(const tp_reader *reader, const tp_node *node) {
  const tp_block_description *block = &reader->scene->block;
  if (block->form == TP_OUTLINE_ELLIPSE || block->rounded.place.file != NULL ||
      (block->arc_count > 0 && !block->arc_tolerance.given)) {
    return tp_read_fail(reader, TP_FAULT_KEY, node,
                        "blocks in contact have straight edges: give the outline by vertices, or "
                        "its arcs with an 'arc_tolerance'");
  }
  if (block->thickness.given) {
    return tp_refuse(reader->message, TP_FAULT_KEY, block->thickness.place,
                     "blocks in contact are all as thick, and results are per metre: leave out "
                     "'thickness'");
  }
  return TP_OK;
}

static tp_status read_listed(const tp_reader *reader, const tp_node *node,
                             const tp_quantity *unit_weight) {
  tp_listed_block *listed =
      tp_scene_next_block(reader->scene, tp_node_place(node, reader->scene->path), unit_weight);
  const tp_node *at = tp_node_get(node, "at");
  tp_status status = tp_read_map(reader, listed, node, &tp_key_map_blocks, "a block");
  if (status == TP_OK) {
    status = read_name(reader, listed, tp_node_get(node, "name"), reader->scene->many.count);
  }
  if (status == TP_OK && at != NULL) {
    status = tp_read_point(reader, &listed->at_x, &listed->at_y, at, "at");
  }
  if (status == TP_OK) status = tp_read_block_shape(reader, node, NULL);
  if (status == TP_OK) status = check_shape(reader, node);
  tp_scene_list_block(reader->scene, listed);
  return status;
}

static tp_status read_list(const tp_reader *reader, const tp_node *node,
                           const tp_quantity *unit_weight) {
  tp_block_list *many = &reader->scene->many;
  if (node->kind != TP_NODE_SEQUENCE || node->count == 0 || node->count > most_blocks) {
    return tp_read_fail(reader, TP_FAULT_FORMAT, node,
                        "blocks are a list, of up to %ld: [{name: ground, ground: true, outline: "
                        "[[0, 0], …]}, {name: B1, outline: [[0, 0], …]}]",
                        most_blocks);
  }
  many->blocks = calloc((size_t)node->count, sizeof *many->blocks);
  if (many->blocks == NULL) return tp_fail_memory(reader->message, "the blocks");
  tp_status status = TP_OK;
  for (const tp_node *n = node->first; n != NULL && status == TP_OK; n = n->next) {
    status = read_listed(reader, n, unit_weight);
  }
  return status == TP_OK ? tp_check_block_weights(reader->scene, reader->message) : status;
}

/* What the blocks have in common. */
static tp_status read_common(const tp_reader *reader, const tp_node *node) {
  static const char *const keys[] = {"unit_weight_kn_m3", NULL};
  if (node == NULL) return TP_OK;
  const tp_status status = tp_node_expect_keys(node, keys, "what all blocks have in common",
                                               reader->scene->path, reader->message);
  return status == TP_OK ? tp_read_values(reader, reader->scene, node, &tp_key_map_block) : status;
}

/* ---- joints ------------------------------------------------------------------------------------
 */

/* A block by its name, or all of a layer of the drawing. */
static tp_status read_end(const tp_reader *reader, long *number, const tp_node *node,
                          const tp_block_name *names, const tp_node *drawing) {
  const bool named = drawing != NULL && node->kind == TP_NODE_SCALAR &&
                     !tp_block_name_is(reader->scene, node->text, names);
  const long layer = named ? tp_drawn_layer_of(drawing, node->text) : 0;
  if (layer == 0) return tp_block_name_find(number, reader->scene, node, names, reader->message);
  *number = -layer;
  return TP_OK;
}

static tp_status read_joint(const tp_reader *reader, tp_joint_description *joint,
                            const tp_node *node, const tp_block_name *names,
                            const tp_node *drawing) {
  const tp_node *between = NULL;
  joint->place = tp_node_place(node, reader->scene->path);
  tp_status status = tp_read_map(reader, joint, node, &tp_key_map_joints, "a joint");
  if (status == TP_OK) {
    status = tp_read_required(reader, &between, node, "between", "between: [B1, B2]");
  }
  if (status == TP_OK && (between->kind != TP_NODE_SEQUENCE || between->count != 2)) {
    status = tp_read_fail(reader, TP_FAULT_FORMAT, between, "'between' names two blocks: [B1, B2]");
  }
  if (status == TP_OK) status = read_end(reader, joint->between, between->first, names, drawing);
  if (status == TP_OK) {
    status = read_end(reader, joint->between + 1, between->last, names, drawing);
  }
  if (status == TP_OK && joint->between[0] == joint->between[1] && joint->between[0] >= 0) {
    status = tp_read_fail(reader, TP_FAULT_KEY, between, "a joint is between two blocks");
  }
  return status;
}

static tp_status read_joints(const tp_reader *reader, const tp_node *root) {
  const tp_node *node = tp_node_get(root, "joints");
  tp_block_list *many = &reader->scene->many;
  if (node == NULL) return TP_OK;
  if (node->kind != TP_NODE_SEQUENCE) {
    return tp_read_fail(reader, TP_FAULT_FORMAT, node,
                        "joints are a list of {between: [B1, B2], friction_angle_deg: 25}");
  }
  tp_block_name *names = NULL;
  tp_status status = tp_block_names_sort(&names, reader->scene, reader->message);
  if (status != TP_OK) return status;
  many->joints = calloc((size_t)node->count + 1, sizeof *many->joints);
  if (many->joints == NULL) status = tp_fail_memory(reader->message, "the joints");
  for (const tp_node *n = node->first; n != NULL && status == TP_OK; n = n->next) {
    tp_joint_description *own = many->joints + many->joint_count++;
    tp_joint_init(own);
    status = read_joint(reader, own, n, names, tp_node_get(root, "drawing"));
  }
  free(names);
  return status;
}

/* ---- the scene ---------------------------------------------------------------------------------
 */

/* The keys that give blocks, of which a scene has one, or a drawing of them. */
static const char *const givers[] = {"blocks", "columns", "jointed_slope", NULL};

const tp_node *tp_read_blocks_given(const tp_node *root) {
  const tp_node *found = tp_node_first_of(root, givers);
  const tp_node *drawing = tp_node_get(root, "drawing");
  const bool of_blocks = drawing != NULL && (tp_node_get(drawing, "blocks") != NULL ||
                                             tp_node_get(drawing, "ground") != NULL);
  return found == NULL && of_blocks ? drawing : found;
}

/* Keys that say nothing of many blocks. */
static tp_status check_root(const tp_reader *reader, const tp_node *root) {
  static const char *const keys[] = {"base",     "joint",     "drawing", "section",
                                     "friction", "tilt_test", "shaking", NULL};
  for (size_t k = 0; keys[k] != NULL; k++) {
    const tp_node *node = tp_node_get(root, keys[k]);
    if (node == NULL || node == tp_read_blocks_given(root)) continue;
    return tp_read_fail(reader, TP_FAULT_KEY, node,
                        "'%s' is of a scene of one block, and this one has '%s': leave it out",
                        keys[k], tp_read_blocks_given(root)->key);
  }
  const tp_node *slope = tp_node_get(root, "slope");
  if (slope != NULL && tp_node_get(root, "jointed_slope") != NULL) {
    return tp_read_fail(reader, TP_FAULT_KEY, slope,
                        "'slope' turns the axes, and dips of a 'jointed_slope' are below the "
                        "horizontal: leave it out");
  }
  return TP_OK;
}

/* The noise of a survey, where blocks were listed. */
static tp_status read_contact(const tp_reader *reader, const tp_node *root) {
  static const char *const keys[] = {"within", NULL};
  const tp_node *node = tp_node_get(root, "contact");
  if (node == NULL) return TP_OK;
  if (tp_node_get(root, "columns") != NULL || tp_node_get(root, "jointed_slope") != NULL) {
    return tp_read_fail(
        reader, TP_FAULT_KEY, node,
        "'contact' closes gaps of blocks that are listed or drawn; those of '%s' touch "
        "exactly: leave it out",
        tp_read_blocks_given(root)->key);
  }
  const tp_status status = tp_node_expect_keys(node, keys, "the contact of many blocks",
                                               reader->scene->path, reader->message);
  return status == TP_OK ? tp_read_contact(reader, node) : status;
}

/* Listed, or made by a rule. */
static tp_status read_bodies(const tp_reader *reader, const tp_node *root,
                             const tp_quantity *unit_weight) {
  const tp_node *node = tp_read_blocks_given(root);
  reader->scene->many.place = tp_node_place(node, reader->scene->path);
  for (size_t k = 0; givers[k] != NULL; k++) {
    const tp_node *other = tp_node_get(root, givers[k]);
    if (other == NULL || other == node) continue;
    return tp_read_fail(reader, TP_FAULT_KEY, other,
                        "a scene has 'blocks', or 'columns' or a 'jointed_slope' that make them: "
                        "leave one out");
  }
  if (strcmp(node->key, "columns") == 0) return tp_read_columns(reader, node, root, unit_weight);
  if (strcmp(node->key, "blocks") == 0) return read_list(reader, node, unit_weight);
  if (strcmp(node->key, "drawing") == 0) return tp_read_drawn_blocks(reader, node, unit_weight);
  return tp_read_jointed_slope(reader, node, unit_weight);
}

tp_status tp_read_blocks(const tp_reader *reader, const tp_node *root) {
  tp_quantity unit_weight = {.given = false};
  tp_block_description *all = &reader->scene->block;
  fmpq_init(unit_weight.value);
  tp_status status = check_root(reader, root);
  if (status == TP_OK) status = read_contact(reader, root);
  if (status == TP_OK) status = read_common(reader, tp_node_get(root, "block"));
  if (status == TP_OK) {
    tp_quantity_copy(&unit_weight, &all->unit_weight_kn_m3);
    status = read_bodies(reader, root, &unit_weight);
  }
  if (status == TP_OK) status = read_joints(reader, root);
  if (status == TP_OK) status = tp_read_column_joints(reader);
  tp_quantity_copy(&all->unit_weight_kn_m3, &unit_weight);
  all->form = TP_OUTLINE_OF_EACH;
  all->place = reader->scene->many.place;
  fmpq_clear(unit_weight.value);
  return status;
}
