/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The outline laid over the picture, with its band of two standard deviations to either side. */

#include "trace/trace.h"

#include <cairo.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { LONGEST = 1500, STRIP = 62, LEAST = 500 };

typedef struct view {
  double left, top, width, height; /* of what is shown, in pixels of the picture */
  double scale;                    /* pixels of the figure in one of those */
} view;

typedef struct sink {
  char *bytes;
  size_t length, room;
} sink;

static cairo_status_t write_bytes(void *closure, const unsigned char *data, unsigned length) {
  sink *s = closure;
  if (length > s->room - s->length) {
    const size_t room = 2 * (s->room + length);
    char *bytes = realloc(s->bytes, room);
    if (bytes == NULL) return CAIRO_STATUS_NO_MEMORY;
    s->bytes = bytes;
    s->room = room;
  }
  memcpy(s->bytes + s->length, data, length);
  s->length += length;
  return CAIRO_STATUS_SUCCESS;
}

/* ---- what is shown -----------------------------------------------------------------------------
 */

static void include(double box[4], tp_trace_point p) {
  box[0] = fmin(box[0], p.x);
  box[1] = fmin(box[1], p.y);
  box[2] = fmax(box[2], p.x);
  box[3] = fmax(box[3], p.y);
}

static view find_view(const tp_trace *trace, const tp_trace_picture *picture,
                      const tp_trace_options *options) {
  double box[4] = {INFINITY, INFINITY, -INFINITY, -INFINITY};
  for (long k = 0; k < trace->ring.count; k++) include(box, trace->ring.points[k]);
  for (int k = 0; k < 2; k++) include(box, options->scale[k]);
  for (int k = 0; k < 2 && options->plumb_given; k++) include(box, options->plumb[k]);
  const double margin = fmax(box[2] - box[0], box[3] - box[1]) / 12 + 4;
  view own = {.left = fmax(0, floor(box[0] - margin)), .top = fmax(0, floor(box[1] - margin))};
  own.width = fmin(picture->width, ceil(box[2] + margin)) - own.left;
  own.height = fmin(picture->height, ceil(box[3] + margin)) - own.top;
  own.scale = LONGEST / fmax(own.width, own.height);
  own.scale = fmin(own.scale, 4);                 /* larger pixels tell no more */
  own.scale = fmax(own.scale, LEAST / own.width); /* room for the words below */
  return own;
}

/* ---- drawing -----------------------------------------------------------------------------------
 */

static cairo_surface_t *surface_of(const tp_trace_picture *picture) {
  cairo_surface_t *surface =
      cairo_image_surface_create(CAIRO_FORMAT_RGB24, picture->width, picture->height);
  if (cairo_surface_status(surface) != CAIRO_STATUS_SUCCESS) return surface;
  unsigned char *data = cairo_image_surface_get_data(surface);
  const int stride = cairo_image_surface_get_stride(surface);
  const unsigned char *from = picture->rgb;
  for (int y = 0; y < picture->height; y++) {
    for (int x = 0; x < picture->width; x++, from += 3) {
      const uint32_t pixel = (uint32_t)from[0] << 16 | (uint32_t)from[1] << 8 | from[2];
      memcpy(data + (size_t)y * (size_t)stride + 4 * (size_t)x, &pixel, sizeof pixel);
    }
  }
  cairo_surface_mark_dirty(surface);
  return surface;
}

static void add_ring(cairo_t *cr, const tp_trace *trace, double offset, bool backwards) {
  const long count = trace->ring.count;
  for (long k = 0; k < count; k++) {
    const long at = backwards ? count - 1 - k : k;
    const tp_trace_point p = trace->ring.points[at], m = trace->moves[at];
    cairo_line_to(cr, p.x + offset * m.x, p.y + offset * m.y);
  }
  cairo_close_path(cr);
}

/* A line of the figure's own width, dark with a light rim, seen on any ground. */
static void stroke(cairo_t *cr, double width, double red, double green, double blue) {
  cairo_set_source_rgba(cr, 1, 1, 1, 0.9);
  cairo_set_line_width(cr, width + 2);
  cairo_stroke_preserve(cr);
  cairo_set_source_rgb(cr, red, green, blue);
  cairo_set_line_width(cr, width);
  cairo_stroke(cr);
}

static void add_segment(cairo_t *cr, const tp_trace_point ends[2]) {
  cairo_new_path(cr);
  cairo_move_to(cr, ends[0].x, ends[0].y);
  cairo_line_to(cr, ends[1].x, ends[1].y);
}

/* The part of the outline that touches the base, from the left end to the right one; the ring runs
 * clockwise as it is seen. */
static void draw_contact(cairo_t *cr, const tp_trace *trace, double scale) {
  const long count = trace->ring.count;
  cairo_new_path(cr);
  for (long k = trace->between[1];; k = (k + 1) % count) {
    cairo_line_to(cr, trace->ring.points[k].x, trace->ring.points[k].y);
    if (k == trace->between[0]) break;
  }
  cairo_save(cr);
  cairo_scale(cr, 1 / scale, 1 / scale);
  stroke(cr, 4, 0, 0.62, 0.45);
  cairo_restore(cr);
}

static void draw_lines(cairo_t *cr, const tp_trace *trace, const tp_trace_options *options,
                       double scale) {
  cairo_new_path(cr);
  add_ring(cr, trace, 2 * trace->deviation_px, false);
  cairo_new_sub_path(cr);
  add_ring(cr, trace, -2 * trace->deviation_px, true);
  cairo_set_fill_rule(cr, CAIRO_FILL_RULE_WINDING);
  cairo_set_source_rgba(cr, 1, 0.75, 0, 0.6);
  cairo_fill(cr);
  cairo_set_line_join(cr, CAIRO_LINE_JOIN_ROUND);
  add_ring(cr, trace, 0, false);
  cairo_save(cr);
  cairo_scale(cr, 1 / scale, 1 / scale);
  cairo_set_source_rgb(cr, 0, 0.2, 0.6);
  cairo_set_line_width(cr, 1.5);
  cairo_stroke(cr);
  cairo_restore(cr);
  if (options->between_given) draw_contact(cr, trace, scale);
  add_segment(cr, options->scale);
  cairo_save(cr);
  cairo_scale(cr, 1 / scale, 1 / scale);
  stroke(cr, 3, 0, 0, 0);
  cairo_restore(cr);
  if (!options->plumb_given) return;
  const double dashes[] = {10, 6};
  add_segment(cr, options->plumb);
  cairo_save(cr);
  cairo_scale(cr, 1 / scale, 1 / scale);
  cairo_set_dash(cr, dashes, 2, 0);
  stroke(cr, 2, 0.7, 0, 0);
  cairo_restore(cr);
}

static void draw_words(cairo_t *cr, const tp_trace *trace, const tp_trace_options *options,
                       double top) {
  char line[160];
  cairo_select_font_face(cr, "Liberation Sans", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(cr, 15);
  cairo_set_source_rgb(cr, 0, 0, 0);
  snprintf(line, sizeof line,
           "Blue: outline, %ld points. Yellow: two standard deviations, ±%.3g %s.%s",
           trace->ring.count, 2 * trace->deviation_px * trace->per_pixel, options->unit,
           options->between_given ? " Green: contact" : "");
  cairo_move_to(cr, 10, top + 24);
  cairo_show_text(cr, line);
  snprintf(line, sizeof line, "Black: scale, %.6g %s.%s", options->length, options->unit,
           options->plumb_given ? " Red, dashed: plumb line" : " No plumb line");
  cairo_move_to(cr, 10, top + 48);
  cairo_show_text(cr, line);
}

static cairo_status_t draw(cairo_surface_t *surface, const tp_trace *trace,
                           cairo_surface_t *picture, const tp_trace_options *options, view v) {
  cairo_t *cr = cairo_create(surface);
  cairo_set_source_rgb(cr, 1, 1, 1);
  cairo_paint(cr);
  cairo_save(cr);
  cairo_rectangle(cr, 0, 0, v.width * v.scale, v.height * v.scale);
  cairo_clip(cr);
  cairo_scale(cr, v.scale, v.scale);
  cairo_translate(cr, -v.left, -v.top);
  cairo_set_source_surface(cr, picture, 0, 0);
  cairo_pattern_set_filter(cairo_get_source(cr),
                           v.scale > 1 ? CAIRO_FILTER_NEAREST : CAIRO_FILTER_GOOD);
  cairo_paint(cr);
  draw_lines(cr, trace, options, v.scale);
  cairo_restore(cr);
  draw_words(cr, trace, options, v.height * v.scale);
  const cairo_status_t status = cairo_status(cr);
  cairo_destroy(cr);
  return status;
}

tp_status tp_trace_draw(char **bytes, size_t *length, const tp_trace *trace,
                        const tp_trace_picture *picture, const tp_trace_options *options,
                        tp_message *message) {
  const view v = find_view(trace, picture, options);
  sink own = {0};
  cairo_surface_t *from = surface_of(picture);
  cairo_surface_t *to = cairo_image_surface_create(CAIRO_FORMAT_RGB24, (int)ceil(v.width * v.scale),
                                                   (int)ceil(v.height * v.scale) + STRIP);
  cairo_status_t status = draw(to, trace, from, options, v);
  if (status == CAIRO_STATUS_SUCCESS) {
    status = cairo_surface_write_to_png_stream(to, write_bytes, &own);
  }
  cairo_surface_destroy(from);
  cairo_surface_destroy(to);
  if (status == CAIRO_STATUS_SUCCESS) {
    *bytes = own.bytes;
    *length = own.length;
    return TP_OK;
  }
  free(own.bytes);
  return status == CAIRO_STATUS_NO_MEMORY
             ? tp_fail_memory(message, "a figure")
             : tp_fail(message, TP_DEPENDENCY_FAILED, (tp_place){NULL, 0, 0},
                       "Cairo fails to draw the figure: %s", cairo_status_to_string(status));
}
