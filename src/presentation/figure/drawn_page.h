/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A page as the bytes of a file of SVG, PDF or PNG, whatever is drawn on it; and such bytes into a
 * file. */

#ifndef TP_FIGURE_DRAWN_PAGE_H
#define TP_FIGURE_DRAWN_PAGE_H

#include "topple.h"

#include <cairo.h>

typedef struct tp_drawn_page {
  double width; /* points */
  /* Draws it, and tells its height; false when memory is exhausted. */
  bool (*draw)(double *height, cairo_t *cr, const void *what);
  const void *what;
} tp_drawn_page;

/* Draw it, so many dots to the point; CAIRO_STATUS_NO_MEMORY where its own memory is exhausted. */
cairo_status_t tp_drawn_page_draw(double *height, cairo_surface_t *surface,
                                  const tp_drawn_page *page, double dots);

/* The height that it takes, found by drawing it on a page of one dot. */
cairo_status_t tp_drawn_page_measure(double *height, const tp_drawn_page *page);

/* In memory, to be freed, of the kind that a name of this ending has. */
TP_MUST_USE tp_status tp_drawn_page_bytes(char **bytes, size_t *length, const char *path,
                                          const tp_drawn_page *page, tp_message *message);

/* Bytes into a file, not over one that the scene was read from. */
TP_MUST_USE tp_status tp_figure_keep(const char *path, const char *bytes, size_t length,
                                     const tp_scene *scene, tp_figure_consent consent,
                                     tp_message *message);

#endif
