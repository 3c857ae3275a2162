/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Checks the file name of a sheet, gathers the files that it must not overwrite, and writes the
 * document as HTML, Markdown or PDF, with its chart as SVG or PNG. */

#include "figure/sheet_file.h"

#include "chart/chart.h"
#include "common/message.h"
#include "scene/scene.h"

#include <stdlib.h>
#include <string.h>

tp_status tp_sheet_check(const char *path, tp_message *message) {
  if (tp_sheet_is_file_name(path)) return TP_OK;
  return tp_refuse(message, TP_FAULT_KEY, (tp_place){path, 0, 0},
                   "the ending of a report's name is its format: .html, .md or .pdf");
}

tp_status tp_sheet_sources(tp_file_sources *sources, const tp_scene *scene, tp_message *message) {
  const size_t count = scene->file != NULL ? tp_scene_source_count(scene) : 0;
  const char **paths = calloc(count + 1, sizeof *paths);
  if (paths == NULL) return tp_fail_memory(message, "the names of files");
  for (size_t k = 0; k < count; k++) paths[k] = tp_scene_source(scene, k);
  *sources = (tp_file_sources){count, paths};
  return TP_OK;
}

/* The document as bytes of the kind. */
static tp_status make_bytes(char **bytes, size_t *length, tp_sheet_kind kind,
                            const tp_document *document, const tp_vector_picture *drawing,
                            tp_message *message) {
  if (kind == TP_SHEET_PDF) return tp_paper_pdf(bytes, length, document, drawing, message);
  const tp_status status = kind == TP_SHEET_MARKDOWN ? tp_document_markdown(bytes, document)
                                                     : tp_document_html(bytes, document);
  if (status != TP_OK) return tp_fail_memory(message, "the report");
  *length = strlen(*bytes);
  return TP_OK;
}

tp_status tp_sheet_write(const char *path, const tp_document *document,
                         const tp_vector_picture *drawing, tp_file_sources sources,
                         tp_message *message) {
  char *bytes = NULL;
  size_t length = 0;
  tp_status status =
      make_bytes(&bytes, &length, tp_sheet_kind_of(path), document, drawing, message);
  if (status == TP_OK) status = tp_file_write(path, bytes, length, sources, message);
  free(bytes);
  return status;
}

/* ---- with a figure on a page -------------------------------------------------------------------
 */

tp_status tp_figured_sheet_begin(tp_figured_sheet *sheet, const tp_sheet_options *options,
                                 tp_message *message) {
  const tp_status status = tp_sheet_check(sheet->path, message);
  if (status != TP_OK) return status;
  return tp_sheet_head_make(&sheet->head, &sheet->scene->letterhead, options,
                            tp_sheet_kind_of(sheet->path) == TP_SHEET_PDF, message);
}

static bool draw_page(cairo_t *cr, const void *context) {
  const tp_drawn_page *page = context;
  double height = 0;
  return page->draw(&height, cr, page->what);
}

static tp_status write_document(tp_figured_sheet *sheet, const tp_vector_picture *drawing,
                                tp_picture picture, tp_message *message) {
  tp_file_sources sources = {0};
  tp_sheet_files files = {0};
  tp_status status = tp_sheet_sources(&sources, sheet->scene, message);
  if (status == TP_OK) status = tp_sheet_files_read(&files, sources.paths, sources.count, message);
  files.logo = sheet->scene->letterhead.logo;
  files.only_scene = sheet->only_scene;
  if (status == TP_OK) {
    tp_document document = {0};
    sheet->build(&document, sheet->what, &files, &sheet->head, picture);
    status = tp_sheet_write(sheet->path, &document, drawing, sources, message);
    tp_document_clear(&document);
  } else {
    free(picture.svg);
  }
  tp_sheet_files_clear(&files);
  free((void *)sources.paths);
  return status;
}

tp_status tp_figured_sheet_write(tp_figured_sheet *sheet, const tp_drawn_page *page,
                                 tp_message *message) {
  tp_vector_picture drawing = {draw_page, page, page->width, 0};
  tp_picture picture = {0};
  tp_status status = TP_OK;
  if (tp_sheet_kind_of(sheet->path) != TP_SHEET_PDF) {
    status = tp_drawn_page_bytes(&picture.svg, &picture.svg_length, ".x.svg", page, message);
  } else if (tp_drawn_page_measure(&drawing.height, page) != CAIRO_STATUS_SUCCESS) {
    status = tp_fail_memory(message, "the report");
  }
  return status == TP_OK ? write_document(sheet, &drawing, picture, message) : status;
}

/* ---- with charts -------------------------------------------------------------------------------
 */

tp_status tp_sheet_chart(tp_picture *picture, tp_chart *chart, tp_status made, const char *path,
                         const tp_sheet_head *head, tp_message *message) {
  const bool paper = tp_sheet_kind_of(path) == TP_SHEET_PDF;
  if (made == TP_NO_ANSWER) {
    if (message != NULL) message->text[0] = '\0';
    return TP_OK;
  }
  if (made == TP_OK && !tp_chart_tell(chart, head->language, head->comma)) {
    made = tp_fail_memory(message, "the chart");
  }
  if (made == TP_OK) {
    made = paper ? tp_chart_draw(&picture->png, &picture->png_length, chart, TP_CHART_PNG, message)
                 : tp_chart_draw(&picture->svg, &picture->svg_length, chart, TP_CHART_SVG, message);
  }
  tp_chart_free(chart);
  return made;
}
