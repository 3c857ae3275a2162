/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Reactions of the facets of the base in a tilt test, normal and along the facet: against the tilt
 * up to where the block lets go, or where the table stands still against time. Points of the curves
 * are the test's moments, which on a path are its events too; these are marked. The facets that
 * bear most have a colour each, the others are drawn together; the table has them all. */

#include "chart/tilt_curves.h"
#include "host.h"
#include "message.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { FORCES = 2, COLOURED = 6, MOST_MARKS = 400 };

static const char *const keys[] = {"towards", "force", "facet", NULL};
static const char *const notes[] = {"event", NULL};
static const char *const force_names[FORCES] = {"normal", "shear"};
static const char *const force_labels[FORCES] = {"Normal force (N)", "Shear force (N)"};
static const tp_chart_colour colours[COLOURED] = {TP_COLOUR_BLACK,  TP_COLOUR_ORANGE,
                                                  TP_COLOUR_BLUE,   TP_COLOUR_GREEN,
                                                  TP_COLOUR_PURPLE, TP_COLOUR_SKY_BLUE};
static const tp_chart_style others_line = {TP_MARK_LINE, TP_COLOUR_GREY, TP_DASH_DASHED, 0.8};
static const tp_chart_style critical_line = {TP_MARK_LINE, TP_COLOUR_VERMILLION, TP_DASH_DOTTED,
                                             0.8};
static const tp_chart_style contact_mark = {TP_MARK_POINTS, TP_COLOUR_BLACK, TP_DASH_SOLID, 0};
static const tp_chart_style slip_mark = {TP_MARK_POINTS, TP_COLOUR_VERMILLION, TP_DASH_DOTTED, 0};

/* A facet of the base, in any of the cases. */
typedef struct facet {
  long number;
  double most_n; /* of its normal forces */
  int colour;    /* of colours; -1: drawn with the others */
  double x0_m, x1_m;
} facet;

typedef struct drawing {
  tp_chart *chart;
  const tp_tilt_test *test;
  bool by_tilt;
  size_t facet_count;
  facet *facets; /* by their numbers */
  bool has_others, has_contact_marks, has_slip_marks, has_critical;
} drawing;

/* Forces of a case: facet by facet the moments that are drawn. */
typedef struct forces {
  const tp_tilt_case *own;
  size_t count; /* of the moments */
  double *of[FORCES];
} forces;

/* ---- the facets --------------------------------------------------------------------------------
 */

static size_t find(const drawing *d, long number) {
  size_t low = 0, high = d->facet_count;
  while (low < high) {
    const size_t middle = (low + high) / 2;
    if (d->facets[middle].number < number) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return low;
}

/* Where its number belongs. */
static void add_facet(drawing *d, facet own) {
  const size_t at = find(d, own.number);
  if (at < d->facet_count && d->facets[at].number == own.number) return;
  for (size_t k = d->facet_count; k > at; k--) d->facets[k] = d->facets[k - 1];
  d->facets[at] = own;
  d->facet_count++;
}

static bool collect(drawing *d) {
  size_t room = 1; /* an end face */
  for (size_t c = 0; c < d->test->case_count; c++) room += d->test->cases[c].facet_count;
  d->facets = calloc(room, sizeof *d->facets);
  if (d->facets == NULL) return false;
  for (size_t c = 0; c < d->test->case_count; c++) {
    const tp_tilt_case *own = d->test->cases + c;
    for (size_t k = 0; k < own->facet_count; k++) {
      const tp_tilt_facet *f = own->facets + k;
      add_facet(d, (facet){.number = f->facet, .colour = -1, .x0_m = f->x0_m, .x1_m = f->x1_m});
    }
    for (size_t k = 0; k < own->reaction_count; k++) {
      const tp_tilt_reaction *r = own->reactions + k;
      if (r->facet == 0) add_facet(d, (facet){.number = 0, .colour = -1});
      facet *f = d->facets + find(d, r->facet);
      f->most_n = fmax(f->most_n, r->normal_n);
    }
  }
  return true;
}

/* Those that bear most, coloured from left to right. */
static void colour(drawing *d) {
  for (int k = 0; k < COLOURED; k++) {
    facet *most = NULL;
    for (size_t j = 0; j < d->facet_count; j++) {
      facet *f = d->facets + j;
      if (f->colour < 0 && f->most_n > 0 && (most == NULL || f->most_n > most->most_n)) most = f;
    }
    if (most != NULL) most->colour = 0;
  }
  int next = 0;
  for (size_t j = 0; j < d->facet_count; j++) {
    if (d->facets[j].colour == 0) d->facets[j].colour = next++;
    d->has_others = d->has_others || (d->facets[j].colour < 0 && d->facets[j].most_n > 0);
  }
}

/* ---- the moments -------------------------------------------------------------------------------
 */

/* On a table that tilts those before the block lets go. */
static size_t shown_moments(const drawing *d, const tp_tilt_case *own) {
  if (!d->by_tilt || !own->has_bracket) return own->moment_count;
  size_t count = 0;
  while (count < own->moment_count && own->moments[count].angle_deg < own->most_deg) count++;
  return count;
}

static double at(const drawing *d, const forces *f, size_t moment) {
  const tp_tilt_moment *m = f->own->moments + moment;
  return d->by_tilt ? m->angle_deg : m->time_s;
}

static void forces_clear(forces *f) {
  for (int k = 0; k < FORCES; k++) free(f->of[k]);
}

/* A facet that is not told of at a moment bears nothing. */
static bool forces_init(forces *f, const drawing *d, const tp_tilt_case *own) {
  *f = (forces){.own = own, .count = shown_moments(d, own)};
  for (int k = 0; k < FORCES; k++) {
    f->of[k] = calloc(f->count * d->facet_count + 1, sizeof *f->of[k]);
  }
  if (f->of[0] == NULL || f->of[1] == NULL) {
    forces_clear(f);
    return false;
  }
  for (size_t k = 0; k < own->reaction_count; k++) {
    const tp_tilt_reaction *r = own->reactions + k;
    if (r->moment >= f->count) break;
    const size_t place = find(d, r->facet) * f->count + r->moment;
    f->of[0][place] = r->normal_n;
    f->of[1][place] = r->shear_n;
  }
  return true;
}

/* ---- a panel -----------------------------------------------------------------------------------
 */

static void begin_series(drawing *d, const forces *f, int force, const facet *own,
                         tp_chart_style style) {
  char number[24];
  snprintf(number, sizeof number, "%ld", own->number);
  tp_chart_add_series(
      d->chart, style,
      (const char *const[]){tp_chart_towards(f->own->towards), force_names[force], number});
}

static void add_curves(drawing *d, const forces *f, int force) {
  for (size_t j = 0; j < d->facet_count; j++) {
    const facet *own = d->facets + j;
    const tp_chart_style drawn = {TP_MARK_LINE, own->colour < 0 ? 0 : colours[own->colour],
                                  TP_DASH_SOLID, 0},
                         table = {.mark = TP_MARK_NONE};
    begin_series(d, f, force, own, own->colour < 0 ? table : drawn);
    for (size_t k = 0; k < f->count; k++) {
      tp_chart_add_corner(d->chart, at(d, f, k), f->of[force][j * f->count + k]);
    }
  }
}

/* The sum of those without a colour of their own. */
static void add_others(drawing *d, const forces *f, int force, tp_chart_range *y) {
  if (!d->has_others) return;
  tp_chart_add_guide(d->chart, others_line);
  for (size_t k = 0; k < f->count; k++) {
    double sum = 0;
    for (size_t j = 0; j < d->facet_count; j++) {
      if (d->facets[j].colour < 0) sum += f->of[force][j * f->count + k];
    }
    tp_chart_range_take(y, sum);
    tp_chart_add_corner(d->chart, at(d, f, k), sum);
  }
}

static bool is_of_contact(const tp_tilt_event *e, bool slip) {
  return slip ? e->kind == TP_EVENT_SLIPS || e->kind == TP_EVENT_STICKS
              : e->kind == TP_EVENT_OPENS || e->kind == TP_EVENT_CLOSES;
}

/* The moment of an event, or the last one before it. */
static size_t moment_of(const forces *f, const tp_tilt_event *e) {
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
static void add_marks(drawing *d, const forces *f, int force, bool slip) {
  const tp_tilt_case *own = f->own;
  size_t marks = 0;
  for (size_t k = 0; k < own->event_count && marks < MOST_MARKS; k++) {
    const tp_tilt_event *e = own->events + k;
    const size_t j = find(d, e->facet);
    if (!is_of_contact(e, slip) || j == d->facet_count || d->facets[j].number != e->facet ||
        d->facets[j].colour < 0 || f->count == 0 ||
        (d->by_tilt && own->has_bracket && e->angle_deg >= own->most_deg)) {
      continue;
    }
    const size_t moment = moment_of(f, e);
    begin_series(d, f, force, d->facets + j, slip ? slip_mark : contact_mark);
    tp_chart_add_corner(d->chart, at(d, f, moment), f->of[force][j * f->count + moment]);
    tp_chart_add_note(d->chart, 0, tp_tilt_event_name(e->kind));
    marks++;
  }
  if (slip) {
    d->has_slip_marks = d->has_slip_marks || marks > 0;
  } else {
    d->has_contact_marks = d->has_contact_marks || marks > 0;
  }
}

static void add_critical(drawing *d, const forces *f, tp_chart_range y) {
  if (!d->by_tilt || !f->own->has_bracket) return;
  tp_chart_add_guide(d->chart, critical_line);
  tp_chart_add_corner(d->chart, f->own->most_deg, y.from);
  tp_chart_add_corner(d->chart, f->own->most_deg, y.to);
  d->has_critical = true;
}

/* Some time after the last event: a block at rest goes on for long. */
static double last_change(const tp_tilt_case *own, double otherwise) {
  static const double longer = 1.1;
  if (own->event_count == 0 || own->end != TP_TILT_RESTS) return otherwise;
  return longer * own->events[own->event_count - 1].time_s;
}

static void add_panel(drawing *d, const forces *f, int force) {
  char title[64];
  tp_chart_range x = tp_chart_range_empty(), y = tp_chart_range_empty();
  tp_chart_range_take(&y, 0);
  for (size_t k = 0; k < f->count; k++) tp_chart_range_take(&x, at(d, f, k));
  if (!d->by_tilt) x.to = fmin(x.to, last_change(f->own, x.to));
  if (d->by_tilt && f->own->has_bracket) tp_chart_range_take(&x, f->own->most_deg);
  for (size_t k = 0; k < f->count * d->facet_count; k++) tp_chart_range_take(&y, f->of[force][k]);
  snprintf(title, sizeof title, "Tilted towards the %s", tp_chart_towards(f->own->towards));
  tp_chart_add_panel(d->chart, d->test->case_count > 1 ? title : NULL,
                     (tp_panel_axis){.label = d->by_tilt ? "Tilt (°)" : "Time (s)"},
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
  for (size_t j = 0; j < d->facet_count; j++) {
    const facet *own = d->facets + j;
    const double unit = d->test->metres_per_unit;
    char text[120];
    if (own->colour < 0) continue;
    if (own->number == 0) {
      snprintf(text, sizeof text, "end face");
    } else {
      snprintf(text, sizeof text, "facet %ld, x from %.4g to %.4g %s", own->number,
               own->x0_m / unit, own->x1_m / unit, d->test->length_unit);
    }
    tp_chart_add_legend(d->chart, text,
                        (tp_chart_style){TP_MARK_LINE, colours[own->colour], TP_DASH_SOLID, 0});
  }
  if (d->has_others) tp_chart_add_legend(d->chart, "other facets together", others_line);
  if (d->has_critical) tp_chart_add_legend(d->chart, "it lets go", critical_line);
  if (d->has_contact_marks) tp_chart_add_legend(d->chart, "opens or closes", contact_mark);
  if (d->has_slip_marks) tp_chart_add_legend(d->chart, "slips or sticks", slip_mark);
}

static tp_status fail_empty(tp_message *message) {
  return tp_fail(message, TP_NO_ANSWER, (tp_place){0},
                 "the test has no reactions to draw: it knows none before the block lets go");
}

static bool fill(drawing *d) {
  bool done = collect(d);
  if (done) colour(d);
  for (size_t c = 0; c < d->test->case_count && done; c++) {
    forces f;
    done = forces_init(&f, d, d->test->cases + c);
    if (!done) break;
    for (int k = 0; k < FORCES && f.count > 0; k++) add_panel(d, &f, k);
    forces_clear(&f);
  }
  if (done) add_legend(d);
  free(d->facets);
  return done;
}

tp_status tp_chart_tilt_reactions(tp_chart **chart, const tp_tilt_test *test, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, chart);
  TP_REFUSE_NULL(message, test);
  const tp_tilt_settings *s = &test->settings;
  drawing d = {.test = test, .by_tilt = s->engine == TP_TILT_PATH || s->protocol == TP_TILT_RAMP};
  size_t shown = 0;
  for (size_t c = 0; c < test->case_count; c++) {
    if (test->cases[c].reaction_count > 0) shown += shown_moments(&d, test->cases + c);
  }
  if (shown == 0) return fail_empty(message);
  d.chart =
      tp_chart_new("tilt_reactions", keys, d.by_tilt ? "angle_deg" : "time_s", "force_n", notes);
  if (d.chart == NULL) return tp_fail_memory(message, "the chart");
  if (test->title != NULL) tp_chart_set_title(d.chart, test->title);
  d.chart->columns = 2;
  d.chart->panel_width_mm = 66;
  d.chart->panel_height_mm = 50;
  d.chart->rows_are_named = true;
  if (!fill(&d)) d.chart->failed = true;
  return tp_chart_finish(d.chart, chart, message);
}
