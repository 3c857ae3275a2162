/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Logo and company on paper. A PNG is drawn dot by dot; the bytes of a JPEG go into the PDF as they
 * are, which Cairo does not decode. */

#include "figure/paper.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double highest = 44, widest = 150, gap = 10, letters = 12;

typedef struct source {
  const char *bytes;
  size_t left;
} source;

static cairo_status_t read_bytes(void *closure, unsigned char *data, unsigned int length) {
  source *own = closure;
  if (length > own->left) return CAIRO_STATUS_READ_ERROR;
  memcpy(data, own->bytes, length);
  own->bytes += length;
  own->left -= length;
  return CAIRO_STATUS_SUCCESS;
}

cairo_surface_t *tp_paper_png(const char *bytes, size_t length) {
  source from = {bytes, length};
  return cairo_image_surface_create_from_png_stream(read_bytes, &from);
}

static cairo_surface_t *jpeg_of(const tp_logo *logo) {
  cairo_surface_t *image =
      cairo_image_surface_create(CAIRO_FORMAT_RGB24, logo->width, logo->height);
  unsigned char *bytes = malloc(logo->length);
  if (bytes == NULL) return image;
  memcpy(bytes, logo->bytes, logo->length);
  if (cairo_surface_set_mime_data(image, CAIRO_MIME_TYPE_JPEG, bytes, logo->length, free, bytes) !=
      CAIRO_STATUS_SUCCESS) {
    free(bytes);
  }
  return image;
}

/* How wide it became. */
static double draw_logo(tp_paper *p, const tp_logo *logo) {
  cairo_surface_t *image =
      logo->kind == TP_LOGO_PNG ? tp_paper_png(logo->bytes, logo->length) : jpeg_of(logo);
  const double scale = fmin(highest / logo->height, widest / logo->width);
  if (cairo_surface_status(image) != CAIRO_STATUS_SUCCESS) {
    p->why = cairo_surface_status(image);
  } else {
    cairo_save(p->cr);
    cairo_translate(p->cr, TP_PAPER_LEFT, p->y);
    cairo_scale(p->cr, scale, scale);
    cairo_set_source_surface(p->cr, image, 0, 0);
    cairo_paint(p->cr);
    cairo_restore(p->cr);
  }
  cairo_surface_destroy(image);
  return scale * logo->width + gap;
}

void tp_paper_add_letterhead(tp_paper *p) {
  const tp_document *d = p->document;
  const bool drawn = d->logo.kind == TP_LOGO_PNG || d->logo.kind == TP_LOGO_JPEG;
  char line[TP_PAPER_LINE];
  if (!drawn && d->company == NULL) return;
  const double indent = drawn ? draw_logo(p, &d->logo) : 0;
  const char *company = d->company != NULL ? d->company : "";
  double y = p->y;
  tp_figure_font(p->cr, letters, true);
  tp_figure_ink(p->cr, TP_INK_BLACK);
  while (tp_paper_line(p->cr, line, &company, TP_PAPER_ROOM - indent)) {
    tp_figure_text(p->cr, TP_PAPER_LEFT + indent, y + letters, line);
    y += TP_LINE_HEIGHT * letters;
  }
  p->y = fmax(y, drawn ? p->y + highest : y) + gap;
}
