/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A chart as a file. */

#define _GNU_SOURCE
#include "message.h"
#include "report/chart_script.h"
#include "report/gnuplot.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

bool tp_chart_format_read(tp_chart_format *format, const char *path) {
  static const char *const endings[] = {".svg", ".pdf", ".png", ".csv"};
  const char *ending = strrchr(path, '.');
  for (int k = 0; ending != NULL && k < 4; k++) {
    if (strcmp(ending, endings[k]) != 0) continue;
    *format = (tp_chart_format)k;
    return true;
  }
  return false;
}

/* Cairo writes when a PDF was made, which the standard leaves optional: blanks instead, so that the
 * same chart is the same file and no offset in it moves. */
static tp_status drop_date(const tp_file *file, tp_message *message) {
  static const char key[] = "/CreationDate (";
  const off_t size = lseek(file->descriptor, 0, SEEK_END);
  char *data = size > 0 ? malloc((size_t)size) : NULL;
  if (data == NULL) return tp_fail_memory(message, "the figure");
  ssize_t got = pread(file->descriptor, data, (size_t)size, 0);
  char *date = got == size ? memmem(data, (size_t)size, key, strlen(key)) : NULL;
  const char *end = date != NULL ? memchr(date, ')', (size_t)(data + size - date)) : NULL;
  if (end != NULL) {
    const size_t length = (size_t)(end + 1 - date);
    memset(date, ' ', length);
    got = pwrite(file->descriptor, date, length, date - data) == (ssize_t)length ? size : -1;
  }
  free(data);
  if (got == size) return TP_OK;
  return tp_fail(message, TP_SYSTEM_FAILED, (tp_place){file->path, 0, 0}, "cannot be written: %s",
                 strerror(errno));
}

tp_status tp_report_chart_file(const tp_chart *chart, const char *path, tp_chart_format format,
                               tp_message *message) {
  char *text = NULL;
  tp_file file;
  tp_status status = format == TP_CHART_CSV ? tp_report_chart_csv(&text, chart)
                                            : tp_chart_script(&text, chart, format);
  if (status != TP_OK) return tp_fail_memory(message, "the chart");
  status = tp_file_open(&file, path, message);
  if (status == TP_OK) {
    status = format == TP_CHART_CSV ? tp_file_write(&file, text, strlen(text), message)
                                    : tp_gnuplot_run(&file, text, message);
    if (status == TP_OK && format == TP_CHART_PDF) status = drop_date(&file, message);
    status = tp_file_close(&file, status, message);
  }
  free(text);
  return status;
}
