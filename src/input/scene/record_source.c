/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Next line, a number at a place of it, and a sample appended, each with the message that names
 * line and column. */

#include "scene/record_source.h"

#include "number/ratio.h"

#include <errno.h>
#include <string.h>

tp_status tp_record_fail(const tp_record_source *source, size_t column, const char *what) {
  return tp_refuse(source->message, TP_FAULT_FORMAT,
                   (tp_place){source->path, source->number, (int)column + 1}, "%s", what);
}

tp_status tp_record_next(tp_record_source *source, bool *more) {
  *more = fgets(source->line, sizeof source->line, source->file) != NULL;
  if (!*more) {
    return ferror(source->file) == 0 ? TP_OK
                                     : tp_fail_file(source->message, source->path, "read", errno);
  }
  source->number++;
  source->length = strlen(source->line);
  if (source->length + 1 == sizeof source->line && source->line[source->length - 1] != '\n') {
    return tp_record_fail(source, 0,
                          "a line longer than 8191 bytes; is this an accelerogram, in CSV or as "
                          "PEER's .at2?");
  }
  while (source->length > 0 && strchr("\r\n", source->line[source->length - 1]) != NULL) {
    source->line[--source->length] = '\0';
  }
  return TP_OK;
}

tp_status tp_record_value(fmpq_t value, const tp_record_source *source, size_t at, size_t length) {
  const char *problem = NULL;
  if (tp_ratio_read_field(value, source->line + at, length, &problem)) return TP_OK;
  char word[16] = "", what[160];
  strncat(word, source->line + at, length < 15 ? length : 15);
  if (tp_ratio_is_not_finite(word)) {
    snprintf(what, sizeof what, "'%s' is not a finite number", word);
  } else {
    snprintf(what, sizeof what,
             "this entry %s; an accelerogram holds numbers alone below "
             "its header",
             problem);
  }
  return tp_record_fail(source, at, what);
}

tp_status tp_record_append(tp_polyline *record, const tp_record_source *source, const fmpq_t time,
                           const fmpq_t acceleration, size_t at) {
  const tp_mark mark = {source->number, (int)at + 1};
  if (record->count == TP_RECORD_MOST) {
    return tp_record_fail(source, at, "more than 10 million samples");
  }
  return tp_polyline_append(record, time, acceleration, mark)
             ? TP_OK
             : tp_fail_memory(source->message, "an accelerogram");
}
