/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A solid on contacts: from the side and from above, with normals, the forces that hold it, and the
 * screw that begins; and the table of contacts. */

#include "figure/solid.h"

#include "report/solid_page.h"

#include <math.h>
#include <stdio.h>

static const double radian = 3.14159265358979323846 / 180;

/* What is listed, and which contacts bear their numbers. */
enum { LISTED = 16, NUMBERED = 16 };

/* ---- vectors in the frame of the base ----------------------------------------------------------
 */

static tp_spot spot_at(const tp_solid_place *p, const double at[3]) {
  return tp_solid_spot(p, at[0], at[1], at[2]);
}

static void draw_arrow(cairo_t *cr, const tp_solid_place *p, const double from[3],
                       const double to[3], double width) {
  tp_figure_arrow(cr, spot_at(p, from), spot_at(p, to), width);
}

/* ---- forces ------------------------------------------------------------------------------------
 */

double tp_solid_force_scale(const tp_solid_figure *f) {
  const tp_solid_contacts *c = &f->solid->contacts;
  double most = 1;
  for (size_t k = 0; k < c->contact_count; k++) {
    most = fmax(most, sqrt(tp_solid_dot(c->contacts[k].force, c->contacts[k].force)));
  }
  return 0.33 * f->mesh.size / most;
}

/* Weight and earthquake, from the centroid: against all forces where these hold it, else the
 * weight. */
static void draw_load(cairo_t *cr, const tp_solid_place *p, const tp_solid_figure *f) {
  const tp_solid_contacts *c = &f->solid->contacts;
  const double way = radian * f->azimuth_deg, centre[3] = {0, 0, f->mesh.height};
  double load[3] = {sin(f->tilt) * sin(way), sin(f->tilt) * cos(way), -cos(f->tilt)}, tip[3];
  if (tp_solid_is_held(c)) {
    double sum[3] = {0};
    for (size_t k = 0; k < c->contact_count; k++) tp_solid_go(sum, sum, -1, c->contacts[k].force);
    tp_solid_mesh_turn(load, &f->mesh, sum);
  }
  tp_solid_go(tip, centre, tp_solid_force_scale(f), load);
  const tp_spot spot = spot_at(p, centre);
  tp_figure_ink(cr, TP_INK_BLACK);
  draw_arrow(cr, p, centre, tip, 1.2);
  cairo_arc(cr, spot.x, spot.y, 2.4, 0, 360 * radian);
  cairo_fill(cr);
}

static void draw_dot(cairo_t *cr, tp_spot at, bool hidden, size_t number) {
  char text[24];
  cairo_arc(cr, at.x, at.y, 2.6, 0, 360 * radian);
  tp_figure_ink(cr, hidden ? TP_INK_WHITE : TP_INK_VERMILION);
  cairo_fill_preserve(cr);
  tp_figure_ink(cr, TP_INK_VERMILION);
  cairo_set_line_width(cr, 1);
  cairo_stroke(cr);
  if (number > NUMBERED) return;
  snprintf(text, sizeof text, "%zu", number);
  tp_figure_font(cr, TP_BODY_SIZE, true);
  tp_figure_ink(cr, TP_INK_BLACK);
  tp_figure_text(cr, at.x + 4, at.y - 3, text);
}

static void draw_contact(cairo_t *cr, const tp_solid_place *p, const tp_solid_figure *f, size_t k) {
  const tp_solid_contact *c = f->solid->contacts.contacts + k;
  double at[3], normal[3], force[3], end[3];
  tp_solid_mesh_place(at, &f->mesh, f->solid, c->at);
  tp_solid_mesh_turn(normal, &f->mesh, c->normal);
  tp_solid_mesh_turn(force, &f->mesh, c->force);
  tp_solid_go(end, at, 0.12 * f->mesh.size, normal);
  tp_figure_ink(cr, TP_INK_BLUE);
  draw_arrow(cr, p, at, end, 0.9);
  tp_solid_go(end, at, -tp_solid_force_scale(f), force);
  tp_figure_ink(cr, TP_INK_GREEN);
  if (tp_solid_dot(force, force) > 0) draw_arrow(cr, p, end, at, 1.4);
  draw_dot(cr, spot_at(p, at), tp_solid_dot(normal, p->view->eye) > 0, k + 1);
}

/* ---- the motion --------------------------------------------------------------------------------
 */

/* Two unit vectors across an axis. */
static void set_across(double first[3], double second[3], const double axis[3]) {
  int least = 0;
  for (int k = 1; k < 3; k++) {
    if (fabs(axis[k]) < fabs(axis[least])) least = k;
  }
  for (int k = 0; k < 3; k++) first[k] = (k == least) - axis[least] * axis[k];
  const double length = sqrt(tp_solid_dot(first, first));
  for (int k = 0; k < 3; k++) first[k] /= length;
  for (int k = 0; k < 3; k++) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    second[k] = axis[i] * first[j] - axis[j] * first[i];
  }
}

/* Three quarters of a circle about the axis, with the head of an arrow. */
static void draw_turn(cairo_t *cr, const tp_solid_place *p, const double middle[3],
                      const double axis[3], double radius) {
  enum { STEPS = 40 };
  double first[3], second[3], last[2][3];
  set_across(first, second, axis);
  for (int k = 0; k <= STEPS; k++) {
    const double turn = 270 * radian * k / STEPS;
    double *at = last[k % 2];
    tp_solid_go(at, middle, radius * cos(turn), first);
    tp_solid_go(at, at, radius * sin(turn), second);
    const tp_spot spot = spot_at(p, at);
    if (k == 0) cairo_move_to(cr, spot.x, spot.y);
    if (k > 0) cairo_line_to(cr, spot.x, spot.y);
  }
  cairo_set_line_width(cr, 1.2);
  cairo_stroke(cr);
  double head[3];
  tp_solid_go(head, last[STEPS % 2], 0.5 * radius, first);
  draw_arrow(cr, p, last[STEPS % 2], head, 1.2);
}

static void draw_motion(cairo_t *cr, const tp_solid_place *p, const tp_solid_figure *f) {
  static const double dashes[] = {7, 2, 1.5, 2};
  const tp_solid_contacts *c = &f->solid->contacts;
  const tp_solid_motion *m = c->has_motion ? &c->motion : &c->critical;
  const double size = f->mesh.size;
  double axis[3], at[3] = {0, 0, f->mesh.height}, ends[2][3];
  if (!c->has_motion && !c->has_critical) return;
  tp_solid_mesh_turn(axis, &f->mesh, m->axis);
  tp_figure_ink(cr, TP_INK_PURPLE);
  if (!m->turns) {
    tp_solid_go(ends[0], at, 0.4 * size, axis);
    draw_arrow(cr, p, at, ends[0], 1.6);
    return;
  }
  tp_solid_mesh_place(at, &f->mesh, f->solid, m->at);
  tp_solid_go(ends[0], at, -0.7 * size, axis);
  tp_solid_go(ends[1], at, 0.7 * size, axis);
  cairo_save(cr);
  cairo_set_dash(cr, dashes, 4, 0);
  cairo_set_line_width(cr, 1.2);
  tp_solid_line(cr, spot_at(p, ends[0]), spot_at(p, ends[1]));
  cairo_restore(cr);
  tp_solid_go(at, at, 0.5 * size, axis);
  draw_turn(cr, p, at, axis, 0.1 * size);
}

/* ---- views -------------------------------------------------------------------------------------
 */

static void draw_view(cairo_t *cr, const tp_solid_place *p, const tp_solid_figure *f,
                      const tp_solid_picture *picture) {
  tp_solid_paint(cr, p, picture);
  draw_motion(cr, p, f);
  draw_load(cr, p, f);
  for (size_t k = 0; k < f->solid->contacts.contact_count; k++) draw_contact(cr, p, f, k);
}

static void clip(cairo_t *cr, tp_box box) {
  cairo_rectangle(cr, box.x0, box.y0, box.x1 - box.x0, box.y1 - box.y0);
  cairo_clip(cr);
}

void tp_solid_draw_held(cairo_t *cr, const tp_solid_figure *f, tp_box box) {
  const tp_solid_place p = tp_solid_fit(
      &f->view, &f->side, (tp_box){box.x0 + 40, box.y0 + 20, box.x1 - 40, box.y1 - 40});
  cairo_save(cr);
  clip(cr, box);
  draw_view(cr, &p, f, &f->side);
  cairo_restore(cr);
}

void tp_solid_draw_held_above(cairo_t *cr, const tp_solid_figure *f, tp_box box) {
  const tp_solid_place p =
      tp_solid_fit(&tp_solid_from_above, &f->above,
                   (tp_box){box.x0 + 14, box.y0 + 20, box.x1 - 24, box.y1 - 30});
  cairo_save(cr);
  clip(cr, box);
  draw_view(cr, &p, f, &f->above);
  cairo_restore(cr);
  tp_solid_draw_bearings(cr, f, &p, box);
}

/* ---- the table ---------------------------------------------------------------------------------
 */

enum { COLUMNS = 4 };

double tp_solid_draw_contacts(cairo_t *cr, const tp_solid_figure *f, double x, double y,
                              double width) {
  static const char *const heads[COLUMNS] = {"Point", "Friction", "Normal force", "Shear force"};
  static const double at[COLUMNS] = {0, 0.22, 0.48, 0.74};
  const tp_solid_contacts *c = &f->solid->contacts;
  const int columns = tp_solid_is_held(c) ? COLUMNS : 2;
  char said[TP_LINE_SIZE];
  tp_figure_font(cr, TP_SMALL_SIZE, true);
  tp_figure_ink(cr, TP_INK_BLACK);
  for (int k = 0; k < columns; k++) {
    tp_figure_text(cr, x + at[k] * width, y + TP_SMALL_SIZE, tp_solid_say(f, said, heads[k]));
  }
  y += 1.6 * TP_SMALL_SIZE;
  tp_figure_font(cr, TP_SMALL_SIZE, false);
  for (size_t k = 0; k < c->contact_count && k < LISTED; k++) {
    const tp_contact_shares shares = tp_solid_contact_shares(c->contacts + k);
    char cells[COLUMNS][40];
    snprintf(cells[0], sizeof cells[0], "%zu", k + 1);
    snprintf(cells[1], sizeof cells[1], "%.4g°", c->contacts[k].friction_angle_deg);
    snprintf(cells[2], sizeof cells[2], "%.4f W", shares.across);
    snprintf(cells[3], sizeof cells[3], "%.4f W", shares.along);
    for (int n = 0; n < columns; n++) {
      tp_figure_text(cr, x + at[n] * width, y + TP_SMALL_SIZE, tp_solid_say(f, said, cells[n]));
    }
    y += 1.5 * TP_SMALL_SIZE;
  }
  return y;
}
