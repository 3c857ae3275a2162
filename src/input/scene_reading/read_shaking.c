/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The key shaking of a scene: the accelerations of its base, horizontal and vertical. */

#include "format/csv_row.h"
#include "scene/record.h"
#include "scene_reading/read.h"

static tp_status read_pulse(const tp_reader *reader, tp_shaking_component *own, const tp_node *node,
                            const char *name) {
  const tp_node *peak = NULL, *frequency = NULL;
  tp_status status = tp_read_keys(reader, node, &tp_key_map_shaking_horizontal_half_sine, name);
  if (status == TP_OK) status = tp_read_required(reader, &peak, node, "peak_g", "peak_g: 0.4");
  if (status == TP_OK) {
    status = tp_read_required(reader, &frequency, node, "frequency_hz", "frequency_hz: 2");
  }
  if (status == TP_OK) {
    status = tp_read_quantity(reader, &own->peak_g, peak, "peak_g", TP_RULE_ANY);
  }
  if (status == TP_OK) {
    status =
        tp_read_quantity(reader, &own->frequency_hz, frequency, "frequency_hz", TP_RULE_ABOVE_ZERO);
  }
  return status;
}

/* The column of a CSV file; 0: not given. */
static tp_status read_column(const tp_reader *reader, tp_shaking_component *own, long *column,
                             const tp_node *node) {
  *column = 0;
  const tp_status status =
      tp_read_quantity(reader, &own->column, node, "column", TP_RULE_ABOVE_ZERO);
  if (status != TP_OK || node == NULL) return status;
  const fmpq *value = own->column.value;
  if (!fmpz_is_one(fmpq_denref(value)) || fmpq_cmp_ui(value, 2) < 0 ||
      fmpq_cmp_ui(value, TP_CSV_FIELDS) > 0) {
    return tp_read_fail(reader, TP_FAULT_RANGE, node,
                        "columns are counted from 1; the first is the time, so one of 2 to %d",
                        TP_CSV_FIELDS);
  }
  *column = fmpz_get_si(fmpq_numref(value));
  return TP_OK;
}

/* The file, once for all scenes with other numbers. */
static tp_status read_file(const tp_reader *reader, tp_shaking_component *own, const tp_node *file,
                           long column) {
  const tp_polyline *kept = tp_read_kept(reader, file);
  if (kept != NULL && !reader->reading->varies) { /* the column is the same */
    own->record = tp_polyline_share(kept);
    return TP_OK;
  }
  if (file->kind != TP_NODE_SCALAR) {
    return tp_read_fail(reader, TP_FAULT_KEY, file,
                        "file must be the name of a file: record.at2, or a .csv");
  }
  const char *path = tp_scene_file_name(reader->scene->file, file->text);
  if (path == NULL) return tp_fail_memory(reader->message, "an accelerogram");
  const tp_status status = tp_record_read(&own->record, path, column, reader->message);
  if (status != TP_OK) return status;
  return tp_polyline_make_shared(&own->record) && tp_read_keep(reader, &own->record, file)
             ? TP_OK
             : tp_fail_memory(reader->message, "an accelerogram");
}

static tp_status read_record(const tp_reader *reader, tp_shaking_component *own,
                             const tp_node *node) {
  const tp_node *file = NULL;
  long column = 0;
  tp_status status = tp_read_keys(reader, node, &tp_key_map_shaking_horizontal_record, "record");
  if (status == TP_OK) {
    status = tp_read_required(reader, &file, node, "file", "file: record.at2");
  }
  if (status == TP_OK) {
    status =
        tp_read_quantity(reader, &own->scale, tp_node_get(node, "scale"), "scale", TP_RULE_ANY);
  }
  reader->reading->varies = false;
  if (status == TP_OK) {
    status = read_column(reader, own, &column, tp_node_get(node, "column"));
  }
  return status == TP_OK ? read_file(reader, own, file, column) : status;
}

static tp_status read_component(const tp_reader *reader, tp_shaking_component *own,
                                const tp_node *node, const char *name) {
  if (node == NULL) return TP_OK;
  own->place = tp_node_place(node, reader->scene->path);
  const tp_status status = tp_read_keys(reader, node, &tp_key_map_shaking_horizontal, name);
  if (status != TP_OK) return status;
  if (node->count != 1) {
    return tp_read_fail(reader, TP_FAULT_KEY, node,
                        "%s is one of half_sine, full_sine and record, for example '%s: "
                        "{half_sine: {peak_g: 0.4, frequency_hz: 2}}'",
                        name, name);
  }
  const tp_node *half = tp_node_get(node, "half_sine"), *full = tp_node_get(node, "full_sine");
  own->form = half != NULL   ? TP_SHAKING_HALF_SINE
              : full != NULL ? TP_SHAKING_FULL_SINE
                             : TP_SHAKING_RECORD;
  if (own->form == TP_SHAKING_RECORD) return read_record(reader, own, node->first);
  return read_pulse(reader, own, node->first, half != NULL ? "half_sine" : "full_sine");
}

tp_status tp_read_shaking(const tp_reader *reader, const tp_node *node) {
  tp_scene *scene = reader->scene;
  if (node == NULL) return TP_OK;
  scene->shaking_place = tp_node_place(node, scene->path);
  tp_status status = tp_read_keys(reader, node, &tp_key_map_shaking, "shaking");
  if (status == TP_OK && node->count == 0) {
    status = tp_read_fail(reader, TP_FAULT_KEY, node, "shaking needs 'horizontal' or 'vertical'");
  }
  for (int axis = 0; axis < TP_SHAKING_AXES && status == TP_OK; axis++) {
    const char *key = tp_key_map_shaking.keys[axis];
    status = read_component(reader, scene->shaking + axis, tp_node_get(node, key), key);
  }
  return status;
}
