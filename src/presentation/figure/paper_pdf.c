/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Draws the passages of a document on A4 pages: paragraphs, headings kept with what follows,
 * tables, equations and figures scaled to the page. */

#include "figure/paper.h"

#include "common/message.h"
#include "figure/sink.h"

#include <cairo-pdf.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define TEXT_SIZE 9.0

/* Below a heading; the height of a figure, of the page's; by how much it may be smaller to stand on
 * the page where it is spoken of; its caption. */
static const double after_heading = 100, figure_share = 0.62, smaller = 0.78, caption = 20,
                    least_sketch = 90;

/* A paragraph, line by line; with a bar before it where it is set off: a double one of a caution.
 */
static void add_paragraph(tp_paper *p, const char *text, double size, bool bold, int bars) {
  char line[TP_PAPER_LINE];
  cairo_t *cr = p->cr;
  const double indent = bars > 0 ? 12 : 0, step = TP_LINE_HEIGHT * size;
  tp_figure_font(cr, size, bold);
  while (tp_paper_line(cr, line, &text, TP_PAPER_ROOM - indent)) {
    tp_paper_need(p, step);
    tp_figure_font(cr, size, bold);
    tp_figure_ink(cr, TP_INK_BLACK);
    tp_figure_text(cr, TP_PAPER_LEFT + indent, p->y + size, line);
    cairo_set_line_width(cr, 1.6);
    for (int k = 0; k < bars; k++) {
      cairo_move_to(cr, TP_PAPER_LEFT + 2 + 3 * k, p->y);
      cairo_line_to(cr, TP_PAPER_LEFT + 2 + 3 * k, p->y + step);
      cairo_stroke(cr);
    }
    p->y += step;
  }
  p->y += 4;
}

/* With `after` of what follows on the same page, and in the outline of the PDF. */
static void add_heading(tp_paper *p, const char *text, int level, double after) {
  const double sizes[] = {16, 12.5, 10.5}, size = sizes[level - 1];
  p->y += level == 1 ? 0 : level == 2 ? 12 : 7;
  tp_paper_need(p, size + after);
  if (p->pdf != NULL && level == 2) {
    char place[64];
    snprintf(place, sizeof place, "page=%d pos=[%.1f %.1f]", p->page, TP_PAPER_LEFT, p->y);
    (void)cairo_pdf_surface_add_outline(p->pdf, CAIRO_PDF_OUTLINE_ROOT, text, place, 0);
  }
  add_paragraph(p, text, size, true, 0);
  if (level != 2) return;
  cairo_set_line_width(p->cr, 0.6);
  cairo_move_to(p->cr, TP_PAPER_LEFT, p->y - 2);
  cairo_line_to(p->cr, TP_PAPER_LEFT + TP_PAPER_ROOM, p->y - 2);
  cairo_stroke(p->cr);
  p->y += 3;
}

static void draw_png(cairo_t *cr, cairo_surface_t *image) {
  cairo_set_source_surface(cr, image, 0, 0);
  cairo_paint(cr);
}

/* Of a PNG by its head, of a figure of our own; 0: neither is there. */
static void measure_figure(double *width, double *height, const tp_paper *p,
                           const tp_passage *passage) {
  const unsigned char *head = (const unsigned char *)passage->picture.png;
  *width = p->drawing->width;
  *height = p->drawing->height;
  if (head == NULL) return;
  uint32_t sides[2] = {0, 0};
  for (int k = 0; k < 8 && passage->picture.png_length >= 24; k++) {
    sides[k / 4] = sides[k / 4] << 8 | head[16 + k];
  }
  *width = sides[0];
  *height = sides[1];
}

/* As wide as the page, or as high as a share of it. */
static double figure_scale(double width, double height) {
  return fmin(TP_PAPER_ROOM / width, figure_share * TP_PAPER_HEIGHT / height);
}

static void add_figure(tp_paper *p, const tp_passage *passage) {
  double width = 0, height = 0;
  cairo_surface_t *image = NULL;
  measure_figure(&width, &height, p, passage);
  if (passage->picture.png != NULL) {
    image = tp_paper_png(passage->picture.png, passage->picture.png_length);
    if (cairo_surface_status(image) != CAIRO_STATUS_SUCCESS) p->why = cairo_surface_status(image);
  }
  if (width > 0 && height > 0 && (p->measured || !passage->fills)) {
    double scale = figure_scale(width, height);
    if (passage->fills) scale = fmin(scale, fmax(p->left, least_sketch) / height);
    tp_paper_need(p, smaller * scale * height + caption);
    scale = fmin(scale, (TP_PAPER_BOTTOM - p->y - caption) / height);
    cairo_save(p->cr);
    cairo_translate(p->cr, TP_PAPER_LEFT, p->y);
    cairo_scale(p->cr, scale, scale);
    if (image != NULL) {
      draw_png(p->cr, image);
    } else if (!p->drawing->draw(p->cr, p->drawing->context)) {
      p->why = CAIRO_STATUS_NO_MEMORY;
    }
    cairo_restore(p->cr);
    p->y += scale * height + 4;
  }
  if (image != NULL) cairo_surface_destroy(image);
  add_paragraph(p, passage->text, TP_BODY_SIZE, false, 0);
}

/* What a heading has below it on its page: some lines, a heading with its own, a whole figure. */
static double room_after(const tp_paper *p, const tp_passage *passage) {
  const tp_passage *next = passage + 1;
  double width = 0, height = 0;
  const bool last = next == p->document->passages + p->document->count;
  if (!last && next->kind == TP_PASSAGE_HEADING) return 1.4 * after_heading;
  if (last || next->kind != TP_PASSAGE_FIGURE) return after_heading;
  measure_figure(&width, &height, p, next);
  if (width <= 0 || height <= 0) return after_heading;
  return smaller * figure_scale(width, height) * height + 2 * caption;
}

/* An equation stands below the words that lead to it. */
static void keep_with_next(tp_paper *p, const tp_passage *passage) {
  enum { TOGETHER = 62 };
  const tp_passage *next = passage + 1;
  if (next == p->document->passages + p->document->count) return;
  if (next->kind == TP_PASSAGE_EQUATION) tp_paper_need(p, TOGETHER);
}

static void add_passage(tp_paper *p, const tp_passage *passage) {
  switch (passage->kind) {
  case TP_PASSAGE_HEADING:
    add_heading(p, passage->text, passage->level, room_after(p, passage));
    return;
  case TP_PASSAGE_PARAGRAPH:
    keep_with_next(p, passage);
    add_paragraph(p, passage->text, TEXT_SIZE, false, 0);
    return;
  case TP_PASSAGE_ANSWER:
    add_paragraph(p, passage->text, TEXT_SIZE + 0.5, true, 1);
    return;
  case TP_PASSAGE_CAUTION:
    add_paragraph(p, passage->text, TEXT_SIZE, false, 2);
    return;
  case TP_PASSAGE_EQUATION:
    tp_paper_add_equation(p, passage->text);
    return;
  case TP_PASSAGE_TABLE:
    tp_paper_add_table(p, passage);
    return;
  case TP_PASSAGE_FIGURE:
    add_figure(p, passage);
    return;
  case TP_PASSAGE_LISTING:
    tp_paper_add_listing(p, passage->text);
    return;
  case TP_PASSAGE_PAGE:
    tp_paper_begin_page(p);
    return;
  }
}

/* Draw all pages; how many there are. */
static int draw_all(tp_paper *p, cairo_surface_t *surface) {
  p->cr = cairo_create(surface);
  p->page = 1;
  p->y = TP_PAPER_TOP;
  tp_figure_set_up(p->cr);
  tp_paper_add_letterhead(p);
  add_heading(p, p->document->title, 1, after_heading);
  for (size_t k = 0; k < p->document->count; k++) add_passage(p, p->document->passages + k);
  tp_paper_end_page(p);
  const cairo_status_t status = cairo_status(p->cr);
  if (p->why == CAIRO_STATUS_SUCCESS) p->why = status;
  cairo_destroy(p->cr);
  return p->page;
}

static cairo_surface_t *open_pdf(tp_sink *sink) {
  cairo_surface_t *pdf =
      cairo_pdf_surface_create_for_stream(tp_sink_write, sink, TP_PAPER_WIDTH, TP_PAPER_HEIGHT);
  /* else the time of day, and no two files alike */
  cairo_pdf_surface_set_metadata(pdf, CAIRO_PDF_METADATA_CREATE_DATE, "2000-01-01T00:00:00Z");
  cairo_pdf_surface_set_metadata(pdf, CAIRO_PDF_METADATA_CREATOR, "topple " TP_VERSION);
  return pdf;
}

tp_status tp_paper_pdf(char **bytes, size_t *length, const tp_document *document,
                       const tp_vector_picture *drawing, tp_message *message) {
  if (document->failed) return tp_fail_memory(message, "the report");
  tp_sink sink = {0};
  tp_paper paper = {.document = document, .drawing = drawing};
  cairo_surface_t *dot = cairo_image_surface_create(CAIRO_FORMAT_RGB24, 1, 1);
  (void)draw_all(&paper, dot); /* how much room a sketch has */
  paper.pages = draw_all(&paper, dot);
  cairo_surface_destroy(dot);
  paper.pdf = open_pdf(&sink);
  draw_all(&paper, paper.pdf);
  cairo_surface_finish(paper.pdf);
  if (paper.why == CAIRO_STATUS_SUCCESS) paper.why = cairo_surface_status(paper.pdf);
  cairo_surface_destroy(paper.pdf);
  if (!sink.failed && paper.why == CAIRO_STATUS_SUCCESS) {
    *bytes = sink.bytes;
    *length = sink.length;
    return TP_OK;
  }
  free(sink.bytes);
  if (sink.failed || paper.why == CAIRO_STATUS_NO_MEMORY) {
    return tp_fail_memory(message, "the report");
  }
  return tp_fail(message, TP_DEPENDENCY_FAILED, (tp_place){"the report", 0, 0},
                 "it cannot be drawn: %s", cairo_status_to_string(paper.why));
}
