/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The planes of a wedge in the lower hemisphere, equal-angle (Goodman, Methods of Geological
 * Engineering, 1976): a direction d east, north and down is at (d_e, d_n) / (1 + d_down) of the
 * radius, so that cones are circles.
 *
 * On both joints of the upward normals a and b, with friction alone, the resultant R is borne where
 *     R = -A a - B b + T s,  T <= A tan(phi_a) + B tan(phi_b),  A, B >= 0,
 * with s down their line: on the near side of the plane of both s sin(phi) - n cos(phi), which are
 * the points of the cones towards s. */

#include "figure/solid.h"
#include "solid_tilt/wedge_shape.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { EAST, NORTH, UP };

static const double radian = 3.14159265358979323846 / 180;

typedef struct net {
  cairo_t *cr;
  double x, y, radius;
} net;

/* ---- directions --------------------------------------------------------------------------------
 */

static void set_down(double way[3], double plunge_deg, double trend_deg) {
  way[EAST] = cos(radian * plunge_deg) * sin(radian * trend_deg);
  way[NORTH] = cos(radian * plunge_deg) * cos(radian * trend_deg);
  way[UP] = -sin(radian * plunge_deg);
}

/* Upwards: the other way of what plunges across the plane. */
static void set_normal(double normal[3], const tp_wedge_side *side) {
  set_down(normal, 90 - side->dip_deg, side->dip_direction_deg + 180);
  for (int k = 0; k < 3; k++) normal[k] = -normal[k];
}

/* p a + q b */
static void combine(double sum[3], double p, const double a[3], double q, const double b[3]) {
  for (int k = 0; k < 3; k++) sum[k] = p * a[k] + q * b[k];
}

static double length_of(const double a[3]) {
  return sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
}

/* ---- on the net --------------------------------------------------------------------------------
 */

/* Of a vector of any length; one that points upwards is beyond the rim. */
static tp_spot spot_of(const net *n, const double way[3]) {
  const double share = n->radius / (length_of(way) - way[UP]);
  return (tp_spot){n->x + share * way[EAST], n->y - share * way[NORTH]};
}

/* Through a cos(t) + b sin(t) + c, between two angles, as a path within the hemisphere. */
static void trace(const net *n, const double a[3], const double b[3], const double c[3],
                  const double from_to[2]) {
  enum { STEPS = 180 };
  bool within = false;
  for (int k = 0; k <= STEPS; k++) {
    const double t = radian * (from_to[0] + (from_to[1] - from_to[0]) * k / STEPS);
    double way[3];
    combine(way, cos(t), a, sin(t), b);
    combine(way, 1, way, 1, c);
    const bool below = way[UP] <= 1e-9 * length_of(way);
    const tp_spot at = spot_of(n, way);
    if (below && within) cairo_line_to(n->cr, at.x, at.y);
    if (below && !within) cairo_move_to(n->cr, at.x, at.y);
    within = below;
  }
}

static void draw_plane(const net *n, const tp_wedge_side *side) {
  static const double none[3] = {0}, half[2] = {0, 180};
  double strike[3], down[3];
  set_down(strike, 0, side->dip_direction_deg - 90);
  set_down(down, side->dip_deg, side->dip_direction_deg);
  trace(n, strike, down, none, half);
  cairo_stroke(n->cr);
}

/* About the pole of a joint, of the half-angle φ. */
static void draw_cone(const net *n, const tp_wedge_side *side) {
  static const double round[2] = {0, 360};
  const double wide = tan(radian * side->friction_angle_deg);
  double pole[3], strike[3], down[3];
  set_normal(pole, side);
  combine(pole, -1, pole, 0, pole);
  set_down(strike, 0, side->dip_direction_deg - 90);
  set_down(down, side->dip_deg, side->dip_direction_deg);
  combine(strike, wide, strike, 0, strike);
  combine(down, wide, down, 0, down);
  trace(n, strike, down, pole, round);
  cairo_stroke(n->cr);
}

/* Between the points of both cones towards the line of the joints. */
static void draw_limit(const net *n, const tp_solid_wedge *w) {
  static const double none[3] = {0}, quarter[2] = {0, 90};
  double line[3], points[2][3];
  set_down(line, w->plunge_deg.value, w->trend_deg.value);
  for (int k = 0; k < 2; k++) {
    const double phi = radian * w->sides[k].friction_angle_deg;
    set_normal(points[k], w->sides + k);
    combine(points[k], -cos(phi), points[k], sin(phi), line);
  }
  trace(n, points[0], points[1], none, quarter);
  cairo_stroke(n->cr);
}

/* ---- the resultant -----------------------------------------------------------------------------
 */

/* Weight downwards, with an earthquake, and the water's pressure into the wedge, in kilonewtons. */
static void set_resultant(double sum[3], const tp_solid *solid) {
  const tp_solid_wedge *w = &solid->wedge;
  const tp_wedge_corner *deep = w->corners + TP_WEDGE_DEEP;
  const double weight = solid->weight_n.value / 1e3;
  const double way = radian * w->azimuth_deg;
  const double along = solid->seismic_horizontal * weight;
  const double down[3] = {along * sin(way), along * cos(way),
                          -weight * (1 - solid->seismic_vertical)};
  double normal[3];
  memcpy(sum, down, sizeof down);
  for (size_t k = 0; k < w->bolt_count; k++) {
    double pull[3];
    set_down(pull, w->bolts[k].dip_deg, w->bolts[k].azimuth_deg);
    combine(sum, 1, sum, w->bolts[k].force_n.value / 1e3, pull);
  }
  if (!w->has_water) return;
  for (int k = 0; k < 2; k++) {
    set_normal(normal, w->sides + k);
    combine(sum, 1, sum, w->water_kpa.value * w->areas_m2[k].value, normal);
  }
  if (!w->has_crack) return;
  set_normal(normal, w->sides + TP_WEDGE_CRACK);
  const double height =
      normal[EAST] * deep->east_m + normal[NORTH] * deep->north_m + normal[UP] * deep->up_m;
  const double push = w->water_kpa.value * w->crack_area_m2.value;
  combine(sum, 1, sum, height > 0 ? -push : push, normal);
}

static void draw_point(const net *n, const double way[3], tp_ink ink, const char *label) {
  const tp_spot at = spot_of(n, way);
  tp_figure_ink(n->cr, ink);
  cairo_arc(n->cr, at.x, at.y, 2.8, 0, 360 * radian);
  cairo_fill(n->cr);
  tp_figure_font(n->cr, TP_BODY_SIZE, true);
  tp_figure_text(n->cr, at.x + 4, at.y - 3, label);
}

/* The pull of a bolt: hollow, and from the other side, where it goes upwards. */
static void draw_bolt(const net *n, const tp_solid_figure *f, const tp_wedge_bolt *bolt) {
  char said[TP_LINE_SIZE], label[TP_LINE_SIZE + 32];
  double way[3];
  set_down(way, bolt->dip_deg, bolt->azimuth_deg);
  const bool upwards = way[UP] > 0;
  if (upwards) combine(way, -1, way, 0, way);
  const tp_spot at = spot_of(n, way);
  tp_figure_ink(n->cr, TP_INK_VERMILION);
  cairo_set_line_width(n->cr, 1.2);
  cairo_new_sub_path(n->cr);
  cairo_arc(n->cr, at.x, at.y, 2.8, 0, 360 * radian);
  if (upwards) cairo_stroke(n->cr);
  if (!upwards) cairo_fill(n->cr);
  snprintf(label, sizeof label, "%s %.4g kN", tp_solid_say(f, said, "bolt"),
           bolt->force_n.value / 1e3);
  tp_figure_font(n->cr, TP_SMALL_SIZE, true);
  tp_figure_text(n->cr, at.x + 4, at.y + (upwards ? 9 : -3), label);
}

/* ---- all ---------------------------------------------------------------------------------------
 */

static void draw_rim(const net *n) {
  static const char *const names[] = {"N", "90°", "180°", "270°"};
  tp_figure_ink(n->cr, TP_INK_GREY);
  cairo_set_line_width(n->cr, 0.9);
  cairo_arc(n->cr, n->x, n->y, n->radius, 0, 360 * radian);
  cairo_stroke(n->cr);
  for (int k = 0; k < 36; k++) {
    const double way = 10 * radian * k, tick = k % 9 == 0 ? 5 : 3;
    tp_solid_line(
        n->cr, (tp_spot){n->x + n->radius * sin(way), n->y - n->radius * cos(way)},
        (tp_spot){n->x + (n->radius - tick) * sin(way), n->y - (n->radius - tick) * cos(way)});
  }
  tp_figure_font(n->cr, TP_SMALL_SIZE, false);
  for (int k = 0; k < 4; k++) {
    const double way = 90 * radian * k, far = n->radius + (k % 2 == 1 ? 11 : 7);
    const tp_spot at = {n->x + far * sin(way), n->y - far * cos(way)};
    tp_figure_text_in(n->cr, (tp_box){at.x, at.y, at.x, at.y}, names[k]);
  }
}

/* Its name, near one of its ends. */
static void draw_side(const net *n, const tp_wedge_side *side, tp_ink ink, double width,
                      const char *name) {
  const double near_end = 25 * radian;
  double down[3], strike[3];
  tp_figure_ink(n->cr, ink);
  cairo_set_line_width(n->cr, width);
  draw_plane(n, side);
  set_down(strike, 0, side->dip_direction_deg - 90);
  set_down(down, side->dip_deg, side->dip_direction_deg);
  combine(down, sin(near_end), down, cos(near_end), strike);
  const tp_spot at = spot_of(n, down);
  tp_figure_font(n->cr, TP_SMALL_SIZE, true);
  tp_figure_text(n->cr, at.x + 2, at.y - 2, name);
}

void tp_solid_draw_stereonet(cairo_t *cr, const tp_solid_figure *f, tp_box box) {
  static const char *const names[] = {"A", "B", "face", "ground", "crack"};
  static const double dashes[] = {3, 2};
  const tp_solid_wedge *w = &f->solid->wedge;
  const double radius = fmin(box.x1 - box.x0, box.y1 - box.y0) / 2 - 20;
  const net n = {cr, (box.x0 + box.x1) / 2, (box.y0 + box.y1) / 2, radius};
  char said[TP_LINE_SIZE];
  double line[3], resultant[3];
  draw_rim(&n);
  for (int k = TP_WEDGE_FACE; k < (w->has_crack ? TP_WEDGE_PLANES : TP_WEDGE_CRACK); k++) {
    draw_side(&n, w->sides + k, TP_INK_GREY, 0.9, tp_solid_say(f, said, names[k]));
  }
  for (int k = 0; k < 2; k++) draw_side(&n, w->sides + k, TP_INK_BLUE, 1.3, names[k]);
  cairo_save(cr);
  cairo_set_dash(cr, dashes, 2, 0);
  tp_figure_ink(cr, TP_INK_GREEN);
  cairo_set_line_width(cr, 1);
  for (int k = 0; k < 2; k++) draw_cone(&n, w->sides + k);
  cairo_restore(cr);
  tp_figure_ink(cr, TP_INK_GREEN);
  cairo_set_line_width(cr, 2);
  draw_limit(&n, w);
  set_down(line, w->plunge_deg.value, w->trend_deg.value);
  draw_point(&n, line, TP_INK_BLUE, "I");
  set_resultant(resultant, f->solid);
  draw_point(&n, resultant, TP_INK_VERMILION, "R");
  for (size_t k = 0; k < w->bolt_count; k++) draw_bolt(&n, f, w->bolts + k);
}
