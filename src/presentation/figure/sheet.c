/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Calculation sheet of a solution written to a file, with its drawing. */

#include "common/host.h"
#include "common/message.h"
#include "common/options.h"
#include "figure/figure.h"
#include "figure/sheet_file.h"
#include "figure/version.h"
#include "scene/scene.h"

#include <stdlib.h>

typedef struct work {
  const char *path;
  const tp_scene *scene;
  const tp_solution *solution;
  const tp_sheet_options *options;
  tp_file_sources sources;
  tp_sheet_head head;
  const char *logo; /* of the scene; NULL: none */
} work;

static bool draw_figure(cairo_t *cr, const void *context) {
  double height = 0;
  return tp_figure_page(&height, cr, context);
}

static tp_status write_sheet(const tp_figure *english, void *context, tp_message *message) {
  work *own = context;
  tp_figure told = *english;
  const tp_figure *figure = &told;
  told.language = own->head.language;
  told.comma = own->head.comma;
  told.sketch = true;
  const bool paper = tp_sheet_kind_of(own->path) == TP_SHEET_PDF;
  tp_vector_picture drawing = {draw_figure, figure, tp_figure_width(figure), 0};
  tp_picture picture = {0};
  tp_sheet_files files = {0};
  tp_status status = tp_sheet_files_read(&files, own->sources.paths, own->sources.count, message);
  files.logo = own->logo;
  if (status == TP_OK && paper &&
      tp_figure_measure(&drawing.height, figure) != CAIRO_STATUS_SUCCESS) {
    status = tp_fail_memory(message, "the report");
  }
  if (status == TP_OK && !paper) {
    status = tp_figure_bytes(&picture.svg, &picture.svg_length, ".x.svg", figure, message);
  }
  if (status == TP_OK) {
    tp_document document = {0};
    tp_sheet_build(&document, own->scene, own->solution, &files, own->options, &own->head, picture);
    status = tp_sheet_write(own->path, &document, &drawing, own->sources, message);
    tp_document_clear(&document);
  }
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
  TP_REFUSE_OTHER_VERSION(message);
  tp_sheet_options taken = tp_sheet_options_default();
  TP_TAKE_OPTIONS(message, taken, options);
  tp_file_sources sources = {0};
  tp_status status = tp_sheet_check(path, message);
  if (status == TP_OK) status = tp_sheet_sources(&sources, scene, message);
  if (status != TP_OK) return status;
  work own = {.path = path,
              .scene = scene,
              .solution = solution,
              .options = &taken,
              .sources = sources,
              .logo = scene->letterhead.logo};
  status = tp_sheet_head_make(&own.head, &scene->letterhead, &taken,
                              tp_sheet_kind_of(path) == TP_SHEET_PDF, message);
  if (status != TP_OK) {
    free((void *)sources.paths);
    return status;
  }
  status = tp_figure_prepare(scene, solution, write_sheet, &own, message);
  tp_logo_clear(&own.head.logo);
  free((void *)sources.paths);
  return status;
}
