/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A solid as a model of glTF 2.0 in one binary file (Khronos Group, glTF 2.0 Specification, 2021):
 * a head of JSON, and a buffer of floats and indices. Under one node, which turns the base to its
 * tilt, each shape is a mesh of its own. Lengths are metres from the foot of the centroid; glTF has
 * y upwards, so that a point east, north, up is (east, up, -north). */

#include "figure/solid.h"

#include "common/message.h"
#include "report/solid_page.h"

#include <float.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { LINES = 1, TRIANGLES = 4 }; /* how points are joined: two by two, or by indices */
enum { BUFFER_OF_POINTS = 34962, BUFFER_OF_INDICES = 34963 };
enum { FLOAT = 5126, UNSIGNED = 5125 };

/* Linear shares of red, green and blue, by ink. */
enum { ROCK, RED, BLUE, GREEN, PURPLE, BLACK };
static const char materials[] =
    "{\"name\":\"rock\",\"doubleSided\":true,\"pbrMetallicRoughness\":{\"baseColorFactor\":[0.5,0."
    "46,"
    "0.4,1],\"metallicFactor\":0,\"roughnessFactor\":1}},"
    "{\"name\":\"red\",\"pbrMetallicRoughness\":{\"baseColorFactor\":[0.66,0.11,0,1]}},"
    "{\"name\":\"blue\",\"pbrMetallicRoughness\":{\"baseColorFactor\":[0,0.17,0.45,1]}},"
    "{\"name\":\"green\",\"pbrMetallicRoughness\":{\"baseColorFactor\":[0,0.34,0.17,1]}},"
    "{\"name\":\"purple\",\"pbrMetallicRoughness\":{\"baseColorFactor\":[0.6,0.19,0.39,1]}},"
    "{\"name\":\"black\",\"pbrMetallicRoughness\":{\"baseColorFactor\":[0,0,0,1]}}";

static const double radian = 3.14159265358979323846 / 180;

typedef struct model {
  tp_text buffer;
  tp_text views, accessors, meshes, nodes; /* items of the head, with commas between */
  int accessor_count, node_count;
} model;

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

static const char *comma(const tp_text *t) {
  return t->length > 0 ? "," : "";
}

/* What has been put into the buffer from `start` on; the number of its accessor. */
static int add_accessor(model *m, size_t start, int target, int component, const char *type,
                        size_t count) {
  tp_text_add(&m->views, "%s{\"buffer\":0,\"byteOffset\":%zu,\"byteLength\":%zu,\"target\":%d}",
              comma(&m->views), start, m->buffer.length - start, target);
  tp_text_add(&m->accessors,
              "%s{\"bufferView\":%d,\"componentType\":%d,\"type\":\"%s\",\"count\":%zu",
              comma(&m->accessors), m->accessor_count, component, type, count);
  return m->accessor_count++;
}

static int add_points(model *m, const double *points, size_t count) {
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
  const int accessor = add_accessor(m, start, BUFFER_OF_POINTS, FLOAT, "VEC3", count);
  tp_text_add(&m->accessors, ",\"min\":[%.9g,%.9g,%.9g],\"max\":[%.9g,%.9g,%.9g]}", (double)low[0],
              (double)low[1], (double)low[2], (double)high[0], (double)high[1], (double)high[2]);
  return accessor;
}

/* A node with a mesh; a name of our own. */
static void add_shape(model *m, const char *name, int mode, int material, const double *points,
                      size_t count) {
  const int accessor = add_points(m, points, count);
  tp_text_add(&m->meshes,
              "%s{\"name\":\"%s\",\"primitives\":[{\"attributes\":{\"POSITION\":%d},\"mode\":%d,"
              "\"material\":%d",
              comma(&m->meshes), name, accessor, mode, material);
  tp_text_add(&m->nodes, ",{\"name\":\"%s\",\"mesh\":%d}", name, m->node_count++);
}

static void end_shape(model *m) {
  tp_text_add(&m->meshes, "}]}");
}

static void add_triangles(model *m, const int *corners, size_t count) {
  const size_t start = m->buffer.length;
  for (size_t k = 0; k < count; k++) put_word(&m->buffer, (uint32_t)corners[k]);
  const int accessor = add_accessor(m, start, BUFFER_OF_INDICES, UNSIGNED, "SCALAR", count);
  tp_text_add(&m->accessors, "}");
  tp_text_add(&m->meshes, ",\"indices\":%d", accessor);
}

static void add_line(model *m, const char *name, int material, const double from[3],
                     const double to[3]) {
  double ends[6];
  memcpy(ends, from, 3 * sizeof *ends);
  memcpy(ends + 3, to, 3 * sizeof *ends);
  add_shape(m, name, LINES, material, ends, 2);
  end_shape(m);
}

/* ---- what there is -----------------------------------------------------------------------------
 */

/* Side by side: loops of lines are known to fewer viewers. */
static bool add_support(model *m, const tp_solid_figure *f, const tp_solid_band *band) {
  const size_t count = 2 * band->corner_count;
  double *points = calloc(count, 3 * sizeof *points);
  char name[80];
  if (points == NULL) return false;
  for (size_t k = 0; k < count; k++) {
    const tp_solid_corner *own = band->support + (k + 1) / 2 % band->corner_count;
    points[3 * k] = own->east_m;
    points[3 * k + 1] = own->north_m;
  }
  snprintf(name, sizeof name, "support, %s %.6g %s", f->solid->has_below ? "section at" : "band",
           band->band, f->solid->length_unit);
  add_shape(m, name, LINES, band == f->band ? RED : BLUE, points, count);
  end_shape(m);
  free(points);
  return true;
}

static bool add_bands(model *m, const tp_solid_figure *f) {
  const double way = radian * f->azimuth_deg, reach = f->mesh.height * tan(f->tilt);
  const double centre[3] = {0, 0, f->mesh.height};
  tp_solid_corner ends[2];
  for (size_t k = 0; k < f->solid->band_count; k++) {
    if (f->solid->bands[k].corner_count < 3) continue;
    if (!add_support(m, f, f->solid->bands + k)) return false;
  }
  if (tp_solid_edge_met(ends, f)) {
    add_line(m, "edge that governs", RED, (double[]){ends[0].east_m, ends[0].north_m, 0},
             (double[]){ends[1].east_m, ends[1].north_m, 0});
  }
  add_line(m, "weight", BLACK, centre, (double[]){reach * sin(way), reach * cos(way), 0});
  return true;
}

static void add_contact(model *m, const tp_solid_figure *f, const tp_solid_contact *c, size_t n) {
  double at[3], way[3], end[3];
  char name[40];
  tp_solid_mesh_place(at, &f->mesh, f->solid, c->at);
  tp_solid_mesh_turn(way, &f->mesh, c->normal);
  tp_solid_go(end, at, 0.12 * f->mesh.size, way);
  snprintf(name, sizeof name, "normal %zu", n);
  add_line(m, name, BLUE, at, end);
  if (!tp_solid_is_held(&f->solid->contacts)) return;
  tp_solid_mesh_turn(way, &f->mesh, c->force);
  tp_solid_go(end, at, -tp_solid_force_scale(f), way);
  snprintf(name, sizeof name, "force %zu", n);
  add_line(m, name, GREEN, end, at);
}

static void add_contacts(model *m, const tp_solid_figure *f) {
  const tp_solid_contacts *c = &f->solid->contacts;
  const tp_solid_motion *motion = c->has_motion ? &c->motion : &c->critical;
  for (size_t k = 0; k < c->contact_count; k++) add_contact(m, f, c->contacts + k, k + 1);
  if (!c->has_motion && !c->has_critical) return;
  double at[3] = {0, 0, f->mesh.height}, axis[3], ends[2][3];
  tp_solid_mesh_turn(axis, &f->mesh, motion->axis);
  if (motion->turns) tp_solid_mesh_place(at, &f->mesh, f->solid, motion->at);
  tp_solid_go(ends[0], at, motion->turns ? -0.7 * f->mesh.size : 0, axis);
  tp_solid_go(ends[1], at, 0.7 * f->mesh.size, axis);
  add_line(m, motion->turns ? "axis" : "way", PURPLE, ends[0], ends[1]);
}

static bool fill(model *m, const tp_solid_figure *f) {
  const tp_solid_mesh *mesh = &f->mesh;
  add_shape(m, "rock", TRIANGLES, ROCK, mesh->points, (size_t)mesh->vertex_count);
  add_triangles(m, mesh->triangles, 3 * (size_t)mesh->triangle_count);
  end_shape(m);
  if (f->band != NULL) return add_bands(m, f);
  add_contacts(m, f);
  return true;
}

/* ---- the file ----------------------------------------------------------------------------------
 */

/* The base leans towards the azimuth: a turn about what is level in it. */
static void write_head(tp_text *t, const model *m, const tp_solid_figure *f) {
  const double way = radian * f->azimuth_deg, s = sin(f->tilt / 2);
  tp_text_add(t,
              "{\"asset\":{\"version\":\"2.0\",\"generator\":\"topple " TP_VERSION
              "\"},\"scene\":0,\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"name\":\"base\","
              "\"rotation\":[%.17g,0,%.17g,%.17g],\"children\":[",
              -s * cos(way), -s * sin(way), cos(f->tilt / 2));
  for (int k = 0; k < m->node_count; k++) tp_text_add(t, "%s%d", k > 0 ? "," : "", k + 1);
  tp_text_add(t,
              "]}%s],\"meshes\":[%s],\"materials\":[%s],\"accessors\":[%s],\"bufferViews\":[%s],"
              "\"buffers\":[{\"byteLength\":%zu}]}",
              m->nodes.data, m->meshes.data, materials, m->accessors.data, m->views.data,
              m->buffer.length);
  while (t->length % 4 != 0) tp_text_append(t, " ", 1);
}

static void write_file(tp_text *t, const model *m, const tp_text *head) {
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

static void clear(model *m) {
  tp_text *const texts[] = {&m->buffer, &m->views, &m->accessors, &m->meshes, &m->nodes};
  for (size_t k = 0; k < sizeof texts / sizeof texts[0]; k++) tp_text_drop(texts[k]);
}

static bool has_failed(const model *m) {
  return m->buffer.failed || m->views.failed || m->accessors.failed || m->meshes.failed ||
         m->nodes.failed;
}

tp_status tp_solid_gltf(char **bytes, size_t *length, const tp_solid_figure *f,
                        tp_message *message) {
  model m = {0};
  tp_text head = {0}, file = {0};
  bool done = fill(&m, f) && !has_failed(&m);
  if (done) write_head(&head, &m, f);
  done = done && !head.failed;
  tp_status status = TP_OK;
  if (done && m.buffer.length > UINT32_MAX - head.length - 4096) {
    status = tp_refuse(message, TP_FAULT_RANGE, (tp_place){f->solid->file, 0, 0},
                       "a .glb holds at most 4 GB, and this mesh takes more");
  } else if (done) {
    write_file(&file, &m, &head);
    done = !file.failed;
  }
  if (status == TP_OK && !done) status = tp_fail_memory(message, "the model");
  if (status == TP_OK) {
    *length = file.length;
    *bytes = file.data;
  } else {
    tp_text_drop(&file);
  }
  tp_text_drop(&head);
  clear(&m);
  return status;
}
