/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The order of the steps, and from triangles back to a mesh. */

#include "solid/mend.h"

#include "solid/mend_steps.h"

#include <stdlib.h>
#include <string.h>

void tp_solid_repair_clear(tp_solid_repair *record) {
  free(record->gaps);
  *record = (tp_solid_repair){.gap_count = 0};
}

/* ---- the order ---------------------------------------------------------------------------------
 */

static bool take(tp_mending *m) {
  const tp_surface *s = m->surface;
  if (!tp_mending_reserve(m, s->triangle_count)) return false;
  for (long t = 0; t < s->triangle_count; t++) {
    const int *own = s->triangles + 3 * t;
    tp_mending_add(m, own[0], own[1], own[2], s->faces[t]);
  }
  return true;
}

static void count_turned(tp_mending *m) {
  for (long t = 0; t < m->count; t++) {
    if (!m->turned[t] || m->faces[t] < 0) continue;
    if (m->record->turned_triangles++ == 0) m->record->first_turned = tp_mending_number(m, t);
  }
}

static bool mend(tp_mending *m, const tp_mend_wish *wish) {
  bool one_sided = false;
  if (!take(m)) return false;
  if (wish->merge_within > 0 && !tp_mending_merge(m, wish->merge_within)) return false;
  if (!tp_mending_drop_duplicates(m)) return false;
  if (wish->drop_below > 0 && !tp_mending_drop_pieces(m, wish->drop_below)) return false;
  if (!tp_mending_orient(m, &one_sided)) return false;
  if (!one_sided && !(tp_mending_close(m) && tp_mending_part_flat(m))) return false;
  tp_mending_measure(m);
  count_turned(m);
  return true;
}

/* ---- a mesh ------------------------------------------------------------------------------------
 */

/* The vertex of the mended mesh: `places` has one more, or 0 where it was not met before. */
static tp_status place_of(int *place, tp_mesh *mended, int *places, const tp_mending *m, int vertex,
                          tp_message *message) {
  tp_status status = TP_OK;
  if (places[vertex] == 0) {
    const fmpq *at = m->surface->mesh->vertices + 3L * m->surface->sources[vertex];
    status = tp_mesh_add_vertex(mended, place, at, message);
    if (status == TP_OK) places[vertex] = *place + 1;
  }
  *place = places[vertex] - 1;
  return status;
}

static tp_status put_triangle(tp_mesh *mended, int *places, const tp_mending *m, long t,
                              tp_message *message) {
  const tp_mesh_face *face = m->faces[t] < 0 ? NULL : m->surface->mesh->faces + m->faces[t];
  int corners[3];
  tp_status status = TP_OK;
  for (int c = 0; c < 3 && status == TP_OK; c++) {
    status = place_of(corners + c, mended, places, m, m->triangles[3 * t + c], message);
  }
  if (status == TP_OK) {
    status = tp_mesh_add_face(mended, corners, 3, face != NULL ? face->line : 0, message);
  }
  if (status == TP_OK) {
    mended->faces[mended->face_count - 1].number = (int)tp_mending_number(m, t);
  }
  return status;
}

static tp_status put_all(tp_mesh *mended, const tp_mending *m, long object, tp_message *message) {
  const tp_mesh *mesh = m->surface->mesh;
  const char *name = object >= 0 ? mesh->objects[object].name : "";
  int *places = calloc((size_t)m->surface->vertex_count, sizeof *places);
  if (places == NULL) return tp_fail_memory(message, "a mended mesh");
  tp_status status = tp_mesh_begin_object(mended, name, strlen(name), message);
  for (long t = 0; t < m->count && status == TP_OK; t++) {
    status = put_triangle(mended, places, m, t, message);
  }
  mended->is_mended = true;
  mended->left_out = mesh->left_out;
  mended->left_out_number = mesh->left_out_number;
  mended->left_out_line = mesh->left_out_line;
  free(places);
  return status;
}

tp_status tp_mesh_mend(tp_mesh *mended, tp_solid_repair *record, const tp_mesh *mesh, long object,
                       const tp_mend_wish *wish, tp_message *message) {
  tp_surface surface;
  memset(mended, 0, sizeof *mended);
  mended->file = mesh->file;
  *record = (tp_solid_repair){.merge_within = wish->merge_within, .drop_below = wish->drop_below};
  tp_status status = tp_surface_init(&surface, mesh, object, message);
  if (status != TP_OK) return status;
  tp_mending m = {.surface = &surface, .record = record};
  status = mend(&m, wish) ? put_all(mended, &m, object, message)
                          : tp_fail_memory(message, "a mended mesh");
  if (status == TP_OK && m.count == 0) {
    status = tp_refuse(message, TP_FAULT_GEOMETRY, (tp_place){mesh->file, 0, 0},
                       "nothing is left of the mesh where points are merged within %g and pieces "
                       "below %g of its area are dropped",
                       wish->merge_within, wish->drop_below);
  }
  free(m.triangles);
  free(m.faces);
  free(m.turned);
  tp_surface_clear(&surface);
  return status;
}
