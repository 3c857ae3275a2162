/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A figure into a file: written under a name of its own beside it, then renamed, so that the file
 * is whole or as it was. */

#include "message.h"
#include "report/figure.h"
#include "report/figure_name.h"
#include "report/file.h"

#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <math.h>

#define PNG_DOTS_PER_POINT (300.0 / 72) /* 300 to the inch */

/* A file, and how writing to it went: Cairo does not hand every error on. */
typedef struct sink {
  tp_file file;
  tp_status status;
  tp_message *message;
} sink;

static cairo_status_t write_bytes(void *closure, const unsigned char *data, unsigned int length) {
  sink *s = closure;
  if (s->status == TP_OK) {
    s->status = tp_file_write(&s->file, (const char *)data, length, s->message);
  }
  return s->status == TP_OK ? CAIRO_STATUS_SUCCESS : CAIRO_STATUS_WRITE_ERROR;
}

/* Letters measure alike on every kind of page: no fitting of them to its dots. */
static void set_up(cairo_t *cr) {
  cairo_font_options_t *options = cairo_font_options_create();
  cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
  cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
  cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
  cairo_set_font_options(cr, options);
  cairo_font_options_destroy(options);
  cairo_set_line_join(cr, CAIRO_LINE_JOIN_ROUND);
}

/* Draw the page; CAIRO_STATUS_NO_MEMORY where its own memory is exhausted. */
static cairo_status_t draw(double *height, cairo_surface_t *surface, const tp_figure *figure,
                           double dots) {
  cairo_t *cr = cairo_create(surface);
  set_up(cr);
  cairo_scale(cr, dots, dots);
  tp_figure_ink(cr, TP_INK_WHITE);
  cairo_paint(cr);
  const bool done = tp_figure_page(height, cr, figure);
  const cairo_status_t status = done ? cairo_status(cr) : CAIRO_STATUS_NO_MEMORY;
  cairo_destroy(cr);
  return status;
}

/* The height that the page takes, found by drawing it on a page of one dot. */
static cairo_status_t measure(double *height, const tp_figure *figure) {
  cairo_surface_t *dot = cairo_image_surface_create(CAIRO_FORMAT_RGB24, 1, 1);
  const cairo_status_t status = draw(height, dot, figure, 1);
  cairo_surface_destroy(dot);
  return status;
}

static cairo_surface_t *open_surface(tp_figure_kind kind, sink *s, double width, double height) {
  if (kind == TP_FIGURE_SVG)
    return cairo_svg_surface_create_for_stream(write_bytes, s, width, height);
  if (kind == TP_FIGURE_PNG) {
    return cairo_image_surface_create(CAIRO_FORMAT_RGB24, (int)ceil(width * PNG_DOTS_PER_POINT),
                                      (int)ceil(height * PNG_DOTS_PER_POINT));
  }
  cairo_surface_t *surface = cairo_pdf_surface_create_for_stream(write_bytes, s, width, height);
  /* else the time of day, and no two files alike */
  cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATE_DATE, "2000-01-01T00:00:00Z");
  cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATOR, "topple " TP_VERSION);
  return surface;
}

static cairo_status_t write_figure(tp_figure_kind kind, sink *s, const tp_figure *figure) {
  double height = 0;
  cairo_status_t status = measure(&height, figure);
  if (status != CAIRO_STATUS_SUCCESS) return status;
  cairo_surface_t *surface = open_surface(kind, s, tp_figure_width(figure), ceil(height));
  status = cairo_surface_status(surface);
  if (status == CAIRO_STATUS_SUCCESS) {
    status = draw(&height, surface, figure, kind == TP_FIGURE_PNG ? PNG_DOTS_PER_POINT : 1);
  }
  if (status == CAIRO_STATUS_SUCCESS && kind == TP_FIGURE_PNG) {
    status = cairo_surface_write_to_png_stream(surface, write_bytes, s);
  }
  cairo_surface_finish(surface);
  if (status == CAIRO_STATUS_SUCCESS) status = cairo_surface_status(surface);
  cairo_surface_destroy(surface);
  return status;
}

tp_status tp_figure_write(const char *path, const tp_figure *figure, tp_message *message) {
  sink s = {.message = message};
  const tp_status status = tp_file_open(&s.file, path, message);
  if (status != TP_OK) return status;
  const cairo_status_t drawn = write_figure(tp_figure_kind_of(path), &s, figure);
  if (s.status == TP_OK && drawn == CAIRO_STATUS_NO_MEMORY) {
    s.status = tp_fail_memory(message, "the figure");
  } else if (s.status == TP_OK && drawn != CAIRO_STATUS_SUCCESS) {
    s.status = tp_fail(message, TP_DEPENDENCY_FAILED, (tp_place){path, 0, 0},
                       "the figure cannot be drawn: %s", cairo_status_to_string(drawn));
  }
  return tp_file_close(&s.file, s.status, message);
}
