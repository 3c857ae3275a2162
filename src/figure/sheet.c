/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Calculation sheets as files. */

#include "report/sheet.h"
#include "figure/figure.h"
#include "figure/paper.h"
#include "figure/sheet_name.h"
#include "host.h"
#include "message.h"
#include "options.h"
#include "output/file.h"

#include <stdlib.h>
#include <string.h>

typedef struct work {
  const char *path;
  const tp_solution *solution;
  const tp_sheet_options *options;
  tp_file_sources sources;
} work;

static bool draw_figure(cairo_t *cr, const void *context) {
  double height = 0;
  return tp_figure_page(&height, cr, context);
}

/* The document as bytes of the kind. */
static tp_status write_document(char **bytes, size_t *length, tp_sheet_kind kind,
                                const tp_document *document, const tp_figure *figure,
                                tp_message *message) {
  if (kind == TP_SHEET_PDF) {
    tp_drawing drawing = {draw_figure, figure, tp_figure_width(figure), 0};
    if (tp_figure_measure(&drawing.height, figure) != CAIRO_STATUS_SUCCESS) {
      return tp_fail_memory(message, "the report");
    }
    return tp_paper_pdf(bytes, length, document, &drawing, message);
  }
  const tp_status status = kind == TP_SHEET_MARKDOWN ? tp_document_markdown(bytes, document)
                                                     : tp_document_html(bytes, document);
  if (status != TP_OK) return tp_fail_memory(message, "the report");
  *length = strlen(*bytes);
  return TP_OK;
}

static tp_status write_sheet(const tp_figure *figure, void *context, tp_message *message) {
  const work *own = context;
  const tp_sheet_kind kind = tp_sheet_kind_of(own->path);
  tp_picture picture = {0};
  tp_sheet_files files = {0};
  tp_document document = {0};
  char *bytes = NULL;
  size_t length = 0;
  tp_status status = tp_sheet_files_read(&files, own->sources.paths, own->sources.count, message);
  if (status == TP_OK && kind != TP_SHEET_PDF) {
    status = tp_figure_bytes(&picture.svg, &picture.svg_length, ".x.svg", figure, message);
  }
  if (status == TP_OK) {
    tp_sheet_build(&document, own->solution, &files, own->options, picture);
    status = write_document(&bytes, &length, kind, &document, figure, message);
  }
  if (status == TP_OK) {
    status = tp_file_write(own->path, bytes, length, own->sources, message);
  }
  free(bytes);
  tp_document_clear(&document);
  tp_sheet_files_clear(&files);
  return status;
}

tp_status tp_report_sheet(const char *path, const tp_scene *scene, const tp_solution *solution,
                          const tp_sheet_options *options, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, path);
  TP_REFUSE_NULL(message, scene);
  TP_REFUSE_NULL(message, solution);
  TP_REFUSE_NULL(message, options);
  tp_sheet_options taken = tp_sheet_options_default();
  TP_TAKE_OPTIONS(message, taken, options);
  if (!tp_sheet_is_file_name(path)) {
    return tp_fail(message, TP_BAD_INPUT, (tp_place){path, 0, 0},
                   "a report is of the kind that its name ends in: .html, .md or .pdf");
  }
  const size_t count = scene->file != NULL ? tp_scene_source_count(scene) : 0;
  const char **paths = calloc(count + 1, sizeof *paths);
  if (paths == NULL) return tp_fail_memory(message, "the names of files");
  for (size_t k = 0; k < count; k++) paths[k] = tp_scene_source(scene, k);
  work own = {path, solution, options, {count, paths}};
  const tp_status status = tp_figure_prepare(scene, solution, write_sheet, &own, message);
  free(paths);
  return status;
}
