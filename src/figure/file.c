/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A figure into a file. It is drawn into memory and written when all of it is there: the file is
 * whole or as it was, and nothing is left where the drawing ends the process. */

#include "output/file.h"
#include "figure/figure.h"
#include "figure/name.h"
#include "message.h"

#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define PNG_DOTS_PER_POINT (300.0 / 72) /* 300 to the inch */

/* What is drawn so far; Cairo does not hand every error on. */
typedef struct sink {
  char *bytes;
  size_t length, capacity;
  bool failed; /* memory was exhausted */
} sink;

static cairo_status_t write_bytes(void *closure, const unsigned char *data, unsigned int length) {
  sink *s = closure;
  if (s->failed) return CAIRO_STATUS_NO_MEMORY;
  if (length > s->capacity - s->length) {
    const size_t capacity = 2 * (s->capacity + length);
    char *bytes = realloc(s->bytes, capacity);
    s->failed = bytes == NULL;
    if (s->failed) return CAIRO_STATUS_NO_MEMORY;
    s->bytes = bytes;
    s->capacity = capacity;
  }
  memcpy(s->bytes + s->length, data, length);
  s->length += length;
  return CAIRO_STATUS_SUCCESS;
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

/* Not over a file that the scene was read from. */
static tp_status write_file(const char *path, const sink *s, const tp_scene *scene,
                            tp_figure_consent consent, tp_message *message) {
  const size_t count = tp_scene_source_count(scene);
  const char **read = calloc(count, sizeof *read);
  if (read == NULL) return tp_fail_memory(message, "the names of files");
  for (size_t k = 0; k < count; k++) read[k] = tp_scene_source(scene, k);
  const tp_status status =
      tp_file_write_if(path, s->bytes, s->length, (tp_file_sources){count, read}, consent, message);
  free(read);
  return status;
}

tp_status tp_figure_write(const char *path, const tp_figure *figure, tp_figure_consent consent,
                          tp_message *message) {
  sink s = {0};
  const cairo_status_t drawn = write_figure(tp_figure_kind_of(path), &s, figure);
  tp_status status = TP_OK;
  if (s.failed || drawn == CAIRO_STATUS_NO_MEMORY) {
    status = tp_fail_memory(message, "the figure");
  } else if (drawn != CAIRO_STATUS_SUCCESS) {
    status = tp_fail(message, TP_DEPENDENCY_FAILED, (tp_place){path, 0, 0},
                     "the figure cannot be drawn: %s", cairo_status_to_string(drawn));
  } else {
    status = write_file(path, &s, figure->problem->scene, consent, message);
  }
  free(s.bytes);
  return status;
}
