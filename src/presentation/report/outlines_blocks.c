/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Where all blocks of a solved scene lie, for programs that draw them: outlines as path data of SVG
 * (y up), and loads, in the axes of the scene. Plain doubles in metres from an origin, for drawing
 * alone. */

#include "common/host.h"
#include "common/message.h"
#include "report/path_json.h"
#include "report/results.h"
#include "shape/load_shapes.h"

#include <math.h>

/* What is drawn of a system. */
typedef struct drawn {
  const tp_scene *scene;
  const tp_block_system *system;
  tp_block_shapes shapes;
} drawn;

static void add_outlines(tp_json *j, const tp_block_shapes *s) {
  tp_json_array(j, "blocks", TP_JSON_LIST);
  for (size_t k = 0; k < s->count; k++) tp_json_path(j, NULL, &s->blocks[k].outline, s->unit_m);
  tp_json_close(j);
  tp_json_array(j, "parts", TP_JSON_LIST);
  for (size_t k = 0; k < s->count; k++) {
    if (s->blocks[k].parts.count > 0) tp_json_path(j, NULL, &s->blocks[k].parts, s->unit_m);
  }
  tp_json_close(j);
}

static void add_line(tp_json *j, const tp_load_shape *load, double unit_m) {
  tp_json_object(j, NULL, TP_JSON_LINE);
  tp_json_double(j, "x0_m", load->at.x * unit_m);
  tp_json_double(j, "y0_m", load->at.y * unit_m);
  tp_json_double(j, "x1_m", load->to.x * unit_m);
  tp_json_double(j, "y1_m", load->to.y * unit_m);
  tp_json_double(j, "first_kpa", load->first);
  tp_json_double(j, "last_kpa", load->kind == TP_LOAD_WEIGHS ? load->first : load->last);
  tp_json_close(j);
}

static void add_pull(tp_json *j, const tp_load_shape *load, double unit_m) {
  static const double degrees = 57.295779513082323;
  tp_json_object(j, NULL, TP_JSON_LINE);
  tp_json_double(j, "x_m", load->at.x * unit_m);
  tp_json_double(j, "y_m", load->at.y * unit_m);
  tp_json_double(j, "direction_deg", atan2(load->along.y, load->along.x) * degrees);
  tp_json_close(j);
}

/* Those of one kind. */
static void add_loads(tp_json *j, const char *key, const tp_load_shapes *loads,
                      tp_load_shape_kind kind, double unit_m) {
  tp_json_array(j, key, TP_JSON_LIST);
  for (size_t k = 0; k < loads->count; k++) {
    const tp_load_shape *load = loads->items + k;
    if (load->kind != kind) continue;
    (kind == TP_LOAD_PULLS || kind == TP_LOAD_PUSHES ? add_pull : add_line)(j, load, unit_m);
  }
  tp_json_close(j);
}

/* Loads are the same in each case; the level of water is not, as all turns about it. */
static tp_status add_all_loads(tp_json *j, const drawn *d, tp_message *message) {
  const double unit_m = d->shapes.unit_m;
  tp_load_shapes loads;
  tp_status status = TP_OK;
  for (size_t k = 0; k < d->system->case_count && status == TP_OK; k++) {
    const bool left = d->system->cases[k].towards == TP_TOWARDS_LEFT;
    status = tp_load_shapes_init(&loads, &d->shapes, d->scene, left, message);
    if (status != TP_OK) return status;
    if (k == 0) {
      add_loads(j, "pressures", &loads, TP_LOAD_PRESSES, unit_m);
      add_loads(j, "surcharges", &loads, TP_LOAD_WEIGHS, unit_m);
      add_loads(j, "anchors", &loads, TP_LOAD_PULLS, unit_m);
      add_loads(j, "forces", &loads, TP_LOAD_PUSHES, unit_m);
      tp_json_array(j, "water", TP_JSON_LIST);
    }
    tp_json_path(j, NULL, &loads.water, unit_m);
    tp_load_shapes_clear(&loads);
  }
  tp_json_close(j);
  return TP_OK;
}

/* Points of the scene, in its lengths, and of the results: both are shifted alone. */
static void add_placed(tp_json *j, const drawn *d) {
  static const char *const keys[] = {"block", "results"};
  tp_json_object(j, "placed", TP_JSON_BLOCK);
  tp_json_double(j, "metres_per_unit", d->system->metres_per_unit);
  for (size_t k = 0; k < sizeof keys / sizeof keys[0]; k++) {
    tp_json_object(j, keys[k], TP_JSON_LINE);
    tp_json_double(j, "cosine", 1);
    tp_json_double(j, "sine", 0);
    tp_json_double(j, "x_m", -d->shapes.origin_m.x);
    tp_json_double(j, "y_m", -d->shapes.origin_m.y);
    tp_json_close(j);
  }
  tp_json_null(j, "base");
  tp_json_close(j);
}

static tp_status write_all(tp_json *j, const drawn *d, tp_message *message) {
  const tp_block_shapes *s = &d->shapes;
  tp_json_subject x = {.system = d->system};
  tp_json_report(j);
  tp_json_members_of_block_system(j, d->system, &x);
  tp_json_object(j, "outlines", TP_JSON_BLOCK);
  tp_json_double(j, "origin_x_m", s->origin_m.x);
  tp_json_double(j, "origin_y_m", s->origin_m.y);
  tp_json_array(j, "box_m", TP_JSON_LINE);
  tp_json_double(j, NULL, s->box.x0 * s->unit_m);
  tp_json_double(j, NULL, s->box.y0 * s->unit_m);
  tp_json_double(j, NULL, s->box.x1 * s->unit_m);
  tp_json_double(j, NULL, s->box.y1 * s->unit_m);
  tp_json_close(j);
  add_outlines(j, s);
  add_placed(j, d);
  const tp_status status = add_all_loads(j, d, message);
  tp_json_close(j);
  tp_json_close(j);
  return status;
}

tp_status tp_report_block_system_json_outlines(char **text, const tp_scene *scene,
                                               const tp_block_system *system, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, text);
  TP_REFUSE_NULL(message, scene);
  TP_REFUSE_NULL(message, system);
  drawn d = {.scene = scene, .system = system};
  tp_status status = tp_block_shapes_init(&d.shapes, scene, system, message);
  if (status != TP_OK) return status;
  tp_json j = {0};
  status = write_all(&j, &d, message);
  tp_block_shapes_clear(&d.shapes);
  if (status != TP_OK) {
    tp_text_drop(&j.text);
    return status;
  }
  status = tp_json_finish(&j, text);
  return status == TP_OUT_OF_MEMORY ? tp_fail_memory(message, "the report") : status;
}
