/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* PLY: vertices and faces between them, as text of one element a line, or binary; whatever other
 * elements and properties there are is passed over. */

#include "format/mesh_ply.h"

#include <stdio.h>
#include <stdlib.h>

typedef struct reader {
  tp_mesh *mesh;
  tp_mesh_source *source;
  tp_ply_header header;
  long vertex_count;
  int *vertices; /* of the mesh, by the numbers of the file */
  int corners[TP_MESH_CORNERS];
  long corner_count;
  fmpq point[3];
} reader;

/* A number as it stands in the file: a word, or bytes. */
typedef struct number {
  tp_ply_type type;
  tp_mesh_word word;
  uint64_t bits;
} number;

/* ---- one number --------------------------------------------------------------------------------
 */

static tp_status fail_number(const reader *r, const number *own, const char *what) {
  if (!r->header.binary) return tp_mesh_fail_word(r->source, own->word, what);
  if (r->vertices != NULL && r->corner_count >= 0) {
    return tp_mesh_fail_file(r->source, "face %d: %s", r->mesh->face_numbers + 1, what);
  }
  return tp_mesh_fail_file(r->source, "vertex %ld: %s", r->vertex_count + 1, what);
}

static tp_status next_number(const reader *r, number *own, tp_ply_type type) {
  tp_mesh_source *source = r->source;
  *own = (number){.type = type};
  if (!r->header.binary) {
    own->word = tp_mesh_line_word(source);
    return own->word.length > 0
               ? TP_OK
               : tp_mesh_fail_word(source, own->word,
                                   "this line ends too early; was the file cut off, or does its "
                                   "header state another number of elements?");
  }
  const int size = tp_ply_size(type);
  if (source->end - source->at < size) {
    return tp_mesh_fail_file(source, "the file ends before all elements of its header; it was cut "
                                     "off or damaged: export it again");
  }
  own->bits = tp_mesh_bits(source->at, size, r->header.little);
  source->at += size;
  return TP_OK;
}

static bool whole_of(const number *own, bool binary, long *value) {
  if (!binary) return tp_mesh_read_whole(value, own->word);
  const int spare = 64 - 8 * tp_ply_size(own->type);
  switch (own->type) {
  case TP_PLY_INT8:
  case TP_PLY_INT16:
  case TP_PLY_INT32:
    *value = (int64_t)(own->bits << spare) >> spare; /* with its sign */
    return true;
  case TP_PLY_UINT8:
  case TP_PLY_UINT16:
  case TP_PLY_UINT32:
    *value = (long)own->bits;
    return true;
  case TP_PLY_FLOAT:
  case TP_PLY_DOUBLE:
  case TP_PLY_NO_TYPE:
    break;
  }
  return false;
}

static tp_status read_coordinate(reader *r, fmpq *value, const number *own) {
  long whole = 0;
  bool finite = true;
  if (!r->header.binary) return tp_mesh_read_coordinate(value, r->source, own->word);
  if (own->type == TP_PLY_FLOAT) {
    finite = tp_mesh_set_double(value, (double)tp_mesh_float(own->bits));
  } else if (own->type == TP_PLY_DOUBLE) {
    finite = tp_mesh_set_double(value, tp_mesh_double(own->bits));
  } else if (whole_of(own, true, &whole)) {
    fmpq_set_si(value, whole, 1);
  }
  return finite ? TP_OK
                : fail_number(r, own, "a coordinate that is not a finite number; repair the mesh");
}

/* ---- one element -------------------------------------------------------------------------------
 */

static tp_status read_corner(reader *r, long k, const number *own) {
  long index = 0;
  if (!whole_of(own, r->header.binary, &index) || index < 0 || index >= r->vertex_count) {
    return fail_number(r, own,
                       "a corner is the number of a vertex, counted from 0, and there is none of "
                       "this number");
  }
  r->corners[k] = r->vertices[index];
  return TP_OK;
}

static tp_status read_list(reader *r, const tp_ply_property *property) {
  number own;
  long count = 0;
  tp_status status = next_number(r, &own, property->count_type);
  if (status != TP_OK) return status;
  if (!whole_of(&own, r->header.binary, &count) || count < 0) {
    return fail_number(r, &own, "the length of a list is a whole number");
  }
  const bool corners = property->role == TP_PLY_CORNERS;
  if (corners && (count < 3 || count > TP_MESH_CORNERS)) {
    return fail_number(r, &own, "a face has from 3 to 10000 corners");
  }
  if (corners) r->corner_count = count;
  for (long k = 0; k < count && status == TP_OK; k++) {
    status = next_number(r, &own, property->type);
    if (status == TP_OK && corners) status = read_corner(r, k, &own);
  }
  return status;
}

static tp_status read_property(reader *r, const tp_ply_property *property) {
  number own;
  if (property->is_list) return read_list(r, property);
  const tp_status status = next_number(r, &own, property->type);
  return status == TP_OK && property->role <= TP_PLY_Z
             ? read_coordinate(r, r->point + (property->role - TP_PLY_X), &own)
             : status;
}

static tp_status keep(reader *r, const tp_ply_element *element, int line) {
  tp_mesh_source *source = r->source;
  if (element->is_vertex) {
    return tp_mesh_add_vertex(r->mesh, r->vertices + r->vertex_count++, r->point, source->message);
  }
  return element->is_face
             ? tp_mesh_add_face(r->mesh, r->corners, r->corner_count, line, source->message)
             : TP_OK;
}

/* Of a text: to the next line that is not empty, and it must end where the element does. */
static tp_status read_one(reader *r, const tp_ply_element *element) {
  tp_mesh_source *source = r->source;
  tp_status status = TP_OK;
  if (!r->header.binary) {
    tp_mesh_source start = *source;
    while (tp_mesh_line_word(&start).length == 0 && tp_mesh_next_line(source)) start = *source;
  }
  const int line = r->header.binary ? 0 : source->line;
  r->corner_count = element->is_face ? 0 : -1;
  for (int k = 0; k < element->property_count && status == TP_OK; k++) {
    status = read_property(r, element->properties + k);
  }
  if (status == TP_OK && !r->header.binary) {
    const tp_mesh_word more = tp_mesh_line_word(source);
    if (more.length > 0) {
      return tp_mesh_fail_word(source, more, "more numbers than the properties of the header");
    }
    (void)tp_mesh_next_line(source);
  }
  return status == TP_OK ? keep(r, element, line) : status;
}

/* No element is read from less than two bytes, unless it has no property: a count that the file
 * cannot hold is refused before room for it is asked for. */
static tp_status read_elements(reader *r, const tp_ply_element *element) {
  const tp_mesh_source *source = r->source;
  if (element->property_count == 0) return TP_OK;
  if (element->count > source->end - source->at) {
    return tp_mesh_fail_word(source, element->place,
                             "the file is too short for so many; it was cut off or damaged: export "
                             "it again");
  }
  if (element->is_vertex) {
    r->vertices = calloc((size_t)element->count + 1, sizeof *r->vertices);
    if (r->vertices == NULL) return tp_fail_memory(source->message, "a mesh");
  }
  tp_status status = TP_OK;
  for (long k = 0; k < element->count && status == TP_OK; k++) status = read_one(r, element);
  return status;
}

static tp_status read_all(reader *r) {
  const tp_mesh_source *source = r->source;
  tp_status status = tp_ply_read_header(&r->header, r->source);
  for (int k = 0; k < r->header.element_count && status == TP_OK; k++) {
    status = read_elements(r, r->header.elements + k);
  }
  if (status != TP_OK) return status;
  const bool ended =
      r->header.binary ? source->at == source->end : tp_mesh_file_word(r->source).length == 0;
  return ended ? TP_OK
               : tp_mesh_fail_file(source, "the file goes on after all elements of its header; its "
                                           "counts are wrong, or it was damaged: export it again");
}

tp_status tp_mesh_read_ply(tp_mesh *mesh, tp_mesh_source *source) {
  reader *r = calloc(1, sizeof *r);
  if (r == NULL) return tp_fail_memory(source->message, "a mesh");
  r->mesh = mesh;
  r->source = source;
  for (int k = 0; k < 3; k++) fmpq_init(r->point + k);
  const tp_status status = read_all(r);
  for (int k = 0; k < 3; k++) fmpq_clear(r->point + k);
  free(r->vertices);
  free(r);
  return status;
}
