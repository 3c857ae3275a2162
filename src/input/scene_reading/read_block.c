/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Reads the section block of a scene: outline, slab, teeth in either description (Fig. 5; section
 * 5.1 of the paper), ellipse, holes, parts and unit weight. */

#include "scene/members.h"
#include "scene_reading/read.h"

#include <stdlib.h>
#include <string.h>

static tp_status read_left_end(const tp_reader *reader, tp_teeth *teeth, const tp_node *node) {
  const tp_node *end = NULL;
  const tp_status status = tp_read_required(reader, &end, node, "left_end", "left_end: valley");
  if (status != TP_OK) return status;
  if (end->kind == TP_NODE_SCALAR && strcmp(end->text, "valley") == 0) {
    teeth->left_end_valley = true;
  } else if (end->kind == TP_NODE_SCALAR && strcmp(end->text, "peak") == 0) {
    teeth->left_end_valley = false;
  } else {
    return tp_read_fail(reader, TP_FAULT_KEY, end, "left_end must be valley or peak");
  }
  return TP_OK;
}

/* (N, a, b, c) as the paper prepares its blocks (Fig. 5). */
static tp_status read_counted_teeth(const tp_reader *reader, tp_teeth *teeth, const tp_node *node) {
  static const char *const keys[] = {"count", "width", "height", "depth", "left_end", NULL};
  const tp_node *count = NULL, *width = NULL, *height = NULL, *depth = NULL;
  fmpq_t n;
  fmpq_init(n);
  tp_status status = tp_node_expect_keys(node, keys, "teeth", reader->scene->path, reader->message);
  if (status == TP_OK) status = tp_read_required(reader, &count, node, "count", "count: 3");
  if (status == TP_OK) status = tp_read_required(reader, &width, node, "width", "width: 30");
  if (status == TP_OK) status = tp_read_required(reader, &height, node, "height", "height: 120");
  if (status == TP_OK) status = tp_read_required(reader, &depth, node, "depth", "depth: 5");
  if (status == TP_OK) status = tp_read_number(reader, n, count, "count");
  if (status == TP_OK)
    status = tp_check_tooth_count(&teeth->count, n, "count", tp_read_place(reader, count),
                                  reader->message);
  if (status == TP_OK)
    status = tp_read_by_rule(reader, teeth->width, width, "width", TP_RULE_ABOVE_ZERO);
  if (status == TP_OK)
    status = tp_read_by_rule(reader, teeth->height, height, "height", TP_RULE_ABOVE_ZERO);
  if (status == TP_OK)
    status = tp_read_by_rule(reader, teeth->depth, depth, "depth", TP_RULE_NOT_NEGATIVE);
  fmpq_clear(n);
  return status;
}

/* (dx, y, A, lambda), section 5.1: N = 2 dx / lambda, a = lambda / 2, b = y - A / 2, c = A. */
static tp_status read_general_teeth(const tp_reader *reader, tp_teeth *teeth, const tp_node *node) {
  static const char *const keys[] = {"block_width", "mean_height", "amplitude",
                                     "wavelength",  "left_end",    NULL};
  const tp_node *width = NULL, *height = NULL, *amplitude = NULL, *wavelength = NULL;
  fmpq_t n, half;
  fmpq_init(n);
  fmpq_init(half);
  tp_status status = tp_node_expect_keys(node, keys, "teeth", reader->scene->path, reader->message);
  if (status == TP_OK)
    status = tp_read_required(reader, &width, node, "block_width", "block_width: 90");
  if (status == TP_OK)
    status = tp_read_required(reader, &height, node, "mean_height", "mean_height: 122.5");
  if (status == TP_OK)
    status = tp_read_required(reader, &amplitude, node, "amplitude", "amplitude: 5");
  if (status == TP_OK)
    status = tp_read_required(reader, &wavelength, node, "wavelength", "wavelength: 60");
  if (status == TP_OK)
    status = tp_read_by_rule(reader, n, width, "block_width", TP_RULE_ABOVE_ZERO);
  if (status == TP_OK)
    status = tp_read_by_rule(reader, teeth->height, height, "mean_height", TP_RULE_ABOVE_ZERO);
  if (status == TP_OK)
    status = tp_read_by_rule(reader, teeth->depth, amplitude, "amplitude", TP_RULE_NOT_NEGATIVE);
  if (status == TP_OK)
    status = tp_read_by_rule(reader, teeth->width, wavelength, "wavelength", TP_RULE_ABOVE_ZERO);
  if (status == TP_OK) {
    fmpq_div_2exp(teeth->width, teeth->width, 1);
    fmpq_div(n, n, teeth->width);
    fmpq_div_2exp(half, teeth->depth, 1);
    fmpq_sub(teeth->height, teeth->height, half);
    status = tp_check_tooth_count(&teeth->count, n, "2 block_width / wavelength",
                                  tp_read_place(reader, wavelength), reader->message);
  }
  if (status == TP_OK) {
    status = tp_check_amplitude(teeth->height, tp_read_place(reader, amplitude), reader->message);
  }
  fmpq_clear(n);
  fmpq_clear(half);
  return status;
}

static tp_status read_teeth(const tp_reader *reader, const tp_node *node) {
  tp_teeth *teeth = &reader->scene->block.teeth;
  reader->scene->block.form = TP_OUTLINE_TEETH;
  if (node->kind != TP_NODE_MAPPING) {
    return tp_read_fail(reader, TP_FAULT_FORMAT, node,
                        "teeth must be a map: {count, width, height, depth, left_end} or "
                        "{block_width, mean_height, amplitude, wavelength, left_end}");
  }
  const bool general =
      tp_node_get(node, "wavelength") != NULL || tp_node_get(node, "block_width") != NULL ||
      tp_node_get(node, "mean_height") != NULL || tp_node_get(node, "amplitude") != NULL;
  const tp_status status =
      general ? read_general_teeth(reader, teeth, node) : read_counted_teeth(reader, teeth, node);
  return status == TP_OK ? read_left_end(reader, teeth, node) : status;
}

static tp_status read_slab(const tp_reader *reader, const tp_node *node) {
  tp_block_description *block = &reader->scene->block;
  block->form = TP_OUTLINE_SLAB;
  block->teeth.count = 1;
  return tp_read_map(reader, reader->scene, node, &tp_key_map_block_slab, "slab");
}

static tp_status read_ellipse(const tp_reader *reader, const tp_node *block, const tp_node *node) {
  tp_ellipse *e = &reader->scene->block.ellipse;
  reader->scene->block.form = TP_OUTLINE_ELLIPSE;
  tp_status status = tp_read_map(reader, reader->scene, node, &tp_key_map_block_ellipse, "ellipse");
  if (status == TP_OK) {
    status = tp_check_flat(e->flat.value, e->width.value,
                           tp_read_place(reader, tp_node_get(node, "flat")), reader->message);
  }
  if (status != TP_OK) return status;
  const bool plain = tp_node_get(block, "holes") == NULL && tp_node_get(block, "parts") == NULL &&
                     tp_node_get(block, "arcs") == NULL && tp_node_get(block, "rounded") == NULL;
  return tp_check_ellipse_plain(plain, tp_read_place(reader, node), reader->message);
}

static tp_status read_form(const tp_reader *reader, const tp_node *node) {
  const tp_node *teeth = tp_node_get(node, "teeth"), *slab = tp_node_get(node, "slab");
  const tp_node *outline = tp_node_get(node, "outline"), *ellipse = tp_node_get(node, "ellipse");
  const int forms = (teeth != NULL) + (slab != NULL) + (outline != NULL) + (ellipse != NULL);
  const tp_drawn *drawn = reader->scene->drawn;
  if (drawn != NULL && forms == 0) {
    reader->scene->block.form = TP_OUTLINE_VERTICES;
    reader->scene->block.outline = tp_polyline_share(&drawn->outline);
    return TP_OK;
  }
  if (drawn != NULL) {
    return tp_read_fail(reader, TP_FAULT_KEY, node,
                        "the outline of the block comes from the drawing; leave out 'outline', "
                        "'teeth', 'slab' or 'ellipse' here, or 'drawing'");
  }
  if (forms != 1) {
    return tp_read_fail(reader, TP_FAULT_KEY, node,
                        "the block needs exactly one of 'outline', 'teeth', 'slab' and 'ellipse'");
  }
  if (ellipse != NULL) return read_ellipse(reader, node, ellipse);
  if (teeth != NULL) return read_teeth(reader, teeth);
  if (slab != NULL) return read_slab(reader, slab);
  reader->scene->block.form = TP_OUTLINE_VERTICES;
  return tp_read_outline(reader, outline);
}

static tp_status read_holes(const tp_reader *reader, const tp_node *node) {
  tp_block_description *block = &reader->scene->block;
  if (node == NULL) return TP_OK;
  if (node->kind != TP_NODE_SEQUENCE) {
    return tp_read_fail(reader, TP_FAULT_FORMAT, node, "holes must be a list of outlines");
  }
  if (!tp_scene_hole_room(reader->scene, node->count))
    return tp_fail_memory(reader->message, "the holes");
  tp_status status = TP_OK;
  for (const tp_node *hole = node->first; hole != NULL && status == TP_OK; hole = hole->next) {
    status = tp_read_points(reader, block->holes + block->hole_count, hole, true, "a hole");
    if (status == TP_OK) block->hole_count++;
  }
  return status;
}

static tp_status read_part(const tp_reader *reader, tp_part *part, const tp_node *node) {
  const tp_node *outline = NULL;
  tp_status status = tp_read_map(reader, part, node, &tp_key_map_block_parts, "a part");
  if (status == TP_OK)
    status =
        tp_read_required(reader, &outline, node, "outline", "outline: [[0, 0], [1, 0], [1, 1]]");
  if (status == TP_OK) status = tp_read_points(reader, &part->outline, outline, true, "a part");
  return status;
}

static tp_status read_parts(const tp_reader *reader, const tp_node *node) {
  tp_block_description *block = &reader->scene->block;
  if (node == NULL) return TP_OK;
  if (node->kind != TP_NODE_SEQUENCE) {
    return tp_read_fail(reader, TP_FAULT_FORMAT, node,
                        "parts must be a list of {outline, unit_weight_kn_m3}");
  }
  tp_status status =
      tp_check_parts_weighed(reader->scene, tp_read_place(reader, node), reader->message);
  if (status != TP_OK) return status;
  block->parts = calloc((size_t)node->count + 1, sizeof *block->parts);
  if (block->parts == NULL) return tp_fail_memory(reader->message, "the parts");
  for (const tp_node *part = node->first; part != NULL && status == TP_OK; part = part->next) {
    tp_part *own = block->parts + block->part_count++;
    fmpq_init(own->unit_weight_kn_m3.value);
    status = read_part(reader, own, part);
  }
  return status;
}

static tp_status read_repair(const tp_reader *reader, const tp_node *node) {
  tp_block_description *block = &reader->scene->block;
  if (node == NULL) return TP_OK;
  block->repair_place = tp_read_place(reader, node);
  return tp_check_repair(reader->scene, block->repair_place, reader->message);
}

tp_status tp_read_block_shape(const tp_reader *reader, const tp_node *node,
                              const tp_node *drawing) {
  tp_status status = read_form(reader, node);
  if (status == TP_OK) status = tp_read_values(reader, reader->scene, node, &tp_key_map_block);
  if (status == TP_OK) status = read_holes(reader, tp_node_get(node, "holes"));
  if (status == TP_OK) status = tp_read_drawn_holes(reader);
  if (status == TP_OK) status = read_parts(reader, tp_node_get(node, "parts"));
  if (status == TP_OK) status = tp_read_drawn_parts(reader, drawing);
  if (status == TP_OK) status = tp_read_arcs(reader, tp_node_get(node, "arcs"));
  if (status == TP_OK) status = tp_read_drawn_arcs(reader);
  if (status == TP_OK) status = tp_read_rounded(reader, tp_node_get(node, "rounded"));
  return status == TP_OK ? read_repair(reader, tp_node_get(node, "repair")) : status;
}

tp_status tp_read_block(const tp_reader *reader, const tp_node *node) {
  tp_block_description *block = &reader->scene->block;
  block->place = tp_node_place(node, reader->scene->path);
  const tp_node *drawing = tp_node_get(node->parent, "drawing");
  if (node == drawing) node = NULL; /* which is all that says what the block is */
  tp_status status = TP_OK;
  if (node != NULL) {
    status = tp_read_keys(reader, node, &tp_key_map_block, "the block");
  }
  return status == TP_OK ? tp_read_block_shape(reader, node, drawing) : status;
}
