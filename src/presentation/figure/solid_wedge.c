/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A wedge from its face, with the edges that it hides. */

#include "figure/solid.h"
#include "solid_tilt/wedge_shape.h"

#include <math.h>
#include <string.h>

#define ELEVATION 0.45 /* of the eye, radians */
#define ASIDE 0.35     /* from straight before the face, radians */

static const double radian = 3.14159265358979323846 / 180;

/* Of a face: its corners in a round. */
typedef struct face {
  int count, corners[4];
} face;

static const face on_face = {3, {TP_WEDGE_TOE, TP_WEDGE_END_A, TP_WEDGE_END_B}};
static const face on_ground = {4,
                               {TP_WEDGE_END_A, TP_WEDGE_END_B, TP_WEDGE_BACK_B, TP_WEDGE_BACK_A}};

/* From before the face, a little to one side and from above. */
static tp_solid_view view_of(const tp_solid_wedge *w) {
  const double way = radian * w->sides[TP_WEDGE_FACE].dip_direction_deg + ASIDE;
  const double c = cos(ELEVATION), s = sin(ELEVATION);
  return (tp_solid_view){
      {-cos(way), sin(way), 0}, {-s * sin(way), -s * cos(way), c}, {c * sin(way), c * cos(way), s}};
}

static tp_spot spot_of(const tp_solid_place *p, const tp_solid_wedge *w, int corner) {
  const tp_wedge_corner *own = w->corners + corner;
  return tp_solid_spot(p, own->east_m, own->north_m, own->up_m);
}

static tp_solid_place fit(const tp_solid_view *view, const tp_solid_wedge *w, tp_box box) {
  tp_solid_place p = {.view = view, .scale = 1};
  tp_box own = {INFINITY, INFINITY, -INFINITY, -INFINITY};
  for (int k = 0; k < TP_WEDGE_POINTS; k++) {
    const tp_spot at = spot_of(&p, w, k);
    own = (tp_box){fmin(own.x0, at.x), fmin(own.y0, at.y), fmax(own.x1, at.x), fmax(own.y1, at.y)};
  }
  p.scale = fmin((box.x1 - box.x0) / (own.x1 - own.x0), (box.y1 - box.y0) / (own.y1 - own.y0));
  p.x = (box.x0 + box.x1 - p.scale * (own.x0 + own.x1)) / 2;
  p.y = (box.y0 + box.y1 - p.scale * (own.y0 + own.y1)) / 2;
  return p;
}

static void trace(cairo_t *cr, const tp_solid_place *p, const tp_solid_wedge *w, const face *own) {
  for (int k = 0; k < own->count; k++) {
    const tp_spot at = spot_of(p, w, own->corners[k]);
    if (k == 0) cairo_move_to(cr, at.x, at.y);
    if (k > 0) cairo_line_to(cr, at.x, at.y);
  }
  cairo_close_path(cr);
}

/* The name of a joint beside its trace on the face, away from the other one. */
static void name(cairo_t *cr, const tp_solid_place *p, const tp_solid_wedge *w, int joint) {
  const tp_spot toe = spot_of(p, w, TP_WEDGE_TOE),
                end = spot_of(p, w, joint == 0 ? TP_WEDGE_END_A : TP_WEDGE_END_B);
  const tp_spot other = spot_of(p, w, joint == 0 ? TP_WEDGE_END_B : TP_WEDGE_END_A);
  const tp_spot middle = {(toe.x + end.x) / 2, (toe.y + end.y) / 2};
  const double side = middle.x < (toe.x + other.x) / 2 ? -9 : 9;
  tp_figure_font(cr, TP_TITLE_SIZE, true);
  tp_figure_ink(cr, TP_INK_BLUE);
  tp_figure_text_in(cr, (tp_box){middle.x + side, middle.y, middle.x + side, middle.y},
                    joint == 0 ? "A" : "B");
}

/* What the wedge hides: the line of both joints, and the foot of a crack. */
static void draw_hidden(cairo_t *cr, const tp_solid_place *p, const tp_solid_wedge *w) {
  static const double dashes[] = {3, 2};
  const tp_spot deep = spot_of(p, w, TP_WEDGE_DEEP);
  cairo_save(cr);
  cairo_set_dash(cr, dashes, 2, 0);
  tp_figure_ink(cr, TP_INK_BLUE);
  cairo_set_line_width(cr, 0.9);
  tp_solid_line(cr, spot_of(p, w, TP_WEDGE_TOE), deep);
  if (w->has_crack) {
    tp_solid_line(cr, spot_of(p, w, TP_WEDGE_BACK_A), deep);
    tp_solid_line(cr, spot_of(p, w, TP_WEDGE_BACK_B), deep);
  }
  cairo_restore(cr);
}

/* From the toe down the line of both joints. */
static void draw_way(cairo_t *cr, const tp_solid_place *p, const tp_solid_wedge *w) {
  const double far = w->driving_n.value < 0 ? -32 : 32; /* or up it */
  const tp_spot toe = spot_of(p, w, TP_WEDGE_TOE), deep = spot_of(p, w, TP_WEDGE_DEEP);
  const double length = hypot(toe.x - deep.x, toe.y - deep.y);
  if (strcmp(w->slides_on, "a and b") != 0 || !(length > 0)) return;
  tp_figure_ink(cr, TP_INK_VERMILION);
  tp_figure_arrow(
      cr, toe,
      (tp_spot){toe.x + far * (toe.x - deep.x) / length, toe.y + far * (toe.y - deep.y) / length},
      1.6);
}

static void draw_face(cairo_t *cr, const tp_solid_place *p, const tp_solid_wedge *w,
                      const face *own, tp_ink ink) {
  trace(cr, p, w, own);
  tp_figure_ink(cr, ink);
  cairo_fill_preserve(cr);
  tp_figure_ink(cr, TP_INK_BLACK);
  cairo_set_line_width(cr, 1.2);
  cairo_stroke(cr);
}

void tp_solid_draw_wedge(cairo_t *cr, const tp_solid_figure *f, tp_box box) {
  const tp_solid_wedge *w = &f->solid->wedge;
  const tp_solid_view view = view_of(w);
  const tp_solid_place p =
      fit(&view, w, (tp_box){box.x0 + 20, box.y0 + 12, box.x1 - 20, box.y1 - 50});
  draw_face(cr, &p, w, &on_ground, TP_INK_ROCK);
  draw_face(cr, &p, w, &on_face, TP_INK_BLOCK);
  draw_hidden(cr, &p, w);
  for (int joint = 0; joint < 2; joint++) name(cr, &p, w, joint);
  draw_way(cr, &p, w);
  tp_solid_draw_length(cr, f, &p, box);
}
