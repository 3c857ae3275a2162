/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Texts as elements of SVG, each as wide as it was measured: another font keeps the layout. */

#include "figure/kept_texts.h"

#include "output/encode.h"

#include <math.h>

static const cairo_user_data_key_t key_of_texts = {0};

cairo_status_t tp_kept_texts_begin(cairo_surface_t *surface, tp_text *texts) {
  return cairo_surface_set_user_data(surface, &key_of_texts, texts, NULL);
}

static void add_ink(tp_text *t, cairo_t *cr) {
  double red, green, blue, alpha;
  const double full = 255;
  if (cairo_pattern_get_rgba(cairo_get_source(cr), &red, &green, &blue, &alpha) !=
      CAIRO_STATUS_SUCCESS) {
    red = green = blue = 0;
  }
  tp_text_add(t, " style=\"fill:#%02x%02x%02x", (unsigned)lround(full * red),
              (unsigned)lround(full * green), (unsigned)lround(full * blue));
}

bool tp_kept_texts_add(cairo_t *cr, double x, double y, const char *text) {
  tp_text *own = cairo_surface_get_user_data(cairo_get_target(cr), &key_of_texts);
  cairo_matrix_t font, page;
  cairo_text_extents_t extents;
  cairo_get_matrix(cr, &page);
  if (own == NULL || page.xy != 0 || page.yx != 0) return false;
  cairo_get_font_matrix(cr, &font);
  cairo_text_extents(cr, text, &extents);
  cairo_user_to_device(cr, &x, &y);
  tp_text_add(own, "<text x=\"%.2f\" y=\"%.2f\" textLength=\"%.2f\"", x, y,
              page.xx * extents.x_advance);
  add_ink(own, cr);
  tp_text_add(own, "%s;font-size:%.4gpx\">",
              cairo_toy_font_face_get_weight(cairo_get_font_face(cr)) == CAIRO_FONT_WEIGHT_BOLD
                  ? ";font-weight:bold"
                  : "",
              page.xx * font.xx);
  tp_encode_html(own, text);
  tp_text_add(own, "</text>\n");
  return true;
}
