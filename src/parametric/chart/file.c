/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Writes a chart as SVG, PDF or PNG by gnuplot, or as CSV; dates that a PDF carries are blanked, so
 * that the same chart gives the same bytes. */

#define _GNU_SOURCE
#include "output/file.h"
#include "chart/chart.h"
#include "chart/gnuplot.h"
#include "chart/script.h"
#include "common/host.h"
#include "common/message.h"

#include <stdlib.h>
#include <string.h>
#include <strings.h>

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

/* Cairo writes when a PDF was made, which the standard leaves optional: blanks instead, so that the
 * same chart is the same file and no offset in it moves. */
static void drop_date(char *data, size_t size) {
  static const char key[] = "/CreationDate (";
  char *date = memmem(data, size, key, strlen(key));
  const char *end = date != NULL ? memchr(date, ')', (size_t)(data + size - date)) : NULL;
  if (end != NULL) memset(date, ' ', (size_t)(end + 1 - date));
}

/* Or blanks beside markup would be dropped by some programs. False when memory is exhausted. */
static bool keep_blanks(char **data, size_t *size) {
  static const char key[] = "<svg ", added[] = "xml:space=\"preserve\" ";
  const size_t more = strlen(added);
  char *larger = realloc(*data, *size + more);
  if (larger == NULL) return false;
  *data = larger;
  char *root = memmem(larger, *size, key, strlen(key));
  if (root == NULL) return true;
  char *at = root + strlen(key);
  memmove(at + more, at, *size - (size_t)(at - larger));
  memcpy(at, added, more);
  *size += more;
  return true;
}

tp_status tp_chart_draw(char **data, size_t *size, const tp_chart *chart, tp_chart_format format,
                        tp_message *message) {
  char *script = NULL;
  if (tp_chart_script(&script, chart, format) != TP_OK) return tp_fail_memory(message, "the chart");
  const tp_status status = tp_gnuplot_run(data, size, script, message);
  free(script);
  if (status != TP_OK) return status;
  if (format == TP_CHART_PDF) drop_date(*data, *size);
  if (format != TP_CHART_SVG || keep_blanks(data, size)) return TP_OK;
  return tp_fail_memory(message, "the figure");
}

static tp_status tabulate(char **data, size_t *size, const tp_chart *chart, tp_message *message) {
  if (tp_report_chart_csv(data, chart) != TP_OK) return tp_fail_memory(message, "the chart");
  *size = strlen(*data);
  return TP_OK;
}

tp_status tp_report_chart_file(const char *path, const tp_chart *chart, tp_chart_format format,
                               tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, chart);
  TP_REFUSE_NULL(message, path);
  if ((int)format < TP_CHART_SVG || (int)format > TP_CHART_CSV) {
    return tp_refuse(message, TP_FAULT_ARGUMENT, (tp_place){path, 0, 0}, "there is no such format");
  }
  char *data = NULL;
  size_t size = 0;
  tp_status status = format == TP_CHART_CSV ? tabulate(&data, &size, chart, message)
                                            : tp_chart_draw(&data, &size, chart, format, message);
  if (status == TP_OK) {
    const tp_file_sources sources = {chart->source_count, (const char *const *)chart->sources};
    status = tp_file_write(path, data, size, sources, message);
  }
  free(data);
  return status;
}
