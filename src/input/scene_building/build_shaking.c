/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Calls that shake the base of a scene in memory by a pulse or by an accelerogram from a file. */

#include "common/host.h"
#include "scene/record.h"
#include "scene_building/build.h"

static tp_status begin(tp_build *build, tp_scene *scene, const char *call, tp_shaking_axis axis,
                       tp_message *message) {
  const tp_status status = tp_build_begin(build, scene, call, message);
  if (status != TP_OK || axis == TP_SHAKES_HORIZONTALLY || axis == TP_SHAKES_VERTICALLY) {
    return status;
  }
  return tp_refuse(message, TP_FAULT_ARGUMENT, build->place,
                   "'axis' must be one of tp_shaking_axis");
}

/* Nothing is left of what the axis had. */
static tp_shaking_component *renew(tp_build *build, tp_shaking_axis axis, tp_shaking_form form) {
  tp_shaking_component *own = build->scene->shaking + (axis == TP_SHAKES_VERTICALLY);
  build->scene->shaking_place = own->place = build->place;
  own->form = form;
  own->peak_g.given = own->frequency_hz.given = own->scale.given = own->column.given = false;
  tp_polyline_clear(&own->record);
  return own;
}

tp_status tp_scene_set_shaking_pulse(tp_scene *scene, tp_shaking_axis axis, tp_pulse_shape shape,
                                     tp_exact peak_g, tp_exact frequency_hz, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  const tp_given given[] = {{"peak_g", peak_g, TP_RULE_ANY},
                            {"frequency_hz", frequency_hz, TP_RULE_ABOVE_ZERO}};
  tp_build build;
  tp_status status = begin(&build, scene, __func__, axis, message);
  if (status == TP_OK && shape != TP_PULSE_HALF_SINE && shape != TP_PULSE_FULL_SINE) {
    status =
        tp_refuse(message, TP_FAULT_ARGUMENT, build.place, "'shape' must be one of tp_pulse_shape");
  }
  if (status != TP_OK) return status;
  status = tp_build_read(&build, given, 2);
  if (status == TP_OK) {
    tp_shaking_component *own = renew(
        &build, axis, shape == TP_PULSE_HALF_SINE ? TP_SHAKING_HALF_SINE : TP_SHAKING_FULL_SINE);
    tp_build_put(&build, &own->peak_g, 0);
    tp_build_put(&build, &own->frequency_hz, 1);
  }
  tp_build_end(&build);
  return status;
}

/* Time counts from the first sample. */
static tp_status read_record(tp_polyline *line, tp_coordinates record, const tp_build *build) {
  tp_status status =
      tp_coordinates_read(line, record, false, "record", build->place.file, 0, build->message);
  if (status == TP_OK) status = tp_record_check(line, build->place, build->message);
  if (status != TP_OK) {
    tp_polyline_clear(line);
    return status;
  }
  tp_record_begin_at_zero(line);
  return TP_OK;
}

tp_status tp_scene_set_shaking_record(tp_scene *scene, tp_shaking_axis axis, tp_coordinates record,
                                      tp_exact scale, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  const tp_given given[] = {{"scale", scale, TP_RULE_ANY}};
  tp_build build;
  tp_polyline line = {0};
  tp_status status = begin(&build, scene, __func__, axis, message);
  if (status != TP_OK) return status;
  status = tp_build_read(&build, given, 1);
  if (status == TP_OK) status = read_record(&line, record, &build);
  if (status == TP_OK) {
    tp_shaking_component *own = renew(&build, axis, TP_SHAKING_RECORD);
    own->record = line;
    tp_build_put(&build, &own->scale, 0);
  }
  tp_build_end(&build);
  return status;
}
