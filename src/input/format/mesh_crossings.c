/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Crossing points of edges in a hash table, so that neighbouring faces share them; the crossings of
 * a face that is cut several times are sorted along the plane and paired. */

#include "format/mesh_crossings.h"

#include "common/grow.h"

#include <stdint.h>
#include <stdlib.h>

void tp_crossings_clear(tp_crossings *crossings) {
  for (long k = 0; k < crossings->count; k++) {
    fmpq_clear(&crossings->items[k].s);
    fmpq_clear(&crossings->items[k].height);
  }
  free(crossings->items);
  free(crossings->slots);
  free(crossings->pieces);
  free(crossings->sides);
}

static tp_status fail_face(const tp_crossings *c, const tp_mesh_face *face, const char *what) {
  const tp_place place = {c->mesh->file, face->line, 0};
  return tp_refuse(c->message, TP_FAULT_GEOMETRY, place, "face %d %s", face->number, what);
}

/* ---- one crossing ------------------------------------------------------------------------------
 */

static const fmpq *vertex(const tp_crossings *c, int index) {
  return c->mesh->vertices + 3L * index;
}

/* The point between both ends in the ratio of their distances from the plane. */
static void find_point(const tp_crossings *c, tp_mesh_crossing *own) {
  fmpq_t from, to, s, height;
  fmpq_init(from);
  fmpq_init(to);
  fmpq_init(s);
  fmpq_init(height);
  tp_section_plane_across(from, c->plane, vertex(c, own->a));
  tp_section_plane_across(to, c->plane, vertex(c, own->b));
  tp_section_plane_along(&own->s, &own->height, c->plane, vertex(c, own->a));
  tp_section_plane_along(s, height, c->plane, vertex(c, own->b));
  fmpq_sub(to, from, to);
  fmpq_div(from, from, to);
  fmpq_sub(s, s, &own->s);
  fmpq_sub(height, height, &own->height);
  fmpq_addmul(&own->s, s, from);
  fmpq_addmul(&own->height, height, from);
  fmpq_clear(from);
  fmpq_clear(to);
  fmpq_clear(s);
  fmpq_clear(height);
}

static int *find_slot(const tp_crossings *c, int a, int b) {
  const uint64_t mask = (uint64_t)c->slot_count - 1;
  uint64_t at = ((uint64_t)a << 32 | (uint64_t)b) * 0x9e3779b97f4a7c15;
  at = (at ^ (at >> 29)) & mask;
  while (c->slots[at] != 0 &&
         (c->items[c->slots[at] - 1].a != a || c->items[c->slots[at] - 1].b != b)) {
    at = (at + 1) & mask;
  }
  return c->slots + at;
}

/* Never more than half full. */
static bool reserve_slot(tp_crossings *c) {
  if (2 * (c->count + 1) <= c->slot_count) return true;
  int *const old = c->slots;
  const long count = c->slot_count == 0 ? 64 : 2 * c->slot_count;
  int *slots = calloc((size_t)count, sizeof *slots);
  if (slots == NULL) return false;
  c->slots = slots;
  c->slot_count = count;
  for (int k = 0; k < c->count; k++) *find_slot(c, c->items[k].a, c->items[k].b) = k + 1;
  free(old);
  return true;
}

/* Of the edge from one corner of a face to the next. */
static tp_status find_crossing(tp_crossings *c, int *index, int face, int from, int to) {
  const int a = from < to ? from : to, b = from < to ? to : from;
  if (!reserve_slot(c)) return tp_fail_memory(c->message, "a section");
  int *slot = find_slot(c, a, b);
  if (*slot == 0) {
    tp_mesh_crossing *items = tp_grow(c->items, c->count, &c->room, sizeof *items);
    if (items == NULL) return tp_fail_memory(c->message, "a section");
    c->items = items;
    items[c->count] = (tp_mesh_crossing){.a = a, .b = b, .face = face};
    fmpq_init(&items[c->count].s);
    fmpq_init(&items[c->count].height);
    find_point(c, items + c->count);
    *slot = (int)++c->count;
  }
  *index = *slot - 1;
  c->items[*index].upward += c->sides[to] > c->sides[from] ? 1 : -1;
  return TP_OK;
}

/* ---- one face ----------------------------------------------------------------------------------
 */

static tp_status add_piece(tp_crossings *c, const tp_mesh_face *face, int one, int other) {
  tp_mesh_piece *pieces = tp_grow(c->pieces, c->piece_count, &c->piece_room, sizeof *pieces);
  if (pieces == NULL) return tp_fail_memory(c->message, "a section");
  c->pieces = pieces;
  for (int e = 0; e < 2; e++) {
    tp_mesh_crossing *end = c->items + (e == 0 ? one : other);
    if (end->piece_count == 2) {
      return fail_face(c, face,
                       "shares an edge with two other faces where the plane cuts it; a surface has "
                       "two faces at an edge: name one 'object', or take the faces apart");
    }
    end->pieces[end->piece_count++] = (int)c->piece_count;
  }
  pieces[c->piece_count++] = (tp_mesh_piece){.ends = {one, other}};
  return TP_OK;
}

static int compare_crossings(const tp_crossings *c, int one, int other) {
  const tp_mesh_crossing *a = c->items + one, *b = c->items + other;
  const int side = fmpq_cmp(&a->s, &b->s);
  return side != 0 ? side : fmpq_cmp(&a->height, &b->height);
}

/* A face that is not convex is cut in several pieces: the first of its crossings along the plane
 * begins the first, which ends in the second. There are few. */
static void sort_crossings(const tp_crossings *c, int *found, long count) {
  for (long k = 1; k < count; k++) {
    const int own = found[k];
    long at = k;
    for (; at > 0 && compare_crossings(c, found[at - 1], own) > 0; at--) found[at] = found[at - 1];
    found[at] = own;
  }
}

/* A face on whose corners lie in the plane all, and not on one line. */
static bool lies_in_plane(const tp_crossings *c, const tp_mesh_face *face) {
  const int *corners = c->mesh->corners + face->first;
  bool flat = false;
  fmpq_t s[3], height[3];
  for (int k = 0; k < face->count; k++) {
    fmpq_t across;
    fmpq_init(across);
    tp_section_plane_across(across, c->plane, vertex(c, corners[k]));
    const bool on = fmpq_is_zero(across);
    fmpq_clear(across);
    if (!on) return false;
  }
  for (int k = 0; k < 3; k++) {
    fmpq_init(s[k]);
    fmpq_init(height[k]);
  }
  for (int k = 2; k < face->count && !flat; k++) {
    const int three[] = {corners[0], corners[1], corners[k]};
    for (int p = 0; p < 3; p++) {
      tp_section_plane_along(s[p], height[p], c->plane, vertex(c, three[p]));
    }
    flat = tp_points_turn(s[0], height[0], s[1], height[1], s[2], height[2]) != 0;
  }
  for (int k = 0; k < 3; k++) {
    fmpq_clear(s[k]);
    fmpq_clear(height[k]);
  }
  return flat;
}

static tp_status cut_face(tp_crossings *c, int index, int *found) {
  const tp_mesh_face *face = c->mesh->faces + index;
  const int *corners = c->mesh->corners + face->first;
  long count = 0;
  bool on = true;
  for (int k = 0; k < face->count; k++) {
    const int from = corners[k], to = corners[k + 1 < face->count ? k + 1 : 0];
    on = on && c->sides[from] == 0;
    if ((c->sides[from] < 0) == (c->sides[to] < 0)) continue;
    const tp_status status = find_crossing(c, found + count++, index, from, to);
    if (status != TP_OK) return status;
  }
  c->left = c->left || (count == 0 && c->sides[corners[0]] >= 0);
  if (on && lies_in_plane(c, face)) {
    return fail_face(c, face,
                     "lies in the plane of the section, which has no outline there; shift the "
                     "plane a little to the side that is meant");
  }
  if (count > 2) sort_crossings(c, found, count);
  tp_status status = TP_OK;
  for (long k = 0; k + 1 < count && status == TP_OK; k += 2) {
    status = add_piece(c, face, found[k], found[k + 1]);
  }
  return status;
}

/* ---- the mesh ----------------------------------------------------------------------------------
 */

tp_status tp_crossings_find(tp_crossings *crossings, const tp_mesh *mesh, long object,
                            const tp_section_plane *plane, tp_message *message) {
  int most = 0;
  *crossings = (tp_crossings){.mesh = mesh, .plane = plane, .message = message};
  for (long k = 0; k < mesh->face_count; k++) {
    if (mesh->faces[k].count > most) most = mesh->faces[k].count;
  }
  int *found = calloc((size_t)most + 1, sizeof *found);
  crossings->sides = calloc((size_t)mesh->vertex_count + 1, sizeof *crossings->sides);
  tp_status status =
      found != NULL && crossings->sides != NULL ? TP_OK : tp_fail_memory(message, "a section");
  for (long k = 0; status == TP_OK && k < mesh->vertex_count; k++) {
    crossings->sides[k] = (signed char)tp_section_plane_side(plane, mesh->vertices + 3 * k);
  }
  for (int k = 0; status == TP_OK && k < mesh->face_count; k++) {
    if (object < 0 || mesh->faces[k].object == object) status = cut_face(crossings, k, found);
  }
  free(found);
  return status;
}
