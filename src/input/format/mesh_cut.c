/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Pieces joined at shared crossings into chains, which begin at their leftmost point and lose
 * points that lie on a straight line between their neighbours. */

#include "format/mesh_cut.h"

#include "common/grow.h"
#include "format/mesh_crossings.h"

#include <stdlib.h>
#include <string.h>

void tp_mesh_section_clear(tp_mesh_section *section) {
  for (long k = 0; k < section->count; k++) tp_polyline_clear(&section->chains[k].points);
  free(section->chains);
  memset(section, 0, sizeof *section);
}

/* ---- points of a chain -------------------------------------------------------------------------
 */

static bool is_same_point(const tp_mesh_crossing *a, const tp_mesh_crossing *b) {
  return fmpq_equal(&a->s, &b->s) && fmpq_equal(&a->height, &b->height);
}

/* Is b on the straight line from a to c, between them? */
static bool is_between(const tp_mesh_crossing *a, const tp_mesh_crossing *b,
                       const tp_mesh_crossing *c) {
  if (tp_points_turn(&a->s, &a->height, &b->s, &b->height, &c->s, &c->height) != 0) return false;
  const int along = fmpq_cmp(&b->s, &a->s) * fmpq_cmp(&c->s, &b->s);
  const int up = fmpq_cmp(&b->height, &a->height) * fmpq_cmp(&c->height, &b->height);
  return along >= 0 && up >= 0;
}

/* Begin a closed chain at its leftmost point, the lowest of them, which lies between no others. */
static void rotate(const tp_crossings *c, int *nodes, long count, int *copy) {
  long first = 0;
  for (long k = 1; k < count; k++) {
    const tp_mesh_crossing *own = c->items + nodes[k], *best = c->items + nodes[first];
    const int side = fmpq_cmp(&own->s, &best->s);
    if (side < 0 || (side == 0 && fmpq_cmp(&own->height, &best->height) < 0)) first = k;
  }
  memcpy(copy, nodes, (size_t)count * sizeof *copy);
  for (long k = 0; k < count; k++) nodes[k] = copy[(first + k) % count];
}

/* Leave out points that repeat one or lie between two. How many are left. */
static long thin_out(const tp_crossings *c, int *nodes, long count, bool closed) {
  long kept = 0;
  for (long k = 0; k < count; k++) {
    if (kept > 0 && is_same_point(c->items + nodes[kept - 1], c->items + nodes[k])) continue;
    while (kept > 1 && is_between(c->items + nodes[kept - 2], c->items + nodes[kept - 1],
                                  c->items + nodes[k])) {
      kept--;
    }
    nodes[kept++] = nodes[k];
  }
  while (closed && kept > 1 && is_same_point(c->items + nodes[0], c->items + nodes[kept - 1]))
    kept--;
  while (closed && kept > 2 &&
         is_between(c->items + nodes[kept - 2], c->items + nodes[kept - 1], c->items + nodes[0])) {
    kept--;
  }
  return kept;
}

static tp_status add_chain(tp_mesh_section *section, const tp_crossings *c, const int *nodes,
                           long count, bool closed) {
  tp_section_chain *chains =
      tp_grow(section->chains, section->count, &section->room, sizeof *chains);
  if (chains == NULL) return tp_fail_memory(c->message, "a section");
  section->chains = chains;
  tp_section_chain *own = chains + section->count++;
  *own = (tp_section_chain){.closed = closed, .points = {.file = c->mesh->file}};
  for (long k = 0; k < count; k++) {
    const tp_mesh_crossing *node = c->items + nodes[k];
    const int line = c->mesh->faces[node->face].line;
    const tp_mark mark = {line, line > 0 ? 1 : 0};
    if (k == 0) own->points.mark = mark;
    if (!tp_polyline_append(&own->points, &node->s, &node->height, mark)) {
      return tp_fail_memory(c->message, "a section");
    }
  }
  return TP_OK;
}

/* ---- joining -----------------------------------------------------------------------------------
 */

/* From a crossing along unused pieces, into `nodes`. How many there are; closed where it ends where
 * it began, which is then not put twice. */
static long follow(tp_crossings *c, int start, int *nodes, bool *closed) {
  long count = 0;
  int node = start;
  *closed = false;
  for (bool more = true; more;) {
    nodes[count++] = node;
    more = false;
    for (int k = 0; k < c->items[node].piece_count && !more; k++) {
      tp_mesh_piece *piece = c->pieces + c->items[node].pieces[k];
      if (piece->used) continue;
      piece->used = more = true;
      node = piece->ends[piece->ends[0] == node];
    }
    *closed = more && node == start;
    more = more && !*closed;
  }
  return count;
}

static bool is_used(const tp_crossings *c, const tp_mesh_crossing *own) {
  for (int k = 0; k < own->piece_count; k++) {
    if (!c->pieces[own->pieces[k]].used) return false;
  }
  return true;
}

static tp_status join_from(tp_mesh_section *section, tp_crossings *c, int start, int *nodes) {
  bool closed = false;
  long count = follow(c, start, nodes, &closed);
  if (closed) rotate(c, nodes, count, nodes + count);
  count = thin_out(c, nodes, count, closed);
  if (count < (closed ? 3 : 2)) {
    section->specks++;
    return TP_OK;
  }
  return add_chain(section, c, nodes, count, closed);
}

/* Open chains first, each from one of its ends. */
static tp_status join(tp_mesh_section *section, tp_crossings *c) {
  int *nodes = calloc(2 * (size_t)c->count + 1, sizeof *nodes);
  if (nodes == NULL) return tp_fail_memory(c->message, "a section");
  tp_status status = TP_OK;
  for (int open = 1; open >= 0; open--) {
    for (int k = 0; k < c->count && status == TP_OK; k++) {
      const tp_mesh_crossing *own = c->items + k;
      if ((open == 0 || own->piece_count == 1) && !is_used(c, own)) {
        status = join_from(section, c, k, nodes);
      }
    }
  }
  free(nodes);
  return status;
}

tp_status tp_mesh_cut(tp_mesh_section *section, const tp_mesh *mesh, long object,
                      const tp_section_plane *plane, tp_message *message) {
  tp_crossings crossings;
  *section = (tp_mesh_section){0};
  tp_status status = tp_crossings_find(&crossings, mesh, object, plane, message);
  if (status == TP_OK) status = join(section, &crossings);
  for (long k = 0; k < crossings.count; k++) {
    const tp_mesh_crossing *own = crossings.items + k;
    section->flipped += own->piece_count == 2 && own->upward != 0;
  }
  section->is_left = crossings.left;
  tp_crossings_clear(&crossings);
  if (status != TP_OK) tp_mesh_section_clear(section);
  return status;
}
