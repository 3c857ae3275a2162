/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Reads the key jointed_slope: the section, its joint sets and its base, of which blocks are made
 * (jointing/outlines.h). */

#include "jointing/cuts.h"
#include "jointing/outlines.h"
#include "scene/members.h"
#include "scene_reading/read.h"

#include "common/notes.h"
#include "common/outside.h"

#include <stdlib.h>
#include <string.h>

enum { MOST_SETS = 8, MOST_NAME = 60 };

static tp_status read_side(const tp_reader *reader, bool *left, const tp_node *node) {
  const char *text = node->kind == TP_NODE_SCALAR ? node->text : "";
  *left = strcmp(text, "left") == 0;
  if (*left || strcmp(text, "right") == 0) return TP_OK;
  return tp_read_fail(reader, TP_FAULT_KEY, node, "towards must be left or right");
}

/* ---- the section -------------------------------------------------------------------------------
 */

static tp_status check_surface(const tp_reader *reader, const tp_polyline *line) {
  if (line->count >= 2 && fmpq_cmp(line->x, line->x + line->count - 1) < 0) return TP_OK;
  return tp_refuse(reader->message, TP_FAULT_GEOMETRY, tp_polyline_place(line, -1),
                   "the surface of a slope runs from left to right, from point to point: [[-10, "
                   "0], [0, 0], [12, 20], [60, 22]]");
}

static tp_status read_surface(const tp_reader *reader, const tp_node *node,
                              const tp_node *surface) {
  static const char *const others[] = {"face", "upper", "front", "behind", NULL};
  const tp_node *other = tp_node_first_of(node, others);
  if (other != NULL) {
    return tp_read_fail(reader, TP_FAULT_KEY, other,
                        "a slope has its 'surface', or the numbers that make it, not both: leave "
                        "out '%s'",
                        other->key);
  }
  tp_polyline *line = &reader->scene->many.slope.surface;
  const tp_status status = tp_read_points(reader, line, surface, false, "the surface");
  return status == TP_OK ? check_surface(reader, line) : status;
}

static tp_status read_face(const tp_reader *reader, const tp_node *node) {
  const tp_jointed_slope *own = &reader->scene->many.slope;
  const tp_node *face = NULL, *upper = tp_node_get(node, "upper");
  tp_status status =
      tp_read_required(reader, &face, node, "face", "face: {dip_deg: 60, height: 30}");
  if (status == TP_OK) {
    status = tp_read_map(reader, reader->scene, face, &tp_key_map_jointed_slope_face, "the face");
  }
  if (status == TP_OK && fmpq_is_zero(own->face_dip_deg.value)) {
    status = tp_refuse(reader->message, TP_FAULT_RANGE, own->face_dip_deg.place,
                       "the dip of the face must be above zero");
  }
  if (status != TP_OK || upper == NULL) return status;
  return tp_read_map(reader, reader->scene, upper, &tp_key_map_jointed_slope_upper,
                     "the upper ground");
}

static tp_status read_section(const tp_reader *reader, const tp_node *node) {
  tp_jointed_slope *own = &reader->scene->many.slope;
  const tp_node *towards = tp_node_get(node, "towards"), *toe = tp_node_get(node, "toe");
  const tp_node *surface = tp_node_get(node, "surface");
  bool left = true;
  tp_status status = towards != NULL ? read_side(reader, &left, towards) : TP_OK;
  own->right = !left;
  if (status == TP_OK && toe != NULL) {
    status = tp_read_point(reader, &own->toe_x, &own->toe_y, toe, "toe");
  }
  if (status != TP_OK) return status;
  return surface != NULL ? read_surface(reader, node, surface) : read_face(reader, node);
}

/* ---- joint sets --------------------------------------------------------------------------------
 */

static tp_status read_name(const tp_reader *reader, char **name, const tp_node *node) {
  if (node == NULL) return TP_OK;
  if (node->kind != TP_NODE_SCALAR || node->text[0] == '\0' || strlen(node->text) > MOST_NAME) {
    return tp_read_fail(reader, TP_FAULT_KEY, node,
                        "the name of a joint set is a text of 1 to %d characters, as 'name: "
                        "bedding'",
                        MOST_NAME);
  }
  *name = strdup(node->text);
  return *name != NULL ? TP_OK : tp_fail_memory(reader->message, "the joints");
}

static tp_status check_most(const tp_reader *reader, const tp_quantity *number, const char *name,
                            long numerator, unsigned long denominator) {
  fmpq_t most;
  fmpq_init(most);
  fmpq_set_si(most, numerator, denominator);
  const bool over = fmpq_cmp(number->value, most) > 0;
  fmpq_clear(most);
  if (!over) return TP_OK;
  return tp_refuse(reader->message, TP_FAULT_RANGE, number->place, "scatter of %s is at most %g",
                   name, (double)numerator / (double)denominator);
}

static tp_status check_persistence(const tp_reader *reader, tp_joint_set *set,
                                   const tp_node *node) {
  tp_quantity *persistence = &set->persistence;
  if (!persistence->given) fmpq_one(persistence->value);
  if (fmpq_is_zero(persistence->value)) {
    return tp_refuse(reader->message, TP_FAULT_RANGE, persistence->place,
                     "joints of persistence 0 are not there: give one above zero, or leave out the "
                     "set");
  }
  if (fmpq_is_one(persistence->value) == !set->length.given) return TP_OK;
  if (set->length.given) {
    return tp_refuse(reader->message, TP_FAULT_KEY, set->length.place,
                     "joints of persistence 1 run through, and have no 'length': give the "
                     "'persistence', or leave it out");
  }
  return tp_read_fail(reader, TP_FAULT_KEY, node,
                      "joints of a persistence below 1 are open over a 'length' between two "
                      "bridges of rock, for example 'length: 6'");
}

static tp_status read_scatter(const tp_reader *reader, tp_joint_set *set, const tp_node *node) {
  if (node == NULL) return TP_OK;
  tp_status status =
      tp_read_map(reader, set, node, &tp_key_map_jointed_slope_joints_scatter, "scatter");
  if (status == TP_OK) status = check_most(reader, &set->spacing_scatter, "spacing", 9, 10);
  return status == TP_OK ? check_most(reader, &set->dip_scatter_deg, "dip_deg", 45, 1) : status;
}

static tp_status read_set(const tp_reader *reader, tp_joint_set *set, const tp_node *node) {
  const tp_node *towards = tp_node_get(node, "towards");
  set->place = tp_node_place(node, reader->scene->path);
  tp_status status =
      tp_read_map(reader, set, node, &tp_key_map_jointed_slope_joints, "a joint set");
  if (status == TP_OK) status = read_name(reader, &set->name, tp_node_get(node, "name"));
  const bool tilts = !fmpq_is_zero(set->dip_deg.value) && fmpq_cmp_si(set->dip_deg.value, 90) != 0;
  if (status == TP_OK && towards == NULL && tilts) {
    status = tp_read_required(reader, &towards, node, "towards", "towards: right");
  }
  if (status == TP_OK && towards != NULL) status = read_side(reader, &set->left, towards);
  if (status == TP_OK) status = check_persistence(reader, set, node);
  return status == TP_OK ? read_scatter(reader, set, tp_node_get(node, "scatter")) : status;
}

static bool is_random(const tp_joint_set *set) {
  return !fmpq_is_zero(set->spacing_scatter.value) || !fmpq_is_zero(set->dip_scatter_deg.value) ||
         set->length.given;
}

static tp_status read_sets(const tp_reader *reader, const tp_node *map) {
  tp_jointed_slope *own = &reader->scene->many.slope;
  const tp_node *node = NULL;
  tp_status status = tp_read_required(reader, &node, map, "joints",
                                      "joints: [{dip_deg: 60, towards: right, spacing: 5}]");
  if (status != TP_OK) return status;
  if (node->kind != TP_NODE_SEQUENCE || node->count == 0 || node->count > MOST_SETS) {
    return tp_read_fail(reader, TP_FAULT_FORMAT, node,
                        "joints are a list of 1 to %d sets: [{dip_deg: 60, towards: right, "
                        "spacing: 5}]",
                        MOST_SETS);
  }
  own->sets = calloc((size_t)node->count, sizeof *own->sets);
  if (own->sets == NULL) return tp_fail_memory(reader->message, "the joints");
  for (const tp_node *n = node->first; n != NULL && status == TP_OK; n = n->next) {
    tp_joint_set *set = own->sets + own->set_count++;
    for (size_t k = 0; k < tp_joint_set_numbers.count; k++) {
      fmpq_init(tp_member_number(set, tp_joint_set_numbers.items[k]));
    }
    status = read_set(reader, set, n);
    if (status == TP_OK && is_random(set) && !own->seed.given) {
      status = tp_read_fail(reader, TP_FAULT_KEY, n,
                            "joints that scatter or have bridges are a random sample: give its "
                            "'seed' beside 'joints', for example 'seed: 1'");
    }
  }
  return status;
}

/* ---- the base ----------------------------------------------------------------------------------
 */

static tp_status find_set(const tp_reader *reader, long *number, const tp_node *node) {
  const tp_jointed_slope *own = &reader->scene->many.slope;
  for (long k = 0; k < own->set_count && node->kind == TP_NODE_SCALAR; k++) {
    if (strcmp(tp_quote_all(node->text).text, tp_joint_set_name(own, k).text) != 0) continue;
    *number = k;
    if (!own->sets[k].length.given) return TP_OK;
    return tp_read_fail(reader, TP_FAULT_KEY, node,
                        "steps run along joints that run through: set '%s' has bridges",
                        tp_joint_set_name(own, k).text);
  }
  return tp_read_fail(reader, TP_FAULT_KEY, node,
                      "'steps' names a joint set, and none is named '%s'",
                      tp_quote_all(node->kind == TP_NODE_SCALAR ? node->text : "").text);
}

static tp_status read_plane(const tp_reader *reader, const tp_node *node) {
  tp_jointed_slope *own = &reader->scene->many.slope;
  const tp_node *start = tp_node_get(node, "start"), *steps = tp_node_get(node, "steps");
  const tp_node *dip = NULL;
  tp_status status = tp_read_required(reader, &dip, node, "dip_deg", "dip_deg: 20");
  if (status == TP_OK && start != NULL) {
    status = tp_read_point(reader, &own->base_x, &own->base_y, start, "start");
  }
  if (status == TP_OK && steps != NULL) status = find_set(reader, &own->stepped_by, steps);
  if (status == TP_OK && steps == NULL && own->tread_dip_deg.given) {
    status = tp_refuse(reader->message, TP_FAULT_KEY, own->tread_dip_deg.place,
                       "treads are of a base with 'steps' along the joints of a set");
  }
  return status;
}

static tp_status read_line(const tp_reader *reader, const tp_node *node, const tp_node *line) {
  static const char *const others[] = {"dip_deg", "start", "steps", "tread_dip_deg", NULL};
  const tp_node *other = tp_node_first_of(node, others);
  if (other != NULL) {
    return tp_read_fail(reader, TP_FAULT_KEY, other,
                        "a base is a 'line', or a plane by its 'dip_deg', not both: leave out '%s'",
                        other->key);
  }
  tp_polyline *own = &reader->scene->many.slope.base_line;
  const tp_status status = tp_read_points(reader, own, line, false, "the base");
  if (status != TP_OK || own->count >= 2) return status;
  return tp_read_fail(reader, TP_FAULT_FORMAT, line, "a line has two points or more");
}

static tp_status read_base(const tp_reader *reader, const tp_node *map) {
  tp_jointed_slope *own = &reader->scene->many.slope;
  const tp_node *node = NULL;
  tp_status status = tp_read_required(reader, &node, map, "base", "base: {dip_deg: 20}");
  if (status != TP_OK) return status;
  own->base.place = tp_node_place(node, reader->scene->path);
  own->stepped_by = -1;
  status = tp_read_map(reader, reader->scene, node, &tp_key_map_jointed_slope_base, "the base");
  if (status != TP_OK) return status;
  const tp_node *line = tp_node_get(node, "line");
  return line != NULL ? read_line(reader, node, line) : read_plane(reader, node);
}

/* ---- blocks ------------------------------------------------------------------------------------
 */

static tp_status tell(const tp_reader *reader, const tp_cut_blocks *blocks) {
  tp_notes *notes = &reader->scene->notes;
  const tp_place place = reader->scene->many.place;
  tp_status status = TP_OK;
  if (!blocks->exact) {
    status = tp_notes_add(notes, reader->message, TP_NOTE, place,
                          "corners of blocks were rounded, each once for all that meet there, and "
                          "moved by up to %.1g %s",
                          blocks->moved, reader->scene->length_unit);
  }
  if (status != TP_OK || blocks->cut_off == 0) return status;
  return tp_notes_add(notes, reader->message, TP_NOTE, place,
                      "blocks taken as ground because they reach an end of the section, where the "
                      "rock goes on: %ld; if they are to move, give a longer section",
                      blocks->cut_off);
}

static tp_status list(const tp_reader *reader, tp_cut_blocks *blocks,
                      const tp_quantity *unit_weight) {
  tp_block_list *many = &reader->scene->many;
  many->blocks = calloc((size_t)blocks->count, sizeof *many->blocks);
  if (many->blocks == NULL) return tp_fail_memory(reader->message, "the blocks of the slope");
  for (long k = 0; k < blocks->count; k++) {
    tp_cut_block *cut = blocks->blocks + k;
    tp_listed_block *own = tp_scene_next_block(reader->scene, many->place, unit_weight);
    own->fixed = cut->ground;
    own->name = cut->name;
    own->edge_sets = cut->sets;
    reader->scene->block.form = TP_OUTLINE_VERTICES;
    reader->scene->block.outline = cut->outline;
    cut->name = NULL;
    cut->sets = NULL;
    cut->outline = (tp_polyline){0};
    tp_scene_list_block(reader->scene, own);
  }
  return TP_OK;
}

tp_status tp_read_jointed_slope(const tp_reader *reader, const tp_node *node,
                                const tp_quantity *unit_weight) {
  tp_scene *scene = reader->scene;
  scene->many.slope.place = scene->many.place;
  tp_status status =
      tp_read_map(reader, scene, node, &tp_key_map_jointed_slope, "the jointed slope");
  if (status == TP_OK) status = read_section(reader, node);
  if (status == TP_OK) status = read_sets(reader, node);
  if (status == TP_OK) status = read_base(reader, node);
  tp_cut_blocks blocks = {0};
  if (status == TP_OK) status = tp_cut_blocks_init(&blocks, &scene->many.slope, reader->message);
  if (status == TP_OK) status = list(reader, &blocks, unit_weight);
  if (status == TP_OK) status = tell(reader, &blocks);
  tp_cut_blocks_clear(&blocks);
  return status;
}
