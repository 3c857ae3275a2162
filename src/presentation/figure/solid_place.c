/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Where a view of a solid lies on the page, and what every view from above has. */

#include "figure/solid.h"

#include <math.h>
#include <stdio.h>

static const double radian = 3.14159265358979323846 / 180;

const tp_solid_view tp_solid_from_above = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

tp_spot tp_solid_spot(const tp_solid_place *p, double east, double north, double up) {
  const double *r = p->view->right, *u = p->view->up;
  return (tp_spot){p->x + p->scale * (r[0] * east + r[1] * north + r[2] * up),
                   p->y - p->scale * (u[0] * east + u[1] * north + u[2] * up)};
}

tp_solid_place tp_solid_fit(const tp_solid_view *view, const tp_solid_picture *picture,
                            tp_box box) {
  tp_solid_place p = {
      .view = view,
      .scale = fmin((box.x1 - box.x0) / picture->width, (box.y1 - box.y0) / picture->height)};
  const double left = (box.x0 + box.x1 - p.scale * picture->width) / 2;
  const double top = (box.y0 + box.y1 - p.scale * picture->height) / 2;
  p.x = left - p.scale * picture->left;
  p.y = top + p.scale * picture->top;
  return p;
}

void tp_solid_paint(cairo_t *cr, const tp_solid_place *p, const tp_solid_picture *picture) {
  cairo_save(cr);
  cairo_translate(cr, p->x + p->scale * picture->left, p->y - p->scale * picture->top);
  cairo_scale(cr, p->scale / picture->dots, p->scale / picture->dots);
  cairo_set_source_surface(cr, picture->image, 0, 0);
  cairo_paint(cr);
  cairo_restore(cr);
}

void tp_solid_line(cairo_t *cr, tp_spot from, tp_spot to) {
  cairo_move_to(cr, from.x, from.y);
  cairo_line_to(cr, to.x, to.y);
  cairo_stroke(cr);
}

const char *tp_solid_say(const tp_solid_figure *f, char said[TP_LINE_SIZE], const char *english) {
  tp_text t = {0};
  tp_text_add(&t, "%s", english);
  tp_figure_tell_in(&t, f->language, f->comma);
  snprintf(said, TP_LINE_SIZE, "%s", t.failed || t.data == NULL ? english : t.data);
  tp_text_drop(&t);
  return said;
}

/* ---- from above --------------------------------------------------------------------------------
 */

static void draw_north(cairo_t *cr, tp_box box) {
  const tp_spot tip = {box.x1 - 10, box.y0 + 4}, tail = {box.x1 - 10, box.y0 + 26};
  tp_figure_ink(cr, TP_INK_BLACK);
  tp_figure_arrow(cr, tail, tip, 1);
  tp_figure_font(cr, TP_SMALL_SIZE, false);
  tp_figure_text(cr, tip.x - 2.4, tail.y + 8, "N");
}

/* A length that is round, about a quarter of the box. */
void tp_solid_draw_length(cairo_t *cr, const tp_solid_figure *f, const tp_solid_place *p,
                          tp_box box) {
  static const double round[] = {1, 2, 5, 10};
  const double wanted = (box.x1 - box.x0) / 4 / p->scale, power = pow(10, floor(log10(wanted)));
  double length = power;
  for (int k = 0; k < 4; k++) {
    if (round[k] * power <= wanted) length = round[k] * power;
  }
  char text[40], said[TP_LINE_SIZE];
  snprintf(text, sizeof text, "%g m", length);
  tp_figure_ink(cr, TP_INK_BLACK);
  cairo_set_line_width(cr, 1);
  tp_solid_line(cr, (tp_spot){box.x0 + 4, box.y1 - 6},
                (tp_spot){box.x0 + 4 + p->scale * length, box.y1 - 6});
  tp_figure_font(cr, TP_SMALL_SIZE, false);
  tp_figure_text(cr, box.x0 + 4, box.y1 - 10, tp_solid_say(f, said, text));
}

void tp_solid_draw_bearings(cairo_t *cr, const tp_solid_figure *f, const tp_solid_place *p,
                            tp_box box) {
  tp_figure_ink(cr, TP_INK_BLACK);
  cairo_set_line_width(cr, 0.9);
  tp_solid_line(cr, (tp_spot){p->x - 4, p->y}, (tp_spot){p->x + 4, p->y});
  tp_solid_line(cr, (tp_spot){p->x, p->y - 4}, (tp_spot){p->x, p->y + 4});
  if (f->has_way) {
    const double way = radian * f->azimuth_deg, far = 0.2 * fmin(box.x1 - box.x0, box.y1 - box.y0);
    tp_figure_arrow(cr, (tp_spot){p->x, p->y},
                    (tp_spot){p->x + far * sin(way), p->y - far * cos(way)}, 1);
  }
  draw_north(cr, box);
  tp_solid_draw_length(cr, f, p, box);
}
