/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Reactions of the facets of the base in a tilt test, normal and along the facet: against the tilt
 * up to where the block begins to move, or where the table stands still against time. Points of the
 * curves are the test's moments, which on a path are its events too; these are marked. The facets
 * that bear most have a colour each, the others are drawn together; the table has them all. */

#include "chart/tilt_curves.h"
#include "chart/tilt_forces.h"
#include "common/host.h"
#include "common/message.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { MOST_MARKS = 400 };

static const char *const keys[] = {"towards", "force", "facet", NULL};
static const char *const notes[] = {"event", NULL};
static const char *const force_names[TP_FORCES] = {"normal", "shear"};
static const char *const force_labels[TP_FORCES] = {"Normal force (N)", "Shear force (N)"};
static const tp_chart_colour colours[TP_FACETS_COLOURED] = {TP_COLOUR_BLACK,  TP_COLOUR_ORANGE,
                                                            TP_COLOUR_BLUE,   TP_COLOUR_GREEN,
                                                            TP_COLOUR_PURPLE, TP_COLOUR_SKY_BLUE};
static const tp_chart_style others_line = {TP_MARK_LINE, TP_COLOUR_GREY, TP_DASH_DASHED, 0.8};
static const tp_chart_style critical_line = {TP_MARK_LINE, TP_COLOUR_VERMILLION, TP_DASH_DOTTED,
                                             0.8};
static const tp_chart_style contact_mark = {TP_MARK_POINTS, TP_COLOUR_BLACK, TP_DASH_SOLID, 0};
static const tp_chart_style slip_mark = {TP_MARK_POINTS, TP_COLOUR_VERMILLION, TP_DASH_DOTTED, 0};

typedef struct drawing {
  tp_chart *chart;
  tp_force_facets facets;
  bool has_contact_marks, has_slip_marks, has_critical;
} drawing;

/* ---- a panel -----------------------------------------------------------------------------------
 */

static void begin_series(drawing *d, const tp_tilt_forces *f, int force, const tp_force_facet *own,
                         tp_chart_style style) {
  char number[24];
  snprintf(number, sizeof number, "%ld", own->number);
  tp_chart_add_series(
      d->chart, style,
      (const char *const[]){tp_chart_towards(f->own->towards), force_names[force], number});
}

static void add_curves(drawing *d, const tp_tilt_forces *f, int force) {
  for (size_t j = 0; j < d->facets.count; j++) {
    const tp_force_facet *own = d->facets.items + j;
    const tp_chart_style drawn = {TP_MARK_LINE, own->colour < 0 ? 0 : colours[own->colour],
                                  TP_DASH_SOLID, 0},
                         table = {.mark = TP_MARK_NONE};
    begin_series(d, f, force, own, own->colour < 0 ? table : drawn);
    for (size_t k = 0; k < f->count; k++) {
      tp_chart_add_corner(d->chart, tp_tilt_forces_at(f, k), f->of[force][j * f->count + k]);
    }
  }
}

/* The sum of those without a colour of their own. */
static void add_others(drawing *d, const tp_tilt_forces *f, int force, tp_chart_range *y) {
  if (!d->facets.has_others) return;
  tp_chart_add_guide(d->chart, others_line);
  for (size_t k = 0; k < f->count; k++) {
    double sum = 0;
    for (size_t j = 0; j < d->facets.count; j++) {
      if (d->facets.items[j].colour < 0) sum += f->of[force][j * f->count + k];
    }
    tp_chart_range_take(y, sum);
    tp_chart_add_corner(d->chart, tp_tilt_forces_at(f, k), sum);
  }
}

static bool is_of_contact(const tp_tilt_event *e, bool slip) {
  return slip ? e->what == TP_EVENT_SLIPS || e->what == TP_EVENT_STICKS
              : e->what == TP_EVENT_OPENS || e->what == TP_EVENT_CLOSES;
}

/* The moment of an event, or the last one before it. */
static size_t moment_of(const tp_tilt_forces *f, const tp_tilt_event *e) {
  size_t low = 0, high = f->count;
  while (high - low > 1) {
    const size_t middle = (low + high) / 2;
    const tp_tilt_moment *m = f->own->moments + middle;
    const bool later =
        m->angle_deg != e->angle_deg ? m->angle_deg > e->angle_deg : m->time_s > e->time_s;
    if (later) {
      high = middle;
    } else {
      low = middle;
    }
  }
  return low;
}

/* On the curves of coloured facets: of thousands of marks nothing would be seen. */
static void add_marks(drawing *d, const tp_tilt_forces *f, int force, bool slip) {
  const tp_tilt_case *own = f->own;
  size_t marks = 0;
  for (size_t k = 0; k < own->event_count && marks < MOST_MARKS; k++) {
    const tp_tilt_event *e = own->events + k;
    const size_t j = tp_force_facets_find(&d->facets, e->facet);
    if (!is_of_contact(e, slip) || j == d->facets.count || d->facets.items[j].number != e->facet ||
        d->facets.items[j].colour < 0 || f->count == 0 ||
        (d->facets.by_tilt && own->has_bracket && e->angle_deg >= own->lets_go_at_deg)) {
      continue;
    }
    const size_t moment = moment_of(f, e);
    begin_series(d, f, force, d->facets.items + j, slip ? slip_mark : contact_mark);
    tp_chart_add_corner(d->chart, tp_tilt_forces_at(f, moment),
                        f->of[force][j * f->count + moment]);
    tp_chart_add_note(d->chart, 0, tp_tilt_event_name(e->what));
    marks++;
  }
  if (slip) {
    d->has_slip_marks = d->has_slip_marks || marks > 0;
  } else {
    d->has_contact_marks = d->has_contact_marks || marks > 0;
  }
}

static void add_critical(drawing *d, const tp_tilt_forces *f, tp_chart_range y) {
  if (!d->facets.by_tilt || !f->own->has_bracket) return;
  tp_chart_add_guide(d->chart, critical_line);
  tp_chart_add_corner(d->chart, f->own->lets_go_at_deg, y.from);
  tp_chart_add_corner(d->chart, f->own->lets_go_at_deg, y.to);
  d->has_critical = true;
}

/* Some time after the last event: a block at rest goes on for long. */
static double last_change(const tp_tilt_case *own, double otherwise) {
  static const double longer = 1.1;
  if (own->event_count == 0 || own->end != TP_TILT_RESTS) return otherwise;
  return longer * own->events[own->event_count - 1].time_s;
}

static void add_panel(drawing *d, const tp_tilt_forces *f, int force) {
  char title[64];
  tp_chart_range x = tp_chart_range_empty(), y = tp_chart_range_empty();
  tp_chart_range_take(&y, 0);
  for (size_t k = 0; k < f->count; k++) tp_chart_range_take(&x, tp_tilt_forces_at(f, k));
  if (!d->facets.by_tilt) x.to = fmin(x.to, last_change(f->own, x.to));
  if (d->facets.by_tilt && f->own->has_bracket) tp_chart_range_take(&x, f->own->lets_go_at_deg);
  for (size_t k = 0; k < f->count * d->facets.count; k++) tp_chart_range_take(&y, f->of[force][k]);
  snprintf(title, sizeof title, "Tilted towards the %s", tp_chart_towards(f->own->towards));
  tp_chart_add_panel(d->chart, d->facets.test->case_count > 1 ? title : NULL,
                     (tp_panel_axis){.label = d->facets.by_tilt ? "Tilt (°)" : "Time (s)"},
                     (tp_panel_axis){.label = force_labels[force]});
  add_curves(d, f, force);
  add_others(d, f, force, &y);
  if (d->chart->failed) return;
  tp_chart_panel *panel = d->chart->panels + d->chart->panel_count - 1;
  panel->x.range = tp_chart_range_drawn(x);
  panel->y.range = tp_chart_range_drawn(y);
  add_critical(d, f, panel->y.range);
  tp_chart_add_level(d->chart, panel->x.range, panel->y.range, 0);
  add_marks(d, f, force, false);
  add_marks(d, f, force, true);
}

/* ---- the chart ---------------------------------------------------------------------------------
 */

static void add_legend(const drawing *d) {
  for (size_t j = 0; j < d->facets.count; j++) {
    const tp_force_facet *own = d->facets.items + j;
    const double unit = d->facets.test->metres_per_unit;
    char text[120];
    if (own->colour < 0) continue;
    if (own->number == 0) {
      snprintf(text, sizeof text, "end face");
    } else {
      snprintf(text, sizeof text, "facet %ld, x from %.4g to %.4g %s", own->number,
               own->x0_m / unit, own->x1_m / unit, d->facets.test->length_unit);
    }
    tp_chart_add_legend(d->chart, text,
                        (tp_chart_style){TP_MARK_LINE, colours[own->colour], TP_DASH_SOLID, 0});
  }
  if (d->facets.has_others) tp_chart_add_legend(d->chart, "other facets together", others_line);
  if (d->has_critical) tp_chart_add_legend(d->chart, "begins to move", critical_line);
  if (d->has_contact_marks) tp_chart_add_legend(d->chart, "opens or closes", contact_mark);
  if (d->has_slip_marks) tp_chart_add_legend(d->chart, "slips or sticks", slip_mark);
}

static tp_status fail_empty(tp_message *message) {
  return tp_fail(
      message, TP_NO_ANSWER, (tp_place){0},
      "the test has no reactions to draw: none are known before the block begins to move");
}

static bool fill(drawing *d) {
  const tp_tilt_test *test = d->facets.test;
  bool done = true;
  for (size_t c = 0; c < test->case_count && done; c++) {
    tp_tilt_forces f;
    done = tp_tilt_forces_init(&f, &d->facets, test->cases + c);
    if (!done) break;
    for (int k = 0; k < TP_FORCES && f.count > 0; k++) add_panel(d, &f, k);
    tp_tilt_forces_clear(&f);
  }
  if (done) add_legend(d);
  return done;
}

static bool is_empty(const tp_force_facets *facets) {
  size_t shown = 0;
  for (size_t c = 0; c < facets->test->case_count; c++) {
    const tp_tilt_case *own = facets->test->cases + c;
    if (own->reaction_count > 0) shown += tp_tilt_forces_shown(facets, own);
  }
  return shown == 0;
}

tp_status tp_chart_tilt_reactions(tp_chart **chart, const tp_tilt_test *test, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, chart);
  TP_REFUSE_NULL(message, test);
  drawing d = {.chart = NULL};
  if (!tp_force_facets_init(&d.facets, test)) return tp_fail_memory(message, "the chart");
  if (is_empty(&d.facets)) {
    tp_force_facets_clear(&d.facets);
    return fail_empty(message);
  }
  d.chart = tp_chart_new("tilt_reactions", keys, d.facets.by_tilt ? "angle_deg" : "time_s",
                         "force_n", notes);
  if (d.chart != NULL) {
    if (test->title != NULL) tp_chart_set_title(d.chart, test->title);
    d.chart->columns = TP_FORCES;
    d.chart->panel_width_mm = 66;
    d.chart->panel_height_mm = 50;
    d.chart->rows_are_named = true;
    if (!fill(&d)) d.chart->failed = true;
  }
  tp_force_facets_clear(&d.facets);
  return tp_chart_finish(d.chart, chart, message);
}
