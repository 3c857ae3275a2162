/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A chart as a file. */

#define _GNU_SOURCE
#include "host.h"
#include "message.h"
#include "report/chart_script.h"
#include "report/gnuplot.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <unistd.h>

bool tp_chart_format_read(tp_chart_format *format, const char *path) {
  if (format == NULL || path == NULL) return false;
  static const char *const endings[] = {".svg", ".pdf", ".png", ".csv"};
  const char *ending = strrchr(path, '.');
  const bool ends = ending != NULL && ending != path && ending[-1] != '/'; /* .svg is a name */
  for (int k = 0; ends && k < 4; k++) {
    if (strcasecmp(ending, endings[k]) != 0) continue;
    *format = (tp_chart_format)k;
    return true;
  }
  return false;
}

static tp_status fail(const tp_file *file, tp_message *message) {
  return tp_fail(message, TP_SYSTEM_FAILED, (tp_place){file->path, 0, 0}, "cannot be written: %s",
                 strerror(errno));
}

/* Write over the file from an offset. */
static tp_status rewrite(const tp_file *file, size_t offset, const char *text, size_t length,
                         tp_message *message) {
  if (lseek(file->descriptor, (off_t)offset, SEEK_SET) < 0) return fail(file, message);
  return tp_file_write(file, text, length, message);
}

/* Cairo writes when a PDF was made, which the standard leaves optional: blanks instead, so that the
 * same chart is the same file and no offset in it moves. */
static tp_status drop_date(const tp_file *file, char *data, size_t size, tp_message *message) {
  static const char key[] = "/CreationDate (";
  char *date = memmem(data, size, key, strlen(key));
  const char *end = date != NULL ? memchr(date, ')', (size_t)(data + size - date)) : NULL;
  if (end == NULL) return TP_OK;
  memset(date, ' ', (size_t)(end + 1 - date));
  const size_t offset = (size_t)(date - data);
  return rewrite(file, offset, date, (size_t)(end + 1 - date), message);
}

/* Or blanks beside markup would be dropped by some programs. */
static tp_status keep_blanks(const tp_file *file, const char *data, size_t size,
                             tp_message *message) {
  static const char key[] = "<svg ", added[] = "xml:space=\"preserve\" ";
  const char *root = memmem(data, size, key, strlen(key));
  if (root == NULL) return TP_OK;
  const size_t offset = (size_t)(root - data) + strlen(key);
  const tp_status status = rewrite(file, offset, added, strlen(added), message);
  return status == TP_OK ? tp_file_write(file, data + offset, size - offset, message) : status;
}

static tp_status finish(const tp_file *file, tp_chart_format format, tp_message *message) {
  const off_t size = lseek(file->descriptor, 0, SEEK_END);
  if (size < 0) return fail(file, message);
  char *data = malloc((size_t)size + 1);
  if (data == NULL) return tp_fail_memory(message, "the figure");
  tp_status status = TP_OK;
  if (pread(file->descriptor, data, (size_t)size, 0) != size) {
    status = fail(file, message);
  } else if (format == TP_CHART_PDF) {
    status = drop_date(file, data, (size_t)size, message);
  } else if (format == TP_CHART_SVG) {
    status = keep_blanks(file, data, (size_t)size, message);
  }
  free(data);
  return status;
}

tp_status tp_report_chart_file(const tp_chart *chart, const char *path, tp_chart_format format,
                               tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, chart);
  TP_REFUSE_NULL(message, path);
  if ((int)format < TP_CHART_SVG || (int)format > TP_CHART_CSV) {
    return tp_fail(message, TP_BAD_INPUT, (tp_place){path, 0, 0}, "there is no such format");
  }
  char *text = NULL;
  tp_file file;
  tp_status status = format == TP_CHART_CSV ? tp_report_chart_csv(&text, chart)
                                            : tp_chart_script(&text, chart, format);
  if (status != TP_OK) return tp_fail_memory(message, "the chart");
  status = tp_file_open(&file, path, message);
  if (status == TP_OK) {
    status = format == TP_CHART_CSV ? tp_file_write(&file, text, strlen(text), message)
                                    : tp_gnuplot_run(&file, text, message);
    if (status == TP_OK && format != TP_CHART_CSV) status = finish(&file, format, message);
    status = tp_file_close(&file, status, message);
  }
  free(text);
  return status;
}
