/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The rose: the tilt at which the solid topples towards each azimuth, as a distance from the
 * middle, with the friction angle as a circle and the scene's tilt as a point; and the table of
 * bands. */

#include "figure/solid.h"

#include "number/shortest.h"
#include "terms/names.h"

#include <math.h>
#include <stdio.h>

static const double radian = 3.14159265358979323846 / 180;

typedef struct polar {
  const tp_solid_figure *figure;
  cairo_t *cr;
  double x, y, scale; /* points to a degree */
  double most;        /* the outermost circle, degrees */
} polar;

static tp_spot spot_at(const polar *p, double azimuth_deg, double degrees) {
  const double reach = p->scale * degrees;
  return (tp_spot){p->x + reach * sin(radian * azimuth_deg),
                   p->y - reach * cos(radian * azimuth_deg)};
}

/* ---- circles -----------------------------------------------------------------------------------
 */

/* Of four to eight circles at round angles the outermost holds all that is drawn. */
static double find_step(double most) {
  static const double steps[] = {0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 15, 20};
  for (size_t k = 0; k < sizeof steps / sizeof steps[0]; k++) {
    if (most <= 6 * steps[k]) return steps[k];
  }
  return 20;
}

static double find_most(const tp_solid_figure *f) {
  const tp_solid *solid = f->solid;
  double most = f->band != NULL && solid->has_friction ? solid->friction_angle_deg : 0;
  for (size_t k = 0; k < solid->band_count; k++) {
    for (size_t n = 0; n < solid->bands[k].rose_count; n++) {
      most = fmax(most, solid->bands[k].rose[n].toppling_deg.value);
    }
  }
  for (size_t k = 0; k < solid->contacts.way_count; k++) {
    const tp_solid_way *way = solid->contacts.ways + k;
    if (way->has_critical) most = fmax(most, way->critical_deg.value);
  }
  return most > 0 ? most : 1;
}

static void draw_circles(const polar *p, double step) {
  static const char *const names[] = {"N", "90°", "180°", "270°"};
  char text[40], said[TP_LINE_SIZE];
  tp_figure_font(p->cr, TP_SMALL_SIZE, false);
  for (double at = step; at <= p->most * (1 + 1e-9); at += step) {
    tp_figure_ink(p->cr, TP_INK_ROCK);
    cairo_set_line_width(p->cr, 0.7);
    cairo_arc(p->cr, p->x, p->y, p->scale * at, 0, 360 * radian);
    cairo_stroke(p->cr);
  }
  for (int k = 0; k < 12; k++) {
    const tp_spot end = spot_at(p, 30.0 * k, p->most);
    cairo_move_to(p->cr, p->x, p->y);
    cairo_line_to(p->cr, end.x, end.y);
    cairo_stroke(p->cr);
  }
  tp_figure_ink(p->cr, TP_INK_GREY);
  for (int k = 0; k < 4; k++) {
    const tp_spot at = spot_at(p, 90.0 * k, p->most + (k % 2 == 1 ? 10 : 7) / p->scale);
    tp_figure_text_in(p->cr, (tp_box){at.x, at.y, at.x, at.y}, names[k]);
  }
  for (double at = step; at <= p->most * (1 + 1e-9); at += step) {
    const tp_spot label = spot_at(p, 15, at);
    snprintf(text, sizeof text, "%g°", at);
    tp_figure_text(p->cr, label.x + 1, label.y - 1, tp_solid_say(p->figure, said, text));
  }
}

/* ---- what is drawn -----------------------------------------------------------------------------
 */

static void draw_band(const polar *p, const tp_solid_band *band, tp_ink ink, bool governs) {
  if (band->rose_count == 0) return;
  for (size_t k = 0; k < band->rose_count; k++) {
    const tp_spot at = spot_at(p, band->rose[k].azimuth_deg, band->rose[k].toppling_deg.value);
    if (k == 0) cairo_move_to(p->cr, at.x, at.y);
    if (k > 0) cairo_line_to(p->cr, at.x, at.y);
  }
  cairo_close_path(p->cr);
  tp_figure_ink(p->cr, ink);
  cairo_set_line_width(p->cr, governs ? 1.6 : 1);
  cairo_stroke(p->cr);
}

/* Up to which forces hold it on its contacts; where they do at any tilt there is no line. */
static void draw_ways(const polar *p, const tp_solid_contacts *contacts) {
  bool goes_on = false;
  for (size_t k = 0; k <= contacts->way_count && contacts->way_count > 0; k++) {
    const tp_solid_way *way = contacts->ways + k % contacts->way_count;
    const tp_spot at = spot_at(p, way->azimuth_deg, way->critical_deg.value);
    if (way->has_critical && goes_on) cairo_line_to(p->cr, at.x, at.y);
    if (way->has_critical && !goes_on) cairo_move_to(p->cr, at.x, at.y);
    goes_on = way->has_critical;
  }
  tp_figure_ink(p->cr, TP_INK_VERMILION);
  cairo_set_line_width(p->cr, 1.6);
  cairo_stroke(p->cr);
}

static void draw_friction(const polar *p, const tp_solid *solid) {
  static const double dashes[] = {3, 2};
  char text[60], angle[TP_SHORTEST_SIZE], said[TP_LINE_SIZE];
  if (p->figure->band == NULL || !solid->has_friction) return;
  cairo_save(p->cr);
  cairo_set_dash(p->cr, dashes, 2, 0);
  tp_figure_ink(p->cr, TP_INK_BLACK);
  cairo_set_line_width(p->cr, 0.9);
  cairo_arc(p->cr, p->x, p->y, p->scale * solid->friction_angle_deg, 0, 360 * radian);
  cairo_stroke(p->cr);
  cairo_restore(p->cr);
  const tp_spot at = spot_at(p, 315, solid->friction_angle_deg);
  snprintf(text, sizeof text, "slides: φ %s°", tp_shortest(angle, solid->friction_angle_deg));
  tp_figure_font(p->cr, TP_SMALL_SIZE, false);
  tp_solid_say(p->figure, said, text);
  tp_figure_text(p->cr, at.x - tp_figure_text_width(p->cr, said) - 2, at.y - 2, said);
}

/* The scene's tilt; towards any azimuth it is a circle. */
static void draw_tilt(const polar *p, const tp_solid *solid) {
  char said[TP_LINE_SIZE];
  if (!solid->has_tilt_angle || solid->tilt_angle_deg > p->most) return;
  tp_figure_ink(p->cr, TP_INK_BLACK);
  if (!solid->has_tilt_azimuth) {
    cairo_set_line_width(p->cr, 1.6);
    cairo_arc(p->cr, p->x, p->y, p->scale * solid->tilt_angle_deg, 0, 360 * radian);
    cairo_stroke(p->cr);
    return;
  }
  const tp_spot at = spot_at(p, solid->tilt_azimuth_deg, solid->tilt_angle_deg);
  cairo_arc(p->cr, at.x, at.y, 2.8, 0, 360 * radian);
  cairo_fill(p->cr);
  tp_figure_font(p->cr, TP_SMALL_SIZE, true);
  tp_figure_text(p->cr, at.x + 4, at.y + 2.4, tp_solid_say(p->figure, said, "as it lies"));
}

void tp_solid_draw_rose(cairo_t *cr, const tp_solid_figure *f, tp_box box) {
  const tp_solid *solid = f->solid;
  const double step = find_step(find_most(f));
  const double most = step * ceil(find_most(f) / step);
  const double radius = fmin(box.x1 - box.x0, box.y1 - box.y0) / 2 - 14;
  const polar p = {f, cr, (box.x0 + box.x1) / 2, (box.y0 + box.y1) / 2, radius / most, most};
  draw_circles(&p, step);
  draw_friction(&p, solid);
  for (size_t k = solid->band_count; k > 0; k--) {
    if (k > TP_SOLID_BANDS_DRAWN) continue;
    draw_band(&p, solid->bands + k - 1, tp_solid_band_ink(k - 1), solid->bands + k - 1 == f->band);
  }
  draw_ways(&p, &solid->contacts);
  draw_tilt(&p, solid);
}

/* ---- the table ---------------------------------------------------------------------------------
 */

enum { COLUMNS = 5 };

static void tell_band(char cells[COLUMNS][48], const tp_solid *solid, const tp_solid_band *band) {
  char n[TP_NUMBER_SIZE], band_text[TP_SHORTEST_SIZE];
  for (int k = 0; k < COLUMNS; k++) cells[k][0] = '\0';
  snprintf(cells[0], sizeof cells[0], "%s %s", tp_shortest(band_text, band->band),
           solid->length_unit);
  if (band->stands) {
    snprintf(cells[1], sizeof cells[1], "%s°", tp_text_significant(n, band->least.tilt_deg, 5));
    snprintf(cells[2], sizeof cells[2], "%.0f°", band->least.azimuth_deg.value);
  } else {
    snprintf(cells[1], sizeof cells[1], "falls");
  }
  if (!band->has_stance) return;
  snprintf(cells[3], sizeof cells[3], "%s", tp_mechanism_name(band->stance.verdict));
  if (band->stance.has_fos) {
    snprintf(cells[4], sizeof cells[4], "%s", tp_text_significant_down(n, band->stance.fos, 4));
  }
}

static void draw_ink(cairo_t *cr, double x, double y, double width, size_t band) {
  tp_figure_ink(cr, tp_solid_band_ink(band));
  cairo_rectangle(cr, x, y + 2, width, 3);
  cairo_fill(cr);
  tp_figure_ink(cr, TP_INK_BLACK);
}

double tp_solid_draw_key(cairo_t *cr, const tp_solid_figure *f, double x, double y) {
  const tp_solid *solid = f->solid;
  char cells[COLUMNS][48], said[TP_LINE_SIZE];
  tp_figure_font(cr, TP_SMALL_SIZE, false);
  for (size_t k = 0; k < solid->band_count && k < TP_SOLID_BANDS_DRAWN; k++) {
    tell_band(cells, solid, solid->bands + k);
    draw_ink(cr, x, y, 12, k);
    tp_figure_text(cr, x + 16, y + TP_SMALL_SIZE, tp_solid_say(f, said, cells[0]));
    x += 30 + tp_figure_text_width(cr, said);
  }
  return y + 1.5 * TP_SMALL_SIZE;
}

double tp_solid_draw_bands(cairo_t *cr, const tp_solid_figure *f, double x, double y,
                           double width) {
  static const char *const heads[COLUMNS] = {"Band", "Least tilt", "Azimuth", "At its tilt",
                                             "Factor"};
  static const double at[COLUMNS] = {0.06, 0.27, 0.48, 0.64, 0.87};
  const tp_solid *solid = f->solid;
  char cells[COLUMNS][48], said[TP_LINE_SIZE];
  tp_figure_font(cr, TP_SMALL_SIZE, true);
  tp_figure_ink(cr, TP_INK_BLACK);
  for (int k = 0; k < (solid->of_scene ? COLUMNS : 3); k++) {
    const char *head = k == 0 && solid->has_below ? "Below" : heads[k];
    tp_figure_text(cr, x + at[k] * width, y + TP_SMALL_SIZE, tp_solid_say(f, said, head));
  }
  y += 1.6 * TP_SMALL_SIZE;
  tp_figure_font(cr, TP_SMALL_SIZE, false);
  for (size_t k = 0; k < solid->band_count && k < TP_SOLID_BANDS_DRAWN; k++) {
    tell_band(cells, solid, solid->bands + k);
    draw_ink(cr, x, y, 0.045 * width, k);
    for (int n = 0; n < COLUMNS; n++) {
      tp_figure_text(cr, x + at[n] * width, y + TP_SMALL_SIZE, tp_solid_say(f, said, cells[n]));
    }
    y += 1.5 * TP_SMALL_SIZE;
  }
  return y;
}
