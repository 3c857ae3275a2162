/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Puts shapes into the buffer as they come, and writes the head of JSON from the list of them. */

#include "figure/gltf.h"

#include "common/grow.h"
#include "common/message.h"
#include "output/json.h"

#include <float.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { LINES = 1, TRIANGLES = 4 }; /* how points are joined: two by two, or by indices */
enum { BUFFER_OF_POINTS = 34962, BUFFER_OF_INDICES = 34963 };
enum { FLOAT = 5126, UNSIGNED = 5125 };

/* Linear shares of red, green and blue. */
typedef struct coloured_material {
  const char *name;
  double ink[3];
} coloured_material;

static const coloured_material materials[TP_GLTF_MATERIALS] = {
    [TP_GLTF_ROCK] = {"rock", {0.5, 0.46, 0.4}},  [TP_GLTF_GROUND] = {"ground", {0.72, 0.58, 0.36}},
    [TP_GLTF_RED] = {"red", {0.66, 0.11, 0}},     [TP_GLTF_BLUE] = {"blue", {0, 0.17, 0.45}},
    [TP_GLTF_GREEN] = {"green", {0, 0.34, 0.17}}, [TP_GLTF_PURPLE] = {"purple", {0.6, 0.19, 0.39}},
    [TP_GLTF_BLACK] = {"black", {0, 0, 0}}};

/* ---- the buffer --------------------------------------------------------------------------------
 */

static void put_word(tp_text *t, uint32_t word) {
  char bytes[4];
  for (int k = 0; k < 4; k++) bytes[k] = (char)(unsigned char)(word >> 8 * k & 0xff);
  tp_text_append(t, bytes, sizeof bytes);
}

static void put_float(tp_text *t, float value) {
  uint32_t word = 0;
  memcpy(&word, &value, sizeof word);
  put_word(t, word);
}

/* What has been put into the buffer from `start` on; NULL when memory is exhausted. */
static tp_gltf_accessor *add_accessor(tp_gltf *m, size_t start, size_t count) {
  tp_gltf_accessor *more =
      tp_grow(m->accessors, m->accessor_count, &m->accessor_room, sizeof *more);
  m->failed = m->failed || more == NULL;
  if (more == NULL) return NULL;
  m->accessors = more;
  more += m->accessor_count++;
  *more = (tp_gltf_accessor){.start = start, .length = m->buffer.length - start, .count = count};
  return more;
}

static void add_points(tp_gltf *m, const double *points, size_t count) {
  static const int from[3] = {0, 2, 1};
  float low[3] = {FLT_MAX, FLT_MAX, FLT_MAX}, high[3] = {-FLT_MAX, -FLT_MAX, -FLT_MAX};
  const size_t start = m->buffer.length;
  for (size_t n = 0; n < count; n++) {
    for (int k = 0; k < 3; k++) {
      const float own = (float)(k == 2 ? -points[3 * n + 1] : points[3 * n + (size_t)from[k]]);
      low[k] = fminf(low[k], own);
      high[k] = fmaxf(high[k], own);
      put_float(&m->buffer, own);
    }
  }
  tp_gltf_accessor *own = add_accessor(m, start, count);
  if (own == NULL) return;
  own->of_points = true;
  memcpy(own->low, low, sizeof low);
  memcpy(own->high, high, sizeof high);
}

/* NULL when memory is exhausted. */
static tp_gltf_shape *add_shape(tp_gltf *m, const char *name, tp_gltf_material material,
                                const double *points, size_t count) {
  add_points(m, points, count);
  tp_gltf_shape *more = tp_grow(m->shapes, m->shape_count, &m->shape_room, sizeof *more);
  m->failed = m->failed || more == NULL;
  if (more == NULL) return NULL;
  m->shapes = more;
  more += m->shape_count++;
  *more = (tp_gltf_shape){.material = material, .points = m->accessor_count - 1, .indices = -1};
  snprintf(more->name, sizeof more->name, "%s", name);
  return more;
}

void tp_gltf_add_lines(tp_gltf *m, const char *name, tp_gltf_material material,
                       const double *points, size_t count) {
  (void)add_shape(m, name, material, points, count);
}

void tp_gltf_add_line(tp_gltf *m, const char *name, tp_gltf_material material, const double from[3],
                      const double to[3]) {
  double ends[6];
  memcpy(ends, from, 3 * sizeof *ends);
  memcpy(ends + 3, to, 3 * sizeof *ends);
  (void)add_shape(m, name, material, ends, 2);
}

void tp_gltf_add_triangles(tp_gltf *m, const char *name, tp_gltf_material material,
                           const double *points, size_t count, const int *corners,
                           size_t corner_count) {
  tp_gltf_shape *own = add_shape(m, name, material, points, count);
  const size_t start = m->buffer.length;
  for (size_t k = 0; k < corner_count; k++) put_word(&m->buffer, (uint32_t)corners[k]);
  if (add_accessor(m, start, corner_count) != NULL && own != NULL)
    own->indices = m->accessor_count - 1;
}

/* ---- the file ----------------------------------------------------------------------------------
 */

static void write_numbers(tp_json *j, const char *key, const double *numbers, int count) {
  tp_json_array(j, key, TP_JSON_LINE);
  for (int k = 0; k < count; k++) tp_json_double(j, NULL, numbers[k]);
  tp_json_close(j);
}

static void write_floats(tp_json *j, const char *key, const float numbers[3]) {
  write_numbers(j, key, (double[]){numbers[0], numbers[1], numbers[2]}, 3);
}

/* The base leans towards the azimuth: a turn about what is level in it. */
static void write_nodes(tp_json *j, const tp_gltf *m, double lean, double azimuth) {
  const double s = sin(lean / 2);
  tp_json_array(j, "nodes", TP_JSON_LIST);
  tp_json_object(j, NULL, TP_JSON_LINE);
  tp_json_string(j, "name", "base");
  write_numbers(j, "rotation", (double[]){-s * cos(azimuth), 0, -s * sin(azimuth), cos(lean / 2)},
                4);
  tp_json_array(j, "children", TP_JSON_LINE);
  for (long k = 0; k < m->shape_count; k++) tp_json_integer(j, NULL, k + 1);
  tp_json_close(j);
  tp_json_object(j, "extras", TP_JSON_LINE);
  tp_json_double(j, "centroid_height_m", m->centroid_height);
  tp_json_close(j);
  tp_json_close(j);
  for (long k = 0; k < m->shape_count; k++) {
    tp_json_object(j, NULL, TP_JSON_LINE);
    tp_json_string(j, "name", m->shapes[k].name);
    tp_json_integer(j, "mesh", k);
    tp_json_close(j);
  }
  tp_json_close(j);
}

static void write_shape(tp_json *j, const tp_gltf_shape *own) {
  tp_json_object(j, NULL, TP_JSON_LINE);
  tp_json_string(j, "name", own->name);
  tp_json_array(j, "primitives", TP_JSON_LINE);
  tp_json_object(j, NULL, TP_JSON_LINE);
  tp_json_object(j, "attributes", TP_JSON_LINE);
  tp_json_integer(j, "POSITION", own->points);
  tp_json_close(j);
  tp_json_integer(j, "mode", own->indices >= 0 ? TRIANGLES : LINES);
  tp_json_integer(j, "material", own->material);
  if (own->indices >= 0) tp_json_integer(j, "indices", own->indices);
  tp_json_close(j);
  tp_json_close(j);
  tp_json_close(j);
}

static void write_material(tp_json *j, const coloured_material *own) {
  const bool is_surface = own == materials + TP_GLTF_ROCK || own == materials + TP_GLTF_GROUND;
  tp_json_object(j, NULL, TP_JSON_LINE);
  tp_json_string(j, "name", own->name);
  if (is_surface) tp_json_truth(j, "doubleSided", true);
  tp_json_object(j, "pbrMetallicRoughness", TP_JSON_LINE);
  write_numbers(j, "baseColorFactor", (double[]){own->ink[0], own->ink[1], own->ink[2], 1}, 4);
  if (is_surface) tp_json_integer(j, "metallicFactor", 0);
  tp_json_close(j);
  tp_json_close(j);
}

static void write_accessor(tp_json *j, const tp_gltf_accessor *own, long number) {
  tp_json_object(j, NULL, TP_JSON_LINE);
  tp_json_integer(j, "bufferView", number);
  tp_json_integer(j, "componentType", own->of_points ? FLOAT : UNSIGNED);
  tp_json_string(j, "type", own->of_points ? "VEC3" : "SCALAR");
  tp_json_count(j, "count", own->count);
  if (own->of_points) {
    write_floats(j, "min", own->low);
    write_floats(j, "max", own->high);
  }
  tp_json_close(j);
}

static void write_view(tp_json *j, const tp_gltf_accessor *own) {
  tp_json_object(j, NULL, TP_JSON_LINE);
  tp_json_integer(j, "buffer", 0);
  tp_json_count(j, "byteOffset", own->start);
  tp_json_count(j, "byteLength", own->length);
  tp_json_integer(j, "target", own->of_points ? BUFFER_OF_POINTS : BUFFER_OF_INDICES);
  tp_json_close(j);
}

static void write_scene(tp_json *j) {
  tp_json_object(j, "asset", TP_JSON_LINE);
  tp_json_string(j, "version", "2.0");
  tp_json_string(j, "generator", "topple " TP_VERSION);
  tp_json_close(j);
  tp_json_integer(j, "scene", 0);
  tp_json_array(j, "scenes", TP_JSON_LINE);
  tp_json_object(j, NULL, TP_JSON_LINE);
  tp_json_array(j, "nodes", TP_JSON_LINE);
  tp_json_integer(j, NULL, 0);
  for (int k = 0; k < 3; k++) tp_json_close(j);
}

static void write_head(tp_json *j, const tp_gltf *m, double lean, double azimuth) {
  tp_json_object(j, NULL, TP_JSON_BLOCK);
  write_scene(j);
  write_nodes(j, m, lean, azimuth);
  tp_json_array(j, "meshes", TP_JSON_LIST);
  for (long k = 0; k < m->shape_count; k++) write_shape(j, m->shapes + k);
  tp_json_close(j);
  tp_json_array(j, "materials", TP_JSON_LIST);
  for (int k = 0; k < TP_GLTF_MATERIALS; k++) write_material(j, materials + k);
  tp_json_close(j);
  tp_json_array(j, "accessors", TP_JSON_LIST);
  for (long k = 0; k < m->accessor_count; k++) write_accessor(j, m->accessors + k, k);
  tp_json_close(j);
  tp_json_array(j, "bufferViews", TP_JSON_LIST);
  for (long k = 0; k < m->accessor_count; k++) write_view(j, m->accessors + k);
  tp_json_close(j);
  tp_json_array(j, "buffers", TP_JSON_LINE);
  tp_json_object(j, NULL, TP_JSON_LINE);
  tp_json_count(j, "byteLength", m->buffer.length);
  tp_json_close(j);
  tp_json_close(j);
  tp_json_close(j);
}

static void write_file(tp_text *t, const tp_gltf *m, const tp_text *head) {
  enum { MAGIC = 0x46546C67, JSON = 0x4E4F534A, BINARY = 0x004E4942, VERSION = 2, WORDS = 7 };
  put_word(t, MAGIC);
  put_word(t, VERSION);
  put_word(t, (uint32_t)(4 * WORDS + head->length + m->buffer.length));
  put_word(t, (uint32_t)head->length);
  put_word(t, JSON);
  tp_text_append(t, head->data, head->length);
  put_word(t, (uint32_t)m->buffer.length);
  put_word(t, BINARY);
  tp_text_append(t, m->buffer.data, m->buffer.length);
}

void tp_gltf_clear(tp_gltf *m) {
  tp_text_drop(&m->buffer);
  free(m->accessors);
  free(m->shapes);
  memset(m, 0, sizeof *m);
}

tp_status tp_gltf_write(char **bytes, size_t *length, const tp_gltf *m, double lean, double azimuth,
                        const char *source, tp_message *message) {
  static const size_t most_of_head = 1 << 20;
  if (m->failed || m->buffer.failed) return tp_fail_memory(message, "the model");
  if (m->buffer.length > UINT32_MAX - most_of_head) {
    return tp_refuse(message, TP_FAULT_RANGE, (tp_place){source, 0, 0},
                     "a .glb holds at most 4 GB, and this mesh takes more");
  }
  tp_json head = {0};
  tp_text file = {0};
  write_head(&head, m, lean, azimuth);
  while (head.text.length % 4 != 0) tp_text_append(&head.text, " ", 1);
  write_file(&file, m, &head.text);
  const bool done = !head.text.failed && !file.failed;
  tp_text_drop(&head.text);
  if (!done) {
    tp_text_drop(&file);
    return tp_fail_memory(message, "the model");
  }
  *length = file.length;
  *bytes = file.data;
  return TP_OK;
}
