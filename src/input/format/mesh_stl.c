/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* STL: triangles without shared vertices, as text of which each `solid` is an object, or binary: a
 * head of 80 bytes, the number of triangles, 50 bytes for each. Normals are not read: what lies
 * inside is told by closed chains of the section. */

#include "format/mesh_source.h"

#include <stdint.h>
#include <string.h>

enum { HEAD = 84, RECORD = 50 };

/* ---- binary ------------------------------------------------------------------------------------
 */

static tp_status read_record(tp_mesh *mesh, const tp_mesh_source *source, const char *record,
                             fmpq *point) {
  int corners[3];
  for (int c = 0; c < 3; c++) {
    for (int k = 0; k < 3; k++) {
      const uint64_t bits = tp_mesh_bits(record + 12 * (c + 1) + 4 * k, 4, true);
      if (tp_mesh_set_double(point + k, (double)tp_mesh_float(bits))) continue;
      return tp_mesh_fail_file(source,
                               "triangle %d: a coordinate that is not a finite number; repair the "
                               "mesh",
                               mesh->face_numbers + 1);
    }
    const tp_status status = tp_mesh_add_vertex(mesh, corners + c, point, source->message);
    if (status != TP_OK) return status;
  }
  return tp_mesh_add_face(mesh, corners, 3, 0, source->message);
}

static tp_status read_binary(tp_mesh *mesh, const tp_mesh_source *source, fmpq *point) {
  const size_t length = (size_t)(source->end - source->at);
  const uint64_t count = tp_mesh_bits(source->at + HEAD - 4, 4, true);
  if (length != HEAD + RECORD * count) {
    return tp_mesh_fail_file(source,
                             "a binary STL with %lu triangles has %lu bytes, this one has "
                             "%lu; it was cut off or damaged: export it again",
                             (unsigned long)count, (unsigned long)(HEAD + RECORD * count),
                             (unsigned long)length);
  }
  tp_status status = TP_OK;
  for (uint64_t k = 0; k < count && status == TP_OK; k++) {
    status = read_record(mesh, source, source->at + HEAD + RECORD * k, point);
  }
  return status;
}

/* ---- text --------------------------------------------------------------------------------------
 */

static tp_status expect(tp_mesh_source *source, const char *text, const char *what) {
  const tp_mesh_word word = tp_mesh_file_word(source);
  return tp_mesh_word_is(word, text) ? TP_OK : tp_mesh_fail_word(source, word, what);
}

static tp_status read_vertex(tp_mesh *mesh, tp_mesh_source *source, int *corner, fmpq *point) {
  tp_status status = expect(source, "vertex",
                            "'vertex' is expected here: a facet of an STL has three of them; was "
                            "the file cut off?");
  for (int k = 0; k < 3 && status == TP_OK; k++) {
    status = tp_mesh_read_coordinate(point + k, source, tp_mesh_file_word(source));
  }
  return status == TP_OK ? tp_mesh_add_vertex(mesh, corner, point, source->message) : status;
}

/* Behind `facet`, to `endfacet`. */
static tp_status read_facet(tp_mesh *mesh, tp_mesh_source *source, int line, fmpq *point) {
  int corners[3];
  tp_mesh_word word = tp_mesh_file_word(source);
  for (int k = 0; k < 4 && !tp_mesh_word_is(word, "outer"); k++) word = tp_mesh_file_word(source);
  if (!tp_mesh_word_is(word, "outer")) {
    return tp_mesh_fail_word(source, word, "'outer loop' is expected here, after the normal");
  }
  tp_status status = expect(source, "loop", "'loop' is expected here, after 'outer'");
  for (int c = 0; c < 3 && status == TP_OK; c++) {
    status = read_vertex(mesh, source, corners + c, point);
  }
  if (status == TP_OK) {
    status = expect(source, "endloop",
                    "'endloop' is expected here: a facet of an STL has three vertices");
  }
  if (status == TP_OK) status = expect(source, "endfacet", "'endfacet' is expected here");
  return status == TP_OK ? tp_mesh_add_face(mesh, corners, 3, line, source->message) : status;
}

/* Behind `solid`, to `endsolid` and its name. */
static tp_status read_solid(tp_mesh *mesh, tp_mesh_source *source, fmpq *point) {
  const tp_mesh_word name = tp_mesh_rest_of_line(source);
  tp_status status = tp_mesh_begin_object(mesh, name.text, name.length, source->message);
  while (status == TP_OK) {
    const tp_mesh_word word = tp_mesh_file_word(source);
    if (tp_mesh_word_is(word, "endsolid")) {
      (void)tp_mesh_rest_of_line(source);
      return TP_OK;
    }
    if (!tp_mesh_word_is(word, "facet")) {
      return tp_mesh_fail_word(source, word,
                               word.length == 0
                                   ? "the file ends without 'endsolid': it was cut off; export it "
                                     "again"
                                   : "'facet' or 'endsolid' is expected here");
    }
    status = read_facet(mesh, source, word.line, point);
  }
  return status;
}

static tp_status read_text(tp_mesh *mesh, tp_mesh_source *source, fmpq *point) {
  tp_status status = TP_OK;
  while (status == TP_OK) {
    const tp_mesh_word word = tp_mesh_file_word(source);
    if (word.length == 0) return TP_OK;
    if (!tp_mesh_word_is(word, "solid")) {
      return tp_mesh_fail_word(source, word,
                               "'solid' is expected here, with which a text in STL begins");
    }
    status = read_solid(mesh, source, point);
  }
  return status;
}

/* A binary file may begin with the word `solid` too: then its length, or a byte zero, tells. */
static bool is_binary(const tp_mesh_source *source) {
  const size_t length = (size_t)(source->end - source->at);
  tp_mesh_source copy = *source;
  if (length >= HEAD && length == HEAD + RECORD * tp_mesh_bits(source->at + HEAD - 4, 4, true)) {
    return true;
  }
  return !tp_mesh_word_is(tp_mesh_file_word(&copy), "solid") ||
         memchr(source->at, '\0', length < 1000 ? length : 1000) != NULL;
}

tp_status tp_mesh_read_stl(tp_mesh *mesh, tp_mesh_source *source) {
  fmpq point[3];
  for (int k = 0; k < 3; k++) fmpq_init(point + k);
  tp_status status = TP_OK;
  if (!is_binary(source)) {
    status = read_text(mesh, source, point);
  } else if (source->end - source->at < HEAD) {
    status =
        tp_mesh_fail_file(source, "this is not an STL: it neither begins with 'solid' nor has the "
                                  "84 bytes with which a binary one begins");
  } else {
    status = read_binary(mesh, source, point);
  }
  for (int k = 0; k < 3; k++) fmpq_clear(point + k);
  return status;
}
