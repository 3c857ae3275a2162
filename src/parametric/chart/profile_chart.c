/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A profile as a chart of four panels: its course, the facets coloured by their slope; the
 * structure function; the spectrum in bands; the rose of its slopes, shares of the length by angle.
 * Of a long profile the course is drawn through every so many points, and the table has those. */

#include "chart/chart.h"
#include "common/host.h"
#include "roughness/bands.h"

#include <float.h>
#include <math.h>
#include <stdio.h>

enum { MOST_DRAWN = 4000, CLASSES = 5, SECTORS = 36, ARC_STEPS = 3 };

static const char *const keys[] = {"quantity", NULL};
static const char *const notes[] = {"angle_deg", "share", NULL};
static const double degrees = 57.295779513082323, widest_deg = 90;

/* Slopes by their angle: where a class ends, its colour, and what the legend says. */
static const struct slope_class {
  double to_deg;
  tp_chart_colour colour;
  const char *text;
} classes[CLASSES] = {{-15, TP_COLOUR_VERMILLION, "falls at more than 15°"},
                      {-5, TP_COLOUR_ORANGE, "falls at 5° to 15°"},
                      {5, TP_COLOUR_GREY, "within 5° of level"},
                      {15, TP_COLOUR_SKY_BLUE, "rises at 5° to 15°"},
                      {90, TP_COLOUR_BLUE, "rises at more than 15°"}};

static size_t class_of(double angle_deg) {
  size_t k = 0;
  while (k + 1 < CLASSES && angle_deg >= classes[k].to_deg) k++;
  return k;
}

static tp_chart_style line_of(tp_chart_colour colour, double width) {
  return (tp_chart_style){TP_MARK_LINE, colour, TP_DASH_SOLID, width};
}

static void begin(tp_chart *chart, const char *quantity, tp_chart_style style) {
  tp_chart_add_series(chart, style, (const char *const[]){quantity});
}

static void add(tp_chart *chart, double x, double y) {
  tp_chart_add_point(chart, tp_chart_exactly(x), tp_chart_exactly(y));
}

/* Between two drawn points. */
static double chord_angle(const tp_profile *p, size_t from, size_t to) {
  return atan((p->y[to] - p->y[from]) / (p->x[to] - p->x[from])) * degrees;
}

/* The drawn point after this one. */
static size_t next_drawn(const tp_profile *p, size_t from, size_t stride) {
  return from + stride < p->point_count ? from + stride : p->point_count - 1;
}

static void draw_course(tp_chart *chart, const tp_profile *p, size_t stride) {
  begin(chart, "height", line_of(TP_COLOUR_BLACK, 0.3));
  for (size_t k = 0;; k = next_drawn(p, k, stride)) {
    add(chart, p->x[k], p->y[k]);
    if (k + 1 == p->point_count) break;
  }
  for (size_t c = 0; c < CLASSES; c++) {
    bool any = false;
    for (size_t k = 0; k + 1 < p->point_count;) {
      const size_t next = next_drawn(p, k, stride);
      if (class_of(chord_angle(p, k, next)) == c) {
        if (!any) tp_chart_add_guide(chart, line_of(classes[c].colour, 1.4));
        if (any) tp_chart_add_break(chart);
        tp_chart_add_corner(chart, p->x[k], p->y[k]);
        tp_chart_add_corner(chart, p->x[next], p->y[next]);
        any = true;
      }
      k = next;
    }
    if (any) tp_chart_add_legend(chart, classes[c].text, line_of(classes[c].colour, 1.4));
  }
}

static void add_course(tp_chart *chart, const tp_profile *p) {
  char x_label[96], y_label[48], through[48] = "";
  const size_t stride = (p->point_count + MOST_DRAWN - 1) / MOST_DRAWN;
  double low = p->y[0], high = p->y[0];
  for (size_t k = 1; k < p->point_count; k++) {
    low = fmin(low, p->y[k]);
    high = fmax(high, p->y[k]);
  }
  const double room = high > low ? 0.1 * (high - low) : p->length.value / 10;
  if (stride > 1) snprintf(through, sizeof through, ", drawn every %zu points", stride);
  snprintf(x_label, sizeof x_label, "Along the mean plane (%s)%s", p->length_unit, through);
  snprintf(y_label, sizeof y_label, "Height (%s)", p->length_unit);
  tp_chart_add_panel(chart, NULL, (tp_panel_axis){.label = x_label, .range = {0, p->length.value}},
                     (tp_panel_axis){.label = y_label, .range = {low - room, high + room}});
  draw_course(chart, p, stride);
}

/* A whole decade on either side. */
static void widen(tp_chart_range *range, double value) {
  if (!(value > 0) || !isfinite(value)) return;
  range->from = fmin(range->from, pow(10, floor(log10(value))));
  range->to = fmax(range->to, pow(10, ceil(log10(value))));
}

/* Of values on both axes; one decade where there is but one value, or none. */
static void settle(tp_chart_range *range) {
  if (range->to <= 0) *range = (tp_chart_range){0.1, 1};
  if (range->to <= range->from) range->to = 10 * range->from;
}

static void add_exponent(tp_chart *chart, const tp_profile_estimate *hurst, double x, double y) {
  char text[80];
  if (!hurst->found) return;
  if (hurst->has_range) {
    snprintf(text, sizeof text, "{/:Italic H} = %.2f (%.2f to %.2f)", hurst->value, hurst->low,
             hurst->high);
  } else {
    snprintf(text, sizeof text, "{/:Italic H} = %.2f", hurst->value);
  }
  tp_chart_add_label(chart, x, y, TP_LABEL_RIGHT, text);
}

static void add_structure(tp_chart *chart, const tp_profile *p) {
  char x_label[48], y_label[64];
  tp_chart_range x = {DBL_MAX, 0}, y = {DBL_MAX, 0};
  for (size_t k = 0; k < p->lag_count; k++) {
    widen(&x, p->lags[k].distance);
    widen(&y, p->lags[k].structure);
  }
  settle(&x);
  settle(&y);
  snprintf(x_label, sizeof x_label, "Distance (%s)", p->length_unit);
  snprintf(y_label, sizeof y_label, "Structure function (%s²)", p->length_unit);
  tp_chart_add_panel(chart, NULL,
                     (tp_panel_axis){.label = x_label, .range = x, .logarithmic = true},
                     (tp_panel_axis){.label = y_label, .range = y, .logarithmic = true});
  begin(chart, "structure function", line_of(TP_COLOUR_BLUE, 0));
  for (size_t k = 0; k < p->lag_count; k++) {
    if (p->lags[k].structure > 0) add(chart, p->lags[k].distance, p->lags[k].structure);
  }
  add_exponent(chart, &p->hurst_by_structure, x.from * 1.2, y.to / 2);
}

static void add_spectrum(tp_chart *chart, const tp_profile *p) {
  char x_label[48], y_label[64];
  tp_chart_range x = {DBL_MAX, 0}, y = {DBL_MAX, 0};
  double largest = 0;
  static const double least_share = 1e-12; /* of the largest: what is smaller is rounding */
  for (tp_band band = {0}; tp_band_next(&band, p);) largest = fmax(largest, band.density);
  for (tp_band band = {0}; tp_band_next(&band, p);) {
    if (!(band.density > least_share * largest)) continue;
    widen(&x, band.frequency);
    widen(&y, band.density);
  }
  settle(&x);
  settle(&y);
  snprintf(x_label, sizeof x_label, "Frequency (cycles/%s)", p->length_unit);
  snprintf(y_label, sizeof y_label, "Spectral density (%s³)", p->length_unit);
  tp_chart_add_panel(chart, NULL,
                     (tp_panel_axis){.label = x_label, .range = x, .logarithmic = true},
                     (tp_panel_axis){.label = y_label, .range = y, .logarithmic = true});
  begin(chart, "spectral density", line_of(TP_COLOUR_GREEN, 0));
  for (tp_band band = {0}; tp_band_next(&band, p);) {
    if (band.density > least_share * largest) add(chart, band.frequency, band.density);
  }
  add_exponent(chart, &p->hurst_by_spectrum, x.from * 1.2, y.from * 2);
}

/* Share of the length along the profile whose angle lies in each sector. */
static double find_shares(double share[SECTORS], const tp_profile *p) {
  double total = 0, largest = 0;
  for (int s = 0; s < SECTORS; s++) share[s] = 0;
  for (size_t k = 1; k < p->point_count; k++) {
    const double dx = p->x[k] - p->x[k - 1], dy = p->y[k] - p->y[k - 1];
    const double angle = atan(dy / dx) * degrees, length = sqrt(dx * dx + dy * dy);
    const int at = (int)((angle + widest_deg) * SECTORS / (2 * widest_deg));
    share[at < SECTORS ? at : SECTORS - 1] += length;
    total += length;
  }
  for (int s = 0; s < SECTORS; s++) {
    share[s] /= total;
    largest = fmax(largest, share[s]);
  }
  return largest;
}

/* In degrees. */
static double sector_begins(int sector) {
  return 2 * widest_deg * sector / SECTORS - widest_deg;
}

/* Where the rose has a slope: what rises lies to the right, what falls to the left, level ground
 * on either side at the foot. */
static void rim(double at[2], double angle_deg, double radius) {
  const double angle = fabs(angle_deg) / degrees;
  at[0] = (angle_deg < 0 ? -radius : radius) * cos(angle);
  at[1] = radius * sin(angle);
}

/* The middle of each sector's rim: by the root of the share, so that areas are shares. */
static void add_rims(tp_chart *chart, const double share[SECTORS]) {
  begin(chart, "slope rose", (tp_chart_style){TP_MARK_POINTS, TP_COLOUR_BLACK, TP_DASH_SOLID, 0});
  for (int s = 0; s < SECTORS; s++) {
    char text[40];
    double at[2];
    const double angle_deg = (sector_begins(s) + sector_begins(s + 1)) / 2;
    if (share[s] == 0) continue;
    rim(at, angle_deg, sqrt(share[s]));
    add(chart, at[0], at[1]);
    snprintf(text, sizeof text, "%.1f", angle_deg);
    tp_chart_add_note(chart, 0, text);
    snprintf(text, sizeof text, "%.6f", share[s]);
    tp_chart_add_note(chart, 1, text);
  }
}

static void draw_sector(tp_chart *chart, int sector, double radius) {
  const double from = sector_begins(sector), to = sector_begins(sector + 1);
  const double middle = (from + to) / 2, half = (to - from) / 2;
  const tp_chart_colour colour = classes[class_of(middle)].colour;
  tp_chart_add_guide(chart, (tp_chart_style){TP_MARK_REGION, colour, TP_DASH_SOLID, 0});
  tp_chart_add_corner(chart, 0, 0);
  for (int k = -ARC_STEPS; k <= ARC_STEPS; k++) {
    double at[2];
    const double angle = fabs(middle) + half * k / ARC_STEPS;
    rim(at, angle, radius);
    if (middle < 0) at[0] = -at[0];
    tp_chart_add_corner(chart, at[0], at[1]);
  }
}

static void draw_rays(tp_chart *chart, double radius) {
  static const int rays_deg[] = {-60, -30, 30, 60};
  for (size_t k = 0; k < sizeof rays_deg / sizeof rays_deg[0]; k++) {
    char text[16];
    double at[2];
    rim(at, rays_deg[k], radius);
    tp_chart_add_guide(chart, line_of(TP_COLOUR_GREY, 0.3));
    tp_chart_add_corner(chart, 0, 0);
    tp_chart_add_corner(chart, at[0], at[1]);
    snprintf(text, sizeof text, "%d°", rays_deg[k] < 0 ? -rays_deg[k] : rays_deg[k]);
    tp_chart_add_label(chart, at[0], at[1], rays_deg[k] < 0 ? TP_LABEL_LEFT : TP_LABEL_RIGHT, text);
  }
}

/* The panel is as wide as high in its units. */
static void add_rose(tp_chart *chart, const tp_profile *p) {
  double share[SECTORS];
  const double largest = sqrt(find_shares(share, p)), wide = 1.15 * largest;
  const double high = 2 * wide * chart->panel_height_mm / chart->panel_width_mm;
  const tp_panel_axis x = {.label = "Slopes that fall, and rise: root of the share of the length",
                           .range = {-wide, wide}},
                      y = {.label = "", .range = {0, high}};
  tp_chart_add_panel(chart, NULL, x, y);
  add_rims(chart, share);
  for (int s = 0; s < SECTORS; s++) {
    if (share[s] > 0) draw_sector(chart, s, sqrt(share[s]));
  }
  draw_rays(chart, largest);
}

tp_status tp_chart_profile(tp_chart **chart, const tp_profile *profile, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, chart);
  TP_REFUSE_NULL(message, profile);
  tp_chart *own = tp_chart_new("profile", keys, "x", "y", notes);
  if (own == NULL) return tp_fail_memory(message, "the chart");
  for (size_t k = 0; k < profile->source_count; k++) {
    tp_chart_add_source(own, profile->sources[k]);
  }
  own->columns = 2;
  own->panel_width_mm = 72;
  own->panel_height_mm = 48;
  if (profile->title != NULL) tp_chart_set_title(own, profile->title);
  add_course(own, profile);
  add_rose(own, profile);
  if (profile->series == TP_SERIES_GIVEN) {
    add_structure(own, profile);
    add_spectrum(own, profile);
  }
  return tp_chart_finish(own, chart, message);
}
