/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Header of a PLY file (Turk, Stanford polygon format): format, elements and properties with their
 * types, and the check that it has vertices with x, y, z before faces with corners. */

#include "format/mesh_ply.h"

#include <string.h>

int tp_ply_size(tp_ply_type type) {
  static const int sizes[] = {1, 1, 2, 2, 4, 4, 4, 8, 0};
  return sizes[type];
}

static tp_ply_type type_of(tp_mesh_word word) {
  static const struct {
    const char *name;
    tp_ply_type type;
  } names[] = {{"char", TP_PLY_INT8},     {"int8", TP_PLY_INT8},     {"uchar", TP_PLY_UINT8},
               {"uint8", TP_PLY_UINT8},   {"short", TP_PLY_INT16},   {"int16", TP_PLY_INT16},
               {"ushort", TP_PLY_UINT16}, {"uint16", TP_PLY_UINT16}, {"int", TP_PLY_INT32},
               {"int32", TP_PLY_INT32},   {"uint", TP_PLY_UINT32},   {"uint32", TP_PLY_UINT32},
               {"float", TP_PLY_FLOAT},   {"float32", TP_PLY_FLOAT}, {"double", TP_PLY_DOUBLE},
               {"float64", TP_PLY_DOUBLE}};
  for (size_t k = 0; k < sizeof names / sizeof names[0]; k++) {
    if (tp_mesh_word_is(word, names[k].name)) return names[k].type;
  }
  return TP_PLY_NO_TYPE;
}

static tp_ply_role role_of(const tp_ply_element *element, const tp_ply_property *property,
                           tp_mesh_word name) {
  static const char *const coordinates[] = {"x", "y", "z"};
  for (int k = 0; element->is_vertex && !property->is_list && k < 3; k++) {
    if (tp_mesh_word_is(name, coordinates[k])) return (tp_ply_role)(TP_PLY_X + k);
  }
  const bool corners =
      tp_mesh_word_is(name, "vertex_indices") || tp_mesh_word_is(name, "vertex_index");
  return element->is_face && property->is_list && corners ? TP_PLY_CORNERS : TP_PLY_PASSED_OVER;
}

static tp_status read_property(tp_ply_header *header, tp_mesh_source *source) {
  tp_ply_property own = {.count_type = TP_PLY_NO_TYPE};
  tp_mesh_word word = tp_mesh_line_word(source);
  if (header->element_count == 0) {
    return tp_mesh_fail_word(source, word, "a property stands below the element that has it");
  }
  tp_ply_element *element = header->elements + header->element_count - 1;
  own.is_list = tp_mesh_word_is(word, "list");
  if (own.is_list) {
    word = tp_mesh_line_word(source);
    own.count_type = type_of(word);
    if (own.count_type >= TP_PLY_FLOAT) {
      return tp_mesh_fail_word(source, word, "the length of a list has an integer type");
    }
    word = tp_mesh_line_word(source);
  }
  own.type = type_of(word);
  if (own.type == TP_PLY_NO_TYPE) {
    return tp_mesh_fail_word(source, word,
                             "a type of PLY is expected here: char, uchar, short, ushort, int, "
                             "uint, float or double");
  }
  if (element->property_count == TP_PLY_PROPERTIES) {
    return tp_mesh_fail_word(source, word, "more than 64 properties of an element");
  }
  word = tp_mesh_line_word(source);
  own.role = role_of(element, &own, word);
  if (own.role == TP_PLY_CORNERS && own.type >= TP_PLY_FLOAT) {
    return tp_mesh_fail_word(source, word, "corners of faces have an integer type");
  }
  for (int k = 0; k < element->property_count && own.role != TP_PLY_PASSED_OVER; k++) {
    if (element->properties[k].role == own.role) {
      return tp_mesh_fail_word(source, word, "this property is given twice");
    }
  }
  element->properties[element->property_count++] = own;
  return TP_OK;
}

static tp_status read_element(tp_ply_header *header, tp_mesh_source *source) {
  const tp_mesh_word name = tp_mesh_line_word(source), count = tp_mesh_line_word(source);
  tp_ply_element own = {.is_vertex = tp_mesh_word_is(name, "vertex"),
                        .is_face = tp_mesh_word_is(name, "face"),
                        .place = name};
  if (!tp_mesh_read_whole(&own.count, count) || own.count < 0) {
    return tp_mesh_fail_word(source, count, "an element line states how many there are");
  }
  if ((own.is_vertex || own.is_face) && own.count > TP_MESH_MOST) {
    return tp_mesh_fail_word(source, count,
                             "more than 20 million; thin the mesh out, or cut away what is not "
                             "needed");
  }
  if (header->element_count == TP_PLY_ELEMENTS) {
    return tp_mesh_fail_word(source, name, "more than 16 kinds of elements");
  }
  header->elements[header->element_count++] = own;
  return TP_OK;
}

static tp_status read_format(tp_ply_header *header, tp_mesh_source *source) {
  const tp_mesh_word word = tp_mesh_line_word(source), version = tp_mesh_line_word(source);
  header->little = tp_mesh_word_is(word, "binary_little_endian");
  header->binary = header->little || tp_mesh_word_is(word, "binary_big_endian");
  if (!header->binary && !tp_mesh_word_is(word, "ascii")) {
    return tp_mesh_fail_word(source, word,
                             "a format of PLY is ascii, binary_little_endian or binary_big_endian");
  }
  return tp_mesh_word_is(version, "1.0")
             ? TP_OK
             : tp_mesh_fail_word(source, version, "Topple reads PLY of version 1.0");
}

static bool has(const tp_ply_element *element, tp_ply_role role) {
  for (int k = 0; k < element->property_count; k++) {
    if (element->properties[k].role == role) return true;
  }
  return false;
}

/* Vertices with x, y and z, and after them faces with corners. */
static tp_status check(const tp_ply_header *header, const tp_mesh_source *source) {
  bool vertices = false, faces = false;
  for (int k = 0; k < header->element_count; k++) {
    const tp_ply_element *own = header->elements + k;
    if ((own->is_vertex && vertices) || (own->is_face && faces)) {
      return tp_mesh_fail_word(source, own->place, "this element is given twice");
    }
    vertices = vertices || own->is_vertex;
    faces = faces || own->is_face;
    if (own->is_vertex && !(has(own, TP_PLY_X) && has(own, TP_PLY_Y) && has(own, TP_PLY_Z))) {
      return tp_mesh_fail_word(source, own->place, "vertices have the properties x, y and z");
    }
    if (own->is_face && !has(own, TP_PLY_CORNERS)) {
      return tp_mesh_fail_word(source, own->place,
                               "faces have the property vertex_indices, a list");
    }
    if (own->is_face && !vertices) {
      return tp_mesh_fail_word(source, own->place, "faces stand below the vertices");
    }
  }
  return vertices && faces
             ? TP_OK
             : tp_mesh_fail_file(source, "a mesh has the elements vertex and face; make a mesh of "
                                         "points, and triangles of strips, first");
}

tp_status tp_ply_read_header(tp_ply_header *header, tp_mesh_source *source) {
  memset(header, 0, sizeof *header);
  tp_mesh_word word = tp_mesh_line_word(source);
  bool format = false;
  if (!tp_mesh_word_is(word, "ply")) {
    return tp_mesh_fail_word(source, word, "this is not a PLY: it does not begin with 'ply'");
  }
  tp_status status = TP_OK;
  while (status == TP_OK) {
    if (!tp_mesh_next_line(source)) {
      return tp_mesh_fail_line(source, "the file ends within its header");
    }
    word = tp_mesh_line_word(source);
    if (word.length == 0 || tp_mesh_word_is(word, "comment") || tp_mesh_word_is(word, "obj_info")) {
      continue;
    }
    if (tp_mesh_word_is(word, "end_header")) break;
    if (tp_mesh_word_is(word, "format")) {
      format = true;
      status = read_format(header, source);
    } else if (tp_mesh_word_is(word, "element")) {
      status = read_element(header, source);
    } else if (tp_mesh_word_is(word, "property")) {
      status = read_property(header, source);
    } else {
      status = tp_mesh_fail_word(source, word,
                                 "this is not a line of the header of a PLY: format, element, "
                                 "property, comment or end_header");
    }
  }
  if (status != TP_OK) return status;
  if (!format) return tp_mesh_fail_word(source, word, "the header gives no 'format'");
  if (!tp_mesh_next_line(source)) return tp_mesh_fail_line(source, "the file ends in its header");
  return check(header, source);
}
