/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Calculation sheet of many blocks written to a file, with their drawing. */

#include "report/sheet_system.h"
#include "common/host.h"
#include "common/message.h"
#include "common/options.h"
#include "figure/blocks.h"
#include "figure/drawn_page.h"
#include "figure/sheet_file.h"
#include "figure/version.h"
#include "scene/scene.h"

#include <stdlib.h>

static bool draw_page(double *height, cairo_t *cr, const void *what) {
  return tp_blocks_page(height, cr, what);
}

static bool draw_figure(cairo_t *cr, const void *context) {
  double height = 0;
  return tp_blocks_page(&height, cr, context);
}

typedef struct work {
  const char *path;
  tp_system_sheet sheet; /* what it is of */
  tp_file_sources sources;
  tp_sheet_head head;
} work;

static tp_status write_document(work *own, const tp_vector_picture *drawing, tp_picture picture,
                                tp_message *message) {
  tp_sheet_files files = {0};
  tp_status status = tp_sheet_files_read(&files, own->sources.paths, own->sources.count, message);
  files.logo = own->sheet.scene->letterhead.logo;
  if (status == TP_OK) {
    tp_document document = {0};
    tp_sheet_build_system(&document, &own->sheet, &files, &own->head, picture);
    status = tp_sheet_write(own->path, &document, drawing, own->sources, message);
    tp_document_clear(&document);
  } else {
    free(picture.svg);
  }
  tp_sheet_files_clear(&files);
  return status;
}

static tp_status write_sheet(work *own, tp_message *message) {
  tp_blocks_figure figure;
  tp_picture picture = {0};
  tp_status status = tp_blocks_figure_init(&figure, own->sheet.scene, own->sheet.system, message);
  if (status != TP_OK) return status;
  figure.language = own->head.language;
  figure.comma = own->head.comma;
  figure.sketch = true;
  const tp_drawn_page page = {tp_blocks_page_width(), draw_page, &figure};
  tp_vector_picture drawing = {draw_figure, &figure, page.width, 0};
  if (tp_sheet_kind_of(own->path) != TP_SHEET_PDF) {
    status = tp_drawn_page_bytes(&picture.svg, &picture.svg_length, ".x.svg", &page, message);
  } else if (tp_drawn_page_measure(&drawing.height, &page) != CAIRO_STATUS_SUCCESS) {
    status = tp_fail_memory(message, "the report");
  }
  if (status == TP_OK) status = write_document(own, &drawing, picture, message);
  tp_blocks_figure_clear(&figure);
  return status;
}

tp_status tp_report_sheet_block_system(const char *path, const tp_scene *scene,
                                       const tp_block_system *system,
                                       const tp_sheet_options *options, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, path);
  TP_REFUSE_NULL(message, scene);
  TP_REFUSE_NULL(message, system);
  TP_REFUSE_NULL(message, options);
  TP_REFUSE_OTHER_VERSION(message);
  tp_sheet_options taken = tp_sheet_options_default();
  TP_TAKE_OPTIONS(message, taken, options);
  work own = {.path = path, .sheet = {.scene = scene, .system = system, .options = &taken}};
  tp_status status = tp_sheet_check(path, message);
  if (status == TP_OK) {
    status = tp_sheet_head_make(&own.head, &scene->letterhead, &taken,
                                tp_sheet_kind_of(path) == TP_SHEET_PDF, message);
  }
  if (status == TP_OK) status = tp_sheet_sources(&own.sources, scene, message);
  if (status == TP_OK) status = write_sheet(&own, message);
  tp_logo_clear(&own.head.logo);
  free((void *)own.sources.paths);
  return status;
}
