/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Reads the sections base, contact and joint of a scene: mated or profile, its placing, ends of the
 * contact, continuation, shift or matching. */

#include "scene_reading/read.h"

#include <string.h>

static tp_status read_beyond(const tp_reader *reader, const tp_node *node) {
  if (node == NULL) return TP_OK;
  return tp_read_map(reader, reader->scene, node, &tp_key_map_base_beyond, "beyond");
}

/* Two vertices by their coordinates, or what bounds them. */
static tp_status read_between(const tp_reader *reader, const tp_node *node) {
  tp_base_description *base = &reader->scene->base;
  if (node == NULL) return TP_OK;
  base->between_place = tp_node_place(node, reader->scene->path);
  if (node->kind == TP_NODE_SEQUENCE && node->count == 2) {
    return tp_read_points(reader, &base->between, node, false, "between");
  }
  if (node->kind != TP_NODE_MAPPING || node->count == 0) {
    return tp_read_fail(
        reader, TP_FAULT_FORMAT, node,
        "between says where the contact begins and ends: two vertices of the outline, "
        "[[x, y], [x, y]], the left one first, or what all its vertices lie within, as "
        "{below: y} or {right_of: x, left_of: x}");
  }
  tp_status status = tp_read_keys(reader, node, &tp_key_map_base_between, "between");
  return status == TP_OK ? tp_read_values(reader, reader->scene, node, &tp_key_map_base_between)
                         : status;
}

/* true, false, or whole. */
static tp_status read_mated(const tp_reader *reader, const tp_node *node) {
  tp_base_description *base = &reader->scene->base;
  if (node == NULL) return TP_OK;
  base->whole = node->kind == TP_NODE_SCALAR && strcmp(node->text, "whole") == 0;
  if (!base->whole && node->kind == TP_NODE_SCALAR && strcmp(node->text, "true") != 0 &&
      strcmp(node->text, "false") != 0) {
    return tp_read_fail(reader, TP_FAULT_KEY, node,
                        "mated must be true, false, or 'whole' for all of the underside from its "
                        "leftmost to its rightmost vertex, however steep");
  }
  if (base->whole) {
    base->mated = true;
    return TP_OK;
  }
  return tp_read_bool(reader, &base->mated, node, "mated");
}

/* as_given, rest, or all. */
static tp_status read_placing(const tp_reader *reader, const tp_node *node) {
  tp_base_description *base = &reader->scene->base;
  if (node == NULL) return TP_OK;
  const char *text = node->kind == TP_NODE_SCALAR ? node->text : "";
  base->all_poses = strcmp(text, "all") == 0;
  base->rests = base->all_poses || strcmp(text, "rest") == 0;
  base->rests_place = tp_read_place(reader, node);
  if (base->rests || strcmp(text, "as_given") == 0) return TP_OK;
  return tp_read_fail(reader, TP_FAULT_KEY, node,
                      "place must be 'rest', to set the block down on the profile until it rests, "
                      "'all', to list all its resting poses besides, or 'as_given'");
}

/* Where over its profile the block is set down. */
static tp_status read_start(const tp_reader *reader, const tp_node *node) {
  const tp_base_description *base = &reader->scene->base;
  if (node == NULL) return TP_OK;
  if (base->mated) {
    return tp_read_fail(reader, TP_FAULT_KEY, node,
                        "'shift' belongs to a 'profile' with 'place: rest'; along the mated base "
                        "that it fits a block is shifted by 'joint: {shift: …}'");
  }
  if (!base->rests || base->all_poses) {
    return tp_read_fail(reader, TP_FAULT_KEY, node,
                        base->all_poses ? "'place: all' takes all shifts along the profile; leave "
                                          "out 'shift', or say 'place: rest'"
                                        : "a block is shifted and set down again by 'place: rest' "
                                          "beside 'shift'");
  }
  return tp_read_quantity(reader, &reader->scene->base.start_x, node, "shift", TP_RULE_ANY);
}

static bool has_drawn_base(const tp_reader *reader) {
  const tp_drawn *drawn = reader->scene->drawn;
  return drawn != NULL && drawn->base.count > 0;
}

/* The profile is the drawing's: what is said beside it is how the block is set down on it. */
static tp_status read_drawn_base(const tp_reader *reader, const tp_node *node) {
  static const char *const others[] = {"mated", "profile", "beyond", "between", "smooth"};
  tp_base_description *base = &reader->scene->base;
  const tp_drawn *drawn = reader->scene->drawn;
  base->mated = false;
  base->place = (tp_place){drawn->path, drawn->base.mark.line, drawn->base.mark.column};
  base->profile = tp_polyline_share(&drawn->base);
  if (node == NULL) return TP_OK;
  tp_status status = tp_read_keys(reader, node, &tp_key_map_base, "the base");
  for (size_t k = 0; k < sizeof others / sizeof others[0] && status == TP_OK; k++) {
    const tp_node *odd = tp_node_get(node, others[k]);
    if (odd == NULL) continue;
    status = tp_read_fail(reader, TP_FAULT_KEY, odd,
                          "the base comes from the drawing; leave out '%s' here, or what is on "
                          "the drawing's layer of the base",
                          others[k]);
  }
  if (status == TP_OK) status = read_placing(reader, tp_node_get(node, "place"));
  return status == TP_OK ? read_start(reader, tp_node_get(node, "shift")) : status;
}

tp_status tp_read_base(const tp_reader *reader, const tp_node *node) {
  tp_base_description *base = &reader->scene->base;
  if (has_drawn_base(reader)) return read_drawn_base(reader, node);
  if (node == NULL) return TP_OK;
  base->place = tp_node_place(node, reader->scene->path);
  tp_status status = tp_read_keys(reader, node, &tp_key_map_base, "the base");
  if (status != TP_OK) return status;
  const tp_node *mated = tp_node_get(node, "mated"), *profile = tp_node_get(node, "profile");
  base->mated = profile == NULL;
  status = read_mated(reader, mated);
  if (status != TP_OK) return status;
  const tp_node *between = tp_node_get(node, "between");
  if (between != NULL) {
    status =
        tp_check_base_not_whole(reader->scene, tp_read_place(reader, between), reader->message);
    if (status != TP_OK) return status;
  }
  if (base->mated && profile != NULL) {
    return tp_read_fail(reader, TP_FAULT_KEY, profile,
                        "a base is either mated or has a separate profile; drop one of them");
  }
  if (!base->mated && profile == NULL) {
    return tp_read_fail(reader, TP_FAULT_KEY, node,
                        "a base that is not mated needs a profile: 'profile: [[x, y], …]'");
  }
  status = read_placing(reader, tp_node_get(node, "place"));
  if (status == TP_OK) status = read_start(reader, tp_node_get(node, "shift"));
  if (status != TP_OK) return status;
  if (profile != NULL) {
    const tp_node *odd = tp_node_get(node, "beyond");
    if (odd == NULL) odd = between;
    if (odd == NULL) odd = tp_node_get(node, "smooth");
    if (odd != NULL) {
      return tp_check_base_is_mated(reader->scene, odd->key, tp_read_place(reader, odd),
                                    reader->message);
    }
    const bool by_rule = profile->kind == TP_NODE_MAPPING && tp_node_get(profile, "mesh") == NULL;
    if (by_rule) return tp_read_generated(reader, profile);
    return tp_read_points(reader, &base->profile, profile, false, "the profile");
  }
  const tp_node *smooth = tp_node_get(node, "smooth");
  if (smooth != NULL) {
    status = tp_read_quantity(reader, &base->smooth, smooth, "smooth", TP_RULE_ABOVE_ZERO);
  }
  if (status == TP_OK) status = read_between(reader, between);
  if (status == TP_OK) status = read_beyond(reader, tp_node_get(node, "beyond"));
  return status;
}

tp_status tp_read_contact(const tp_reader *reader, const tp_node *node) {
  if (node == NULL) return TP_OK;
  tp_status status = tp_read_keys(reader, node, &tp_key_map_contact, "contact");
  if (status != TP_OK) return status;
  const tp_node *within = tp_node_get(node, "within"), *width = tp_node_get(node, "width");
  if (within == NULL && width == NULL) {
    return tp_read_required(reader, &within, node, "within", "contact: {within: 0.2}");
  }
  return tp_read_values(reader, reader->scene, node, &tp_key_map_contact);
}

/* To which side the block is shifted until it matches no more. */
static tp_status read_side(const tp_reader *reader, const tp_node *node) {
  tp_base_description *base = &reader->scene->base;
  if (node == NULL) return TP_OK;
  const char *text = node->kind == TP_NODE_SCALAR ? node->text : "";
  base->shift_left = strcmp(text, "left") == 0;
  if (!base->shift_left && strcmp(text, "right") != 0) {
    return tp_read_fail(reader, TP_FAULT_KEY, node, "towards must be left or right");
  }
  if (base->matching.given) return TP_OK;
  return tp_read_fail(reader, TP_FAULT_KEY, node,
                      "'towards' belongs to 'matching'; a 'shift' goes to the right above 0, and "
                      "to the left below");
}

tp_status tp_read_joint(const tp_reader *reader, const tp_node *node) {
  if (node == NULL) return TP_OK;
  tp_status status = tp_read_keys(reader, node, &tp_key_map_joint, "joint");
  if (status == TP_OK) status = tp_read_values(reader, reader->scene, node, &tp_key_map_joint);
  if (status == TP_OK) status = read_side(reader, tp_node_get(node, "towards"));
  if (status != TP_OK) return status;
  return tp_check_joint(reader->scene, tp_read_place(reader, node), reader->message);
}
