/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* An outline that someone clicked in the picture, in place of one that is looked for. */

#include "trace/trace.h"

#include "common/notes.h"
#include "scene_reading/csv.h"

#include <math.h>
#include <string.h>

enum { MOST_CLICKS = 200 };

static tp_status take_line(tp_trace_ring *ring, const tp_polyline *line, tp_message *message) {
  if (line->count < 3 || line->count > MOST_CLICKS) {
    return tp_refuse(message, TP_FAULT_RANGE, (tp_place){line->file, 0, 0},
                     "an outline that is clicked has from 3 to 200 points");
  }
  for (long k = 0; k < line->count; k++) {
    const tp_trace_point own = {fmpq_get_d(line->x + k), fmpq_get_d(line->y + k)};
    if (!tp_trace_ring_add(ring, own)) return tp_fail_memory(message, "an outline");
  }
  return TP_OK;
}

tp_status tp_trace_read_clicks(tp_trace_options *options, tp_message *message) {
  const char *unit = NULL, *path = options->outline_file;
  tp_polyline line;
  tp_notes notes = {0};
  if (path == NULL) return TP_OK;
  tp_status status = tp_csv_read(&line, &unit, path, true, &notes, message);
  if (status == TP_OK && unit != NULL && strcmp(unit, "px") != 0) {
    status = tp_refuse(message, TP_FAULT_UNIT, (tp_place){path, 1, 1},
                       "the header says that lengths are in %s; points of a picture are in pixels "
                       "from its upper left corner",
                       unit);
  }
  if (status == TP_OK) status = take_line(&options->outline, &line, message);
  tp_polyline_clear(&line);
  tp_notes_clear(&notes);
  return status;
}

tp_status tp_trace_take_clicks(tp_trace *trace, const tp_trace_options *options,
                               tp_message *message) {
  const tp_trace_ring *given = &options->outline;
  const bool turned = tp_trace_ring_area(given) < 0;
  for (long k = 0; k < given->count; k++) {
    if (!tp_trace_ring_add(&trace->ring, given->points[turned ? given->count - 1 - k : k])) {
      return tp_fail_memory(message, "an outline");
    }
  }
  trace->deviation_px = sqrt(1.0 / 12);
  return TP_OK;
}
