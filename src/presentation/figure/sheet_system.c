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

static bool draw_page(double *height, cairo_t *cr, const void *what) {
  return tp_blocks_page(height, cr, what);
}

static void build(tp_document *document, const void *what, const tp_sheet_files *files,
                  tp_sheet_head *head, tp_picture picture) {
  tp_sheet_build_system(document, what, files, head, picture);
}

static tp_status write_sheet(tp_figured_sheet *sheet, const tp_block_system *system,
                             tp_message *message) {
  tp_blocks_figure figure;
  tp_status status = tp_blocks_figure_init(&figure, sheet->scene, system, message);
  if (status != TP_OK) return status;
  figure.language = sheet->head.language;
  figure.comma = sheet->head.comma;
  figure.sketch = true;
  const tp_drawn_page page = {tp_blocks_page_width(), draw_page, &figure};
  status = tp_figured_sheet_write(sheet, &page, message);
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
  const tp_system_sheet what = {.scene = scene, .system = system, .options = &taken};
  tp_figured_sheet own = {.path = path, .scene = scene, .build = build, .what = &what};
  tp_status status = tp_figured_sheet_begin(&own, &taken, message);
  if (status == TP_OK) status = write_sheet(&own, system, message);
  tp_logo_clear(&own.head.logo);
  return status;
}
