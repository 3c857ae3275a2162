/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Calculation sheet of a solid written to a file, with its drawing. */

#include "report/sheet_solid.h"
#include "common/host.h"
#include "common/message.h"
#include "common/options.h"
#include "figure/sheet_file.h"
#include "figure/solid.h"
#include "figure/version.h"
#include "scene/scene.h"

static void build(tp_document *document, const void *what, const tp_sheet_files *files,
                  tp_sheet_head *head, tp_picture picture) {
  tp_sheet_build_solid(document, what, files, head, picture);
}

static tp_status write_sheet(tp_figured_sheet *sheet, const tp_solid *solid, tp_message *message) {
  tp_solid_figure figure;
  tp_status status = tp_solid_figure_init(&figure, solid, TP_SOLID_SKETCH_DOTS, message);
  if (status != TP_OK) return status;
  figure.language = sheet->head.language;
  figure.comma = sheet->head.comma;
  figure.sketch = true;
  const tp_drawn_page page = tp_solid_drawn_page(&figure);
  status = tp_figured_sheet_write(sheet, &page, message);
  tp_solid_figure_clear(&figure);
  return status;
}

tp_status tp_report_sheet_solid(const char *path, const tp_scene *scene, const tp_solid *solid,
                                const tp_sheet_options *options, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, path);
  TP_REFUSE_NULL(message, scene);
  TP_REFUSE_NULL(message, solid);
  TP_REFUSE_NULL(message, options);
  TP_REFUSE_OTHER_VERSION(message);
  tp_sheet_options taken = tp_sheet_options_default();
  TP_TAKE_OPTIONS(message, taken, options);
  if (!tp_scene_is_solid(scene)) {
    return tp_refuse(message, TP_FAULT_KEY, scene->block.place,
                     "this scene has no 'solid': the sheet of a solid is of the scene that it was "
                     "solved from");
  }
  const tp_solid_sheet what = {.scene = scene, .solid = solid, .options = &taken};
  tp_figured_sheet own = {
      .path = path, .scene = scene, .only_scene = true, .build = build, .what = &what};
  tp_status status = tp_figured_sheet_begin(&own, &taken, message);
  if (status == TP_OK) status = write_sheet(&own, solid, message);
  tp_logo_clear(&own.head.logo);
  return status;
}
