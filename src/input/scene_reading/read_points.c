/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Chains of points out of nodes: lists, files of points, sections of meshes; each read once, as far
 * as no number varies that it is made of. */

#include "scene/members.h"
#include "scene_reading/csv.h"
#include "scene_reading/read.h"

static tp_status read_vertex(const tp_reader *reader, tp_polyline *line, const tp_node *node,
                             const char *name) {
  if (node->kind != TP_NODE_SEQUENCE || node->count != 2) {
    return tp_read_fail(reader, TP_FAULT_FORMAT, node, "a vertex of %s is written [x, y]", name);
  }
  fmpq_t x, y;
  fmpq_init(x);
  fmpq_init(y);
  tp_status status = tp_read_number(reader, x, node->first, "x");
  if (status == TP_OK) status = tp_read_number(reader, y, node->last, "y");
  if (status == TP_OK && !tp_polyline_append(line, x, y, node->mark)) {
    status = tp_fail_memory(reader->message, name);
  }
  fmpq_clear(x);
  fmpq_clear(y);
  return status;
}

/* What is read: a chain open or closed, or an outline that may have holes. */
typedef struct chain_kind {
  bool closed, holed;
  const char *name; /* in messages */
} chain_kind;

/* A list of [x, y], or a file: `chain` gets the points, and what is noted of them. */
static tp_status read_chain(const tp_reader *reader, tp_file_chain *chain, chain_kind kind) {
  const char *name = kind.name;
  const tp_node *node = chain->node;
  tp_polyline *line = &chain->line;
  tp_status status = TP_OK;
  *line = (tp_polyline){.file = reader->scene->path, .mark = node->mark};
  reader->reading->varies = false;
  if (node->kind == TP_NODE_SCALAR) {
    const char *path = tp_scene_file_name(reader->scene->file, node->text);
    if (path == NULL) return tp_fail_memory(reader->message, name);
    const char *unit = NULL;
    status = tp_csv_read(line, &unit, path, kind.closed, &chain->notes, reader->message);
    if (status == TP_OK) {
      status = tp_csv_check_unit(unit, reader->scene->length_unit, path, "the scene's length_unit",
                                 reader->message);
    }
  } else if (node->kind == TP_NODE_SEQUENCE) {
    for (const tp_node *p = node->first; p != NULL && status == TP_OK; p = p->next) {
      status = read_vertex(reader, line, p, name);
    }
    if (kind.closed) tp_polyline_drop_closing_point(line);
  } else if (tp_node_get(node, "mesh") != NULL) {
    status = tp_read_mesh(reader, line, kind.holed ? &chain->holes : NULL, node, kind.closed,
                          &chain->notes);
  } else {
    status =
        tp_read_fail(reader, TP_FAULT_FORMAT, node,
                     "%s must be a list of [x, y], the name of a CSV file, or {mesh: FILE}", name);
  }
  bool shared = status != TP_OK || tp_polyline_make_shared(line);
  for (long k = 0; k < chain->holes.count && shared; k++) {
    shared = tp_polyline_make_shared(chain->holes.lines + k);
  }
  if (!shared) status = tp_fail_memory(reader->message, name);
  chain->fixed = !reader->reading->varies;
  return status;
}

/* The points of a chain, and the notes on it. Of its holes the block has its own. */
static tp_status take_chain(const tp_reader *reader, tp_polyline *line,
                            const tp_file_chain *chain) {
  tp_block_description *block = &reader->scene->block;
  const tp_status status = tp_notes_append(&reader->scene->notes, &chain->notes, reader->message);
  if (status != TP_OK) return status;
  if (!tp_scene_hole_room(reader->scene, chain->holes.count)) {
    return tp_fail_memory(reader->message, "the holes");
  }
  for (long k = 0; k < chain->holes.count; k++) {
    block->holes[block->hole_count++] = tp_polyline_share(chain->holes.lines + k);
  }
  *line = tp_polyline_share(&chain->line);
  return TP_OK;
}

/* What it holds is its own: a list of the file's keeps what is fixed. */
static void clear_chain(tp_file_chain *chain) {
  tp_polyline_clear(&chain->line);
  tp_polylines_clear(&chain->holes);
  tp_notes_clear(&chain->notes);
}

/* The file was never read before: what does not depend on a number that varies is kept. */
static tp_status read_first(const tp_reader *reader, tp_polyline *line, const tp_node *node,
                            chain_kind kind) {
  tp_file_chain *chain = tp_scene_file_add_chain(reader->scene->file, node);
  if (chain == NULL) return tp_fail_memory(reader->message, kind.name);
  tp_status status = read_chain(reader, chain, kind);
  if (status == TP_OK) status = take_chain(reader, line, chain);
  if (!chain->fixed) clear_chain(chain);
  return status;
}

/* Of a mesh the plane that cuts it, too. */
static bool is_varied(const tp_scene *scene, const tp_node *node) {
  const tp_node *section =
      tp_node_get(node, "mesh") != NULL ? tp_node_get(scene->source, "section") : NULL;
  for (long k = 0; k < scene->override_count; k++) {
    const tp_node *own = scene->overrides[k].node;
    if (tp_node_is_within(own, node)) return true;
    if (section != NULL && tp_node_is_within(own, section)) return true;
  }
  return false;
}

/* Chains come in the order in which they came before. What varies is a list or a section: no number
 * names a file. */
static tp_status read_again(const tp_reader *reader, tp_polyline *line, const tp_node *node,
                            chain_kind kind) {
  const tp_file_chain *kept = reader->scene->file->chains + reader->reading->next_chain++;
  if (node->kind == TP_NODE_SCALAR || (kept->fixed && !is_varied(reader->scene, node))) {
    return take_chain(reader, line, kept);
  }
  tp_file_chain chain = {.node = node};
  tp_status status = read_chain(reader, &chain, kind);
  if (status == TP_OK) status = take_chain(reader, line, &chain);
  clear_chain(&chain);
  return status;
}

static tp_status read_kind(const tp_reader *reader, tp_polyline *line, const tp_node *node,
                           chain_kind kind) {
  if (tp_node_get(node, "mesh") != NULL) reader->reading->cut = true; /* now, or as it was kept */
  return reader->reading->again ? read_again(reader, line, node, kind)
                                : read_first(reader, line, node, kind);
}

tp_status tp_read_points(const tp_reader *reader, tp_polyline *line, const tp_node *node,
                         bool closed, const char *name) {
  return read_kind(reader, line, node, (chain_kind){.closed = closed, .name = name});
}

tp_status tp_read_outline(const tp_reader *reader, const tp_node *node) {
  const chain_kind kind = {.closed = true, .holed = true, .name = "the outline"};
  return read_kind(reader, &reader->scene->block.outline, node, kind);
}

const tp_polyline *tp_read_kept(const tp_reader *reader, const tp_node *node) {
  if (!reader->reading->again) return NULL;
  const tp_file_chain *kept = reader->scene->file->chains + reader->reading->next_chain++;
  return kept->fixed && !is_varied(reader->scene, node) ? &kept->line : NULL;
}

bool tp_read_keep(const tp_reader *reader, const tp_polyline *line, const tp_node *node) {
  if (reader->reading->again) return true;
  tp_file_chain *chain = tp_scene_file_add_chain(reader->scene->file, node);
  if (chain == NULL) return false;
  chain->fixed = !reader->reading->varies;
  if (chain->fixed) chain->line = tp_polyline_share(line);
  return true;
}
