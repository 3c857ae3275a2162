/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The figure of a block as a page, and into a file. */

#include "common/message.h"
#include "figure/drawn_page.h"
#include "figure/dxf.h"
#include "figure/name.h"

#include <stdlib.h>

static bool draw_page(double *height, cairo_t *cr, const void *what) {
  return tp_figure_page(height, cr, what);
}

static tp_drawn_page page_of(const tp_figure *figure) {
  return (tp_drawn_page){tp_figure_width(figure), draw_page, figure};
}

cairo_status_t tp_figure_draw(double *height, cairo_surface_t *surface, const tp_figure *figure,
                              double dots) {
  const tp_drawn_page page = page_of(figure);
  return tp_drawn_page_draw(height, surface, &page, dots);
}

cairo_status_t tp_figure_measure(double *height, const tp_figure *figure) {
  const tp_drawn_page page = page_of(figure);
  return tp_drawn_page_measure(height, &page);
}

tp_status tp_figure_bytes(char **bytes, size_t *length, const char *path, const tp_figure *figure,
                          tp_message *message) {
  const tp_drawn_page page = page_of(figure);
  return tp_figure_kind_of(path) == TP_FIGURE_DXF
             ? tp_cad_draw(bytes, length, figure, message)
             : tp_drawn_page_bytes(bytes, length, path, &page, message);
}

tp_status tp_figure_write(const char *path, const tp_figure *figure, tp_figure_consent consent,
                          tp_message *message) {
  char *bytes = NULL;
  size_t length = 0;
  tp_status status = tp_figure_bytes(&bytes, &length, path, figure, message);
  if (status == TP_OK) {
    status = tp_figure_keep(path, bytes, length, figure->problem->scene, consent, message);
  }
  free(bytes);
  return status;
}
