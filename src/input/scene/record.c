/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Reads an accelerogram by the ending of its file, shifts its time to zero, and checks that its
 * samples are evenly spaced. */

#include "scene/record.h"

#include "common/input_file.h"
#include "scene/record_at2.h"
#include "scene/record_csv.h"

#include <errno.h>
#include <string.h>
#include <strings.h>

/* ---- steps -------------------------------------------------------------------------------------
 */

/* Times that are printed with few digits stray from an even step by their rounding. */
static const double evenly = 0.25, gap = 1.5;

static double step_at(const tp_polyline *record, long k) {
  fmpq_t step;
  fmpq_init(step);
  fmpq_sub(step, record->x + k, record->x + k - 1);
  const double value = fmpq_get_d(step);
  fmpq_clear(step);
  return value;
}

tp_status tp_record_check(const tp_polyline *record, tp_place place, tp_message *message) {
  if (record->count < 2) {
    return tp_refuse(message, TP_FAULT_RANGE, place,
                     "an accelerogram needs two samples at least; this one has %ld", record->count);
  }
  const double first = step_at(record, 1);
  for (long k = 1; k < record->count; k++) {
    const double step = step_at(record, k), time = fmpq_get_d(record->x + k - 1);
    const tp_place at = tp_polyline_place(record, k);
    if (!(step > 0)) {
      return tp_refuse(message, TP_FAULT_FORMAT, at,
                       "time does not go on: a step of %.6g s after %.6g s", step, time);
    }
    if (step > gap * first) {
      return tp_refuse(message, TP_FAULT_FORMAT, at,
                       "a gap in the accelerogram: %.6g s without a sample after %.6g s, where its "
                       "first step is %.6g s; fill it, or cut the record there",
                       step, time, first);
    }
    if (step < (1 - evenly) * first || step > (1 + evenly) * first) {
      return tp_refuse(
          message, TP_FAULT_FORMAT, at,
          "an uneven step: %.6g s after %.6g s, where the first one is %.6g s; resample "
          "the accelerogram at even steps",
          step, time, first);
    }
  }
  return TP_OK;
}

/* ---- the file ----------------------------------------------------------------------------------
 */

void tp_record_begin_at_zero(tp_polyline *record) {
  fmpq_t first;
  fmpq_init(first);
  if (record->count > 0) fmpq_set(first, record->x);
  for (long k = 0; k < record->count && !fmpq_is_zero(first); k++) {
    fmpq_sub(record->x + k, record->x + k, first);
  }
  fmpq_clear(first);
}

static tp_status read_as(tp_polyline *record, tp_record_source *source, long column) {
  const char *ending = strrchr(source->path, '.');
  if (ending == NULL || strcasecmp(ending, ".at2") != 0) {
    return tp_record_read_csv(record, source, column > 0 ? column : 2);
  }
  if (column > 0) {
    return tp_refuse(source->message, TP_FAULT_KEY, (tp_place){source->path, 0, 0},
                     "an .at2 has no columns to choose from: drop 'column'");
  }
  return tp_record_read_at2(record, source);
}

tp_status tp_record_read(tp_polyline *record, const char *path, long column, tp_message *message) {
  tp_record_source source = {.path = path, .message = message};
  *record = (tp_polyline){.file = path};
  tp_status status = tp_input_open(&source.file, path, message);
  if (status != TP_OK) return status;
  status = read_as(record, &source, column);
  fclose(source.file);
  tp_record_begin_at_zero(record);
  if (status == TP_OK) status = tp_record_check(record, (tp_place){path, 0, 0}, message);
  if (status != TP_OK) tp_polyline_clear(record);
  return status;
}
