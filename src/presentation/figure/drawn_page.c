/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A page into a file. It is drawn into memory and written when all of it is there: the file is
 * whole or as it was, and nothing is left where the drawing ends the process. */

#define _GNU_SOURCE
#include "figure/drawn_page.h"
#include "common/message.h"
#include "figure/figure.h"
#include "figure/name.h"
#include "figure/sink.h"
#include "output/file.h"

#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define PNG_DOTS_PER_POINT (300.0 / 72) /* 300 to the inch */

void tp_figure_set_up(cairo_t *cr) {
  cairo_font_options_t *options = cairo_font_options_create();
  cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
  cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
  cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
  cairo_set_font_options(cr, options);
  cairo_font_options_destroy(options);
  cairo_set_line_join(cr, CAIRO_LINE_JOIN_ROUND);
}

cairo_status_t tp_drawn_page_draw(double *height, cairo_surface_t *surface,
                                  const tp_drawn_page *page, double dots) {
  cairo_t *cr = cairo_create(surface);
  tp_figure_set_up(cr);
  cairo_scale(cr, dots, dots);
  tp_figure_ink(cr, TP_INK_WHITE);
  cairo_paint(cr);
  const bool done = page->draw(height, cr, page->what);
  const cairo_status_t status = done ? cairo_status(cr) : CAIRO_STATUS_NO_MEMORY;
  cairo_destroy(cr);
  return status;
}

cairo_status_t tp_drawn_page_measure(double *height, const tp_drawn_page *page) {
  cairo_surface_t *dot = cairo_image_surface_create(CAIRO_FORMAT_RGB24, 1, 1);
  const cairo_status_t status = tp_drawn_page_draw(height, dot, page, 1);
  cairo_surface_destroy(dot);
  return status;
}

static cairo_surface_t *open_surface(tp_figure_kind kind, tp_sink *s, double width, double height) {
  if (kind == TP_FIGURE_SVG)
    return cairo_svg_surface_create_for_stream(tp_sink_write, s, width, height);
  if (kind == TP_FIGURE_PNG) {
    return cairo_image_surface_create(CAIRO_FORMAT_RGB24, (int)ceil(width * PNG_DOTS_PER_POINT),
                                      (int)ceil(height * PNG_DOTS_PER_POINT));
  }
  cairo_surface_t *surface = cairo_pdf_surface_create_for_stream(tp_sink_write, s, width, height);
  /* else the time of day, and no two files alike */
  cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATE_DATE, "2000-01-01T00:00:00Z");
  cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATOR, "topple " TP_VERSION);
  return surface;
}

static cairo_status_t write_page(tp_figure_kind kind, tp_sink *s, const tp_drawn_page *page) {
  double height = 0;
  cairo_status_t status = tp_drawn_page_measure(&height, page);
  if (status != CAIRO_STATUS_SUCCESS) return status;
  cairo_surface_t *surface = open_surface(kind, s, page->width, ceil(height));
  status = cairo_surface_status(surface);
  if (status == CAIRO_STATUS_SUCCESS) {
    status =
        tp_drawn_page_draw(&height, surface, page, kind == TP_FIGURE_PNG ? PNG_DOTS_PER_POINT : 1);
  }
  if (status == CAIRO_STATUS_SUCCESS && kind == TP_FIGURE_PNG) {
    status = cairo_surface_write_to_png_stream(surface, tp_sink_write, s);
  }
  cairo_surface_finish(surface);
  if (status == CAIRO_STATUS_SUCCESS) status = cairo_surface_status(surface);
  cairo_surface_destroy(surface);
  return status;
}

tp_status tp_figure_keep(const char *path, const char *bytes, size_t length, const tp_scene *scene,
                         tp_figure_consent consent, tp_message *message) {
  const size_t count = tp_scene_source_count(scene);
  const char **read = calloc(count, sizeof *read);
  if (read == NULL) return tp_fail_memory(message, "the names of files");
  for (size_t k = 0; k < count; k++) read[k] = tp_scene_source(scene, k);
  const tp_status status =
      tp_file_write_if(path, bytes, length, (tp_file_sources){count, read}, consent, message);
  free(read);
  return status;
}

/* Cairo counts the surfaces of a process, and names the drawing by that number, which nothing
 * refers to: it is left out, so that the same figure is the same file whenever it is drawn. */
static void drop_surface_number(tp_sink *s) {
  static const char key[] = " id=\"surface";
  char *id = memmem(s->bytes, s->length, key, strlen(key));
  if (id == NULL) return;
  const char *end =
      memchr(id + strlen(key), '"', s->length - (size_t)(id + strlen(key) - s->bytes));
  if (end == NULL) return;
  memmove(id, end + 1, (size_t)(s->bytes + s->length - (end + 1)));
  s->length -= (size_t)(end + 1 - id);
}

/* The number behind `"image` or `#image`, where one stands there; else 0. */
static unsigned long image_number(const char *at, const char *past, size_t *digits) {
  static const char word[] = "image";
  const size_t length = strlen(word);
  *digits = 0;
  if ((size_t)(past - at) <= length + 1 || (*at != '"' && *at != '#')) return 0;
  if (memcmp(at + 1, word, length) != 0) return 0;
  const char *first = at + 1 + length;
  unsigned long number = 0;
  while (first + *digits < past && first[*digits] >= '0' && first[*digits] <= '9') {
    number = 10 * number + (unsigned long)(first[(*digits)++] - '0');
  }
  return number;
}

/* So are pictures named: they are counted from 1 in the order in which they stand in the file. */
static void number_images(tp_sink *s) {
  enum { MOST = 8, PREFIX = 6 };
  unsigned long known[MOST];
  size_t count = 0, digits = 0, kept = 0;
  const char *past = s->bytes + s->length;
  for (const char *at = s->bytes; at < past;) {
    const unsigned long number = image_number(at, past, &digits);
    size_t k = 0;
    while (k < count && known[k] != number) k++;
    if (digits == 0 || k == MOST) {
      s->bytes[kept++] = *at++;
      continue;
    }
    if (k == count) known[count++] = number;
    memmove(s->bytes + kept, at, PREFIX);
    s->bytes[kept + PREFIX] = (char)('1' + (int)k);
    kept += PREFIX + 1;
    at += PREFIX + digits;
  }
  s->length = kept;
}

tp_status tp_drawn_page_bytes(char **bytes, size_t *length, const char *path,
                              const tp_drawn_page *page, tp_message *message) {
  tp_sink s = {0};
  const cairo_status_t drawn = write_page(tp_figure_kind_of(path), &s, page);
  if (!s.failed && drawn == CAIRO_STATUS_SUCCESS) {
    if (tp_figure_kind_of(path) == TP_FIGURE_SVG) {
      drop_surface_number(&s);
      number_images(&s);
    }
    *bytes = s.bytes;
    *length = s.length;
    return TP_OK;
  }
  free(s.bytes);
  if (s.failed || drawn == CAIRO_STATUS_NO_MEMORY) return tp_fail_memory(message, "the figure");
  return tp_fail(message, TP_DEPENDENCY_FAILED, (tp_place){path, 0, 0},
                 "the figure cannot be drawn: %s", cairo_status_to_string(drawn));
}
