/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* OBJ of Wavefront: vertices `v x y z`, faces `f` between them by their numbers, counted from 1, or
 * below zero from the last one back; `o` and `g` begin objects. Normals, textures, materials, lines
 * and points are passed over, curved surfaces refused. */

#include "format/mesh_source.h"

#include "common/grow.h"

#include <stdlib.h>
#include <string.h>

typedef struct reader {
  tp_mesh *mesh;
  tp_mesh_source *source;
  long count, room;
  int *vertices; /* of the mesh, by the numbers of the file */
  int corners[TP_MESH_CORNERS];
  fmpq point[3];
} reader;

static tp_status read_vertex(reader *r) {
  tp_mesh_source *source = r->source;
  tp_status status = TP_OK;
  for (int k = 0; k < 3 && status == TP_OK; k++) {
    status = tp_mesh_read_coordinate(r->point + k, source, tp_mesh_line_word(source));
  }
  if (status != TP_OK) return status;
  int *vertices = tp_grow(r->vertices, r->count, &r->room, sizeof *r->vertices);
  if (vertices == NULL) return tp_fail_memory(source->message, "a mesh");
  r->vertices = vertices;
  return tp_mesh_add_vertex(r->mesh, vertices + r->count++, r->point, source->message);
}

/* One corner, as 7, 7/1, 7//3, 7/1/3 or -1. */
static tp_status read_corner(const reader *r, tp_mesh_word word, int *corner) {
  const char *slash = memchr(word.text, '/', word.length);
  tp_mesh_word own = word;
  long number = 0;
  if (slash != NULL) own.length = (size_t)(slash - word.text);
  if (!tp_mesh_read_whole(&number, own) || number == 0) {
    return tp_mesh_fail_word(r->source, word,
                             "a corner of a face is the number of a vertex, counted from 1");
  }
  const long index = number > 0 ? number - 1 : r->count + number;
  if (index < 0 || index >= r->count) {
    return tp_mesh_fail_word(r->source, word,
                             "there is no vertex of this number above this face; was the file cut "
                             "off, or put together of two?");
  }
  *corner = r->vertices[index];
  return TP_OK;
}

static tp_status read_face(reader *r, int line) {
  long count = 0;
  for (;;) {
    const tp_mesh_word word = tp_mesh_line_word(r->source);
    if (word.length == 1 && word.text[0] == '\\' && tp_mesh_next_line(r->source)) continue;
    if (word.length == 0) break;
    if (count == TP_MESH_CORNERS) {
      return tp_mesh_fail_word(r->source, word, "a face of more than 10000 corners");
    }
    const tp_status status = read_corner(r, word, r->corners + count++);
    if (status != TP_OK) return status;
  }
  if (count < 3) return tp_mesh_fail_line(r->source, "a face has three corners, or more");
  return tp_mesh_add_face(r->mesh, r->corners, count, line, r->source->message);
}

static tp_status begin_object(const reader *r) {
  const tp_mesh_word name = tp_mesh_rest_of_line(r->source);
  return tp_mesh_begin_object(r->mesh, name.text, name.length, r->source->message);
}

static bool is_one_of(tp_mesh_word word, const char *const *words) {
  for (; *words != NULL; words++) {
    if (tp_mesh_word_is(word, *words)) return true;
  }
  return false;
}

static tp_status read_statement(reader *r, tp_mesh_word word) {
  static const char *const passed[] = {"vn",     "vt", "vp",  "s",      "l",      "p", "usemtl",
                                       "mtllib", "mg", "lod", "maplib", "usemap", NULL};
  static const char *const curved[] = {"cstype", "deg", "curv", "curv2", "surf",
                                       "bzp",    "bsp", "cdc",  "res",   NULL};
  if (word.length == 0 || word.text[0] == '#') return TP_OK;
  if (tp_mesh_word_is(word, "v")) return read_vertex(r);
  if (tp_mesh_word_is(word, "f") || tp_mesh_word_is(word, "fo")) return read_face(r, word.line);
  if (tp_mesh_word_is(word, "o") || tp_mesh_word_is(word, "g")) return begin_object(r);
  if (is_one_of(word, passed)) return TP_OK;
  if (is_one_of(word, curved)) {
    return tp_mesh_fail_word(r->source, word,
                             "a curved surface; export it as a mesh of flat faces");
  }
  return tp_mesh_fail_word(
      r->source, word, "this is not a statement of an OBJ file, such as 'v 0 0 1' or 'f 1 2 3'");
}

tp_status tp_mesh_read_obj(tp_mesh *mesh, tp_mesh_source *source) {
  reader *r = calloc(1, sizeof *r);
  if (r == NULL) return tp_fail_memory(source->message, "a mesh");
  r->mesh = mesh;
  r->source = source;
  for (int k = 0; k < 3; k++) fmpq_init(r->point + k);
  tp_status status = TP_OK;
  do {
    status = read_statement(r, tp_mesh_line_word(source));
  } while (status == TP_OK && tp_mesh_next_line(source));
  for (int k = 0; k < 3; k++) fmpq_clear(r->point + k);
  free(r->vertices);
  free(r);
  return status;
}
