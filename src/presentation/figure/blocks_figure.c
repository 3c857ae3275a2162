/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A solved scene of many blocks as a figure. A result holds no geometry: the blocks are built
 * again.
 */

#include "common/host.h"
#include "common/message.h"
#include "figure/blocks.h"
#include "figure/drawn_page.h"
#include "figure/dxf_blocks.h"
#include "figure/name.h"
#include "figure/version.h"

#include <stdlib.h>

tp_status tp_blocks_figure_init(tp_blocks_figure *figure, const tp_scene *scene,
                                const tp_block_system *system, tp_message *message) {
  *figure = (tp_blocks_figure){.system = system};
  const tp_status status = tp_block_shapes_init(&figure->shapes, scene, system, message);
  if (status != TP_OK) return status;
  tp_blocks_set_up(figure);
  const tp_status loaded = tp_load_shapes_init(&figure->loads, &figure->shapes, scene,
                                               figure->own->towards == TP_TOWARDS_LEFT, message);
  if (loaded != TP_OK) tp_block_shapes_clear(&figure->shapes);
  return loaded;
}

void tp_blocks_figure_clear(tp_blocks_figure *figure) {
  tp_load_shapes_clear(&figure->loads);
  tp_block_shapes_clear(&figure->shapes);
}

static bool draw_page(double *height, cairo_t *cr, const void *what) {
  return tp_blocks_page(height, cr, what);
}

tp_status tp_blocks_figure_bytes(char **bytes, size_t *length, const char *name,
                                 const tp_blocks_figure *figure, const tp_scene *scene,
                                 tp_message *message) {
  const tp_drawn_page page = {tp_blocks_page_width(), draw_page, figure};
  return tp_figure_kind_of(name) == TP_FIGURE_DXF
             ? tp_cad_draw_blocks(bytes, length, figure, scene, message)
             : tp_drawn_page_bytes(bytes, length, name, &page, message);
}

static tp_status write_figure(const char *path, const tp_scene *scene,
                              const tp_blocks_figure *figure, tp_figure_consent consent,
                              tp_message *message) {
  char *bytes = NULL;
  size_t length = 0;
  tp_status status = tp_blocks_figure_bytes(&bytes, &length, path, figure, scene, message);
  if (status == TP_OK) status = tp_figure_keep(path, bytes, length, scene, consent, message);
  free(bytes);
  return status;
}

tp_status tp_report_figure_block_system(const char *path, const tp_scene *scene,
                                        const tp_block_system *system, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, path);
  TP_REFUSE_NULL(message, scene);
  TP_REFUSE_NULL(message, system);
  TP_REFUSE_OTHER_VERSION(message);
  return tp_report_figure_block_system_if(path, scene, system, (tp_figure_consent){0}, message);
}

tp_status tp_report_figure_block_system_if(const char *path, const tp_scene *scene,
                                           const tp_block_system *system, tp_figure_consent consent,
                                           tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, path);
  TP_REFUSE_NULL(message, scene);
  TP_REFUSE_NULL(message, system);
  TP_REFUSE_OTHER_VERSION(message);
  if (!tp_figure_is_of_blocks(path)) {
    return tp_refuse(message, TP_FAULT_KEY, (tp_place){path, 0, 0},
                     "the ending of the name of a figure is its format: .svg, .pdf, .png or "
                     ".dxf");
  }
  tp_blocks_figure figure;
  tp_status status = tp_blocks_figure_init(&figure, scene, system, message);
  if (status == TP_OK) {
    status = write_figure(path, scene, &figure, consent, message);
    tp_blocks_figure_clear(&figure);
  }
  return status;
}
