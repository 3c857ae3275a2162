/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A chart as data: panels, series of points in them, labels and a legend. It is drawn by
 * chart/script.h and tabulated by chart/table.c; a style here is a number that tells series
 * apart. */

#ifndef TP_CHART_CHART_H
#define TP_CHART_CHART_H

#include "output/language.h"
#include "topple.h"

enum { TP_CHART_KEYS = 5, TP_CHART_NOTES = 5 };

typedef enum tp_chart_mark {
  TP_MARK_LINE,
  TP_MARK_POINTS,
  TP_MARK_REGION,
  TP_MARK_NONE /* data of which something else is drawn */
} tp_chart_mark;

typedef enum tp_chart_colour {
  TP_COLOUR_BLACK,
  TP_COLOUR_ORANGE,
  TP_COLOUR_SKY_BLUE,
  TP_COLOUR_GREEN,
  TP_COLOUR_YELLOW,
  TP_COLOUR_BLUE,
  TP_COLOUR_VERMILLION,
  TP_COLOUR_PURPLE,
  TP_COLOUR_GREY
} tp_chart_colour;

typedef enum tp_chart_dash {
  TP_DASH_SOLID,
  TP_DASH_DASHED,
  TP_DASH_DOTTED,
  TP_DASH_DASH_DOT,
  TP_DASH_LONG
} tp_chart_dash; /* of points a symbol: dashed squares, dotted rings, any other the usual one */

typedef struct tp_chart_style {
  tp_chart_mark mark;
  tp_chart_colour colour;
  tp_chart_dash dash;
  double width; /* of a line, points; 0: that of a curve */
} tp_chart_style;

typedef struct tp_chart_point {
  tp_bounded x, y;
  char *notes[TP_CHART_NOTES];
} tp_chart_point;

typedef struct tp_chart_series {
  size_t panel;
  tp_chart_style style;
  bool drawn_only; /* no data: a guide to the eye, a region */
  char *keys[TP_CHART_KEYS];
  size_t count, capacity;
  tp_chart_point *points;
} tp_chart_series;

typedef struct tp_panel_axis {
  const char *label; /* a copy, in a panel of a chart */
  bool plain;        /* a user's text: no markup */
  tp_chart_range range;
  double tick; /* 0: as it comes; of a logarithmic axis above 0: labels within decades, too */
  bool logarithmic;
} tp_panel_axis;

typedef struct tp_chart_panel {
  char *title;
  tp_panel_axis x, y;
} tp_chart_panel;

typedef enum tp_label_side {
  TP_LABEL_CENTRE, /* on the point */
  TP_LABEL_BOXED,  /* on the point, on white: it interrupts a curve */
  TP_LABEL_LEFT,
  TP_LABEL_RIGHT,
  TP_LABEL_BELOW, /* and to its right */
  TP_LABEL_ABOVE,
  TP_LABEL_ALONG /* above it, beginning there */
} tp_label_side;

typedef struct tp_chart_label {
  size_t panel;
  double x, y;
  char *text;
  bool plain; /* a user's text: no markup */
  tp_label_side side;
} tp_chart_label;

typedef struct tp_chart_legend {
  char *text;
  tp_chart_style style;
} tp_chart_legend;

struct tp_chart {
  const char *kind;
  char *title;                          /* a user's, or NULL */
  const char *key_names[TP_CHART_KEYS]; /* NULL after the last */
  const char *note_names[TP_CHART_NOTES];
  char *x_name, *y_name;
  size_t columns; /* panels in a row */
  double panel_width_mm, panel_height_mm;
  bool rows_are_named; /* each row has labels below and titles above: more room between rows */
  size_t panel_count, series_count, label_count, legend_count, source_count;
  tp_chart_panel *panels;
  tp_chart_series *series;
  tp_chart_label *labels;
  tp_chart_legend *legend;
  char **sources; /* files that it was computed from */
  bool comma;     /* before decimals */
  bool failed;    /* memory was exhausted; the rest is dropped */
};

/* NULL when memory is exhausted. The names of keys and notes end in NULL and outlive the chart. */
tp_chart *tp_chart_new(const char *kind, const char *const *keys, const char *x, const char *y,
                       const char *const *notes);

void tp_chart_set_title(tp_chart *chart, const char *title);

/* A file that the chart was computed from, and must not be written to. */
void tp_chart_add_source(tp_chart *chart, const char *path);
void tp_chart_add_panel(tp_chart *chart, const char *title, tp_panel_axis x, tp_panel_axis y);

/* A series in the last panel, with a value for each key name; the calls after it add to it. */
void tp_chart_add_series(tp_chart *chart, tp_chart_style style, const char *const *keys);
void tp_chart_add_point(tp_chart *chart, tp_bounded x, tp_bounded y);
void tp_chart_add_note(tp_chart *chart, size_t which, const char *text);

/* What is drawn only, in the last panel. */
void tp_chart_add_guide(tp_chart *chart, tp_chart_style style);
void tp_chart_add_corner(tp_chart *chart, double x, double y);
void tp_chart_add_break(tp_chart *chart); /* another polygon of the same region begins */
void tp_chart_add_label(tp_chart *chart, double x, double y, tp_label_side side, const char *text);
/* The same of a user's text, which it takes as it is. */
void tp_chart_add_plain_label(tp_chart *chart, double x, double y, tp_label_side side,
                              const char *text);
void tp_chart_add_legend(tp_chart *chart, const char *text, tp_chart_style style);

/* Its words in a language, and a comma before the decimals of its axes. False when memory is
 * exhausted. */
TP_MUST_USE bool tp_chart_tell(tp_chart *chart, const tp_language *language, bool comma);

/* Hand the chart over, or free it when memory was exhausted on the way. */
TP_MUST_USE tp_status tp_chart_finish(tp_chart *own, tp_chart **chart, tp_message *message);

/* It drawn in memory, as SVG, PDF or PNG; `*data` is to be freed. */
TP_MUST_USE tp_status tp_chart_draw(char **data, size_t *size, const tp_chart *chart,
                                    tp_chart_format format, tp_message *message);

/* A double as it is. */
tp_bounded tp_chart_exactly(double value);

#endif
