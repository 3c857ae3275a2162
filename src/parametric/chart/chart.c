/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Growing lists of panels, series, points, labels and legend entries with their texts; a failed
 * allocation is remembered. */

#include "chart/chart.h"
#include "common/message.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

tp_bounded tp_chart_exactly(double value) {
  return (tp_bounded){.value = value};
}

static char *copy(tp_chart *chart, const char *text) {
  if (text == NULL) return NULL;
  char *copied = strdup(text);
  chart->failed |= copied == NULL;
  return copied;
}

/* Room for one more of `size` bytes, zeroed; NULL when memory is exhausted. */
static void *grow(tp_chart *chart, void **array, size_t *count, size_t size) {
  if (chart->failed) return NULL;
  char *grown = realloc(*array, (*count + 1) * size);
  chart->failed = grown == NULL;
  if (grown == NULL) return NULL;
  *array = grown;
  void *entry = grown + (*count)++ * size;
  memset(entry, 0, size);
  return entry;
}

tp_chart *tp_chart_new(const char *kind, const char *const *keys, const char *x, const char *y,
                       const char *const *notes) {
  tp_chart *chart = calloc(1, sizeof *chart);
  if (chart == NULL) return NULL;
  chart->kind = kind;
  for (size_t k = 0; keys[k] != NULL; k++) chart->key_names[k] = keys[k];
  for (size_t k = 0; notes[k] != NULL; k++) chart->note_names[k] = notes[k];
  chart->x_name = copy(chart, x);
  chart->y_name = copy(chart, y);
  chart->columns = 1;
  return chart;
}

void tp_chart_set_title(tp_chart *chart, const char *title) {
  free(chart->title);
  chart->title = copy(chart, title);
}

void tp_chart_add_source(tp_chart *chart, const char *path) {
  char **source =
      grow(chart, (void **)&chart->sources, &chart->source_count, sizeof *chart->sources);
  if (source != NULL) *source = copy(chart, path);
}

void tp_chart_add_panel(tp_chart *chart, const char *title, tp_panel_axis x, tp_panel_axis y) {
  tp_chart_panel *panel =
      grow(chart, (void **)&chart->panels, &chart->panel_count, sizeof *chart->panels);
  if (panel == NULL) return;
  *panel = (tp_chart_panel){copy(chart, title), x, y};
  panel->x.label = copy(chart, x.label);
  panel->y.label = copy(chart, y.label);
}

static tp_chart_series *add_series(tp_chart *chart, tp_chart_style style) {
  tp_chart_series *series =
      grow(chart, (void **)&chart->series, &chart->series_count, sizeof *chart->series);
  if (series == NULL) return NULL;
  series->panel = chart->panel_count - 1;
  series->style = style;
  return series;
}

void tp_chart_add_series(tp_chart *chart, tp_chart_style style, const char *const *keys) {
  tp_chart_series *series = add_series(chart, style);
  for (size_t k = 0; series != NULL && k < TP_CHART_KEYS && chart->key_names[k] != NULL; k++) {
    series->keys[k] = copy(chart, keys[k]);
  }
}

void tp_chart_add_guide(tp_chart *chart, tp_chart_style style) {
  tp_chart_series *series = add_series(chart, style);
  if (series != NULL) series->drawn_only = true;
}

void tp_chart_add_point(tp_chart *chart, tp_bounded x, tp_bounded y) {
  if (chart->failed) return;
  tp_chart_series *series = chart->series + chart->series_count - 1;
  if (series->count == series->capacity) {
    const size_t capacity = series->capacity > 0 ? 2 * series->capacity : 32;
    tp_chart_point *points = realloc(series->points, capacity * sizeof *points);
    chart->failed = points == NULL;
    if (points == NULL) return;
    series->points = points;
    series->capacity = capacity;
  }
  series->points[series->count++] = (tp_chart_point){.x = x, .y = y};
}

void tp_chart_add_corner(tp_chart *chart, double x, double y) {
  tp_chart_add_point(chart, tp_chart_exactly(x), tp_chart_exactly(y));
}

void tp_chart_add_break(tp_chart *chart) {
  tp_chart_add_corner(chart, NAN, NAN);
}

void tp_chart_add_note(tp_chart *chart, size_t which, const char *text) {
  if (chart->failed) return;
  const tp_chart_series *series = chart->series + chart->series_count - 1;
  series->points[series->count - 1].notes[which] = copy(chart, text);
}

void tp_chart_add_label(tp_chart *chart, double x, double y, tp_label_side side, const char *text) {
  tp_chart_label *label =
      grow(chart, (void **)&chart->labels, &chart->label_count, sizeof *chart->labels);
  if (label == NULL) return;
  *label = (tp_chart_label){
      .panel = chart->panel_count - 1, .x = x, .y = y, .text = copy(chart, text), .side = side};
}

void tp_chart_add_plain_label(tp_chart *chart, double x, double y, tp_label_side side,
                              const char *text) {
  const size_t count = chart->label_count;
  tp_chart_add_label(chart, x, y, side, text);
  if (chart->label_count > count) chart->labels[count].plain = true;
}

void tp_chart_add_legend(tp_chart *chart, const char *text, tp_chart_style style) {
  tp_chart_legend *entry =
      grow(chart, (void **)&chart->legend, &chart->legend_count, sizeof *chart->legend);
  if (entry != NULL) *entry = (tp_chart_legend){copy(chart, text), style};
}

static void free_series(const tp_chart_series *series) {
  for (size_t k = 0; k < TP_CHART_KEYS; k++) free(series->keys[k]);
  for (size_t p = 0; p < series->count; p++) {
    for (size_t k = 0; k < TP_CHART_NOTES; k++) free(series->points[p].notes[k]);
  }
  free(series->points);
}

void tp_chart_free(tp_chart *chart) {
  if (chart == NULL) return;
  for (size_t k = 0; k < chart->panel_count; k++) {
    free(chart->panels[k].title);
    free((char *)chart->panels[k].x.label);
    free((char *)chart->panels[k].y.label);
  }
  for (size_t k = 0; k < chart->series_count; k++) free_series(chart->series + k);
  for (size_t k = 0; k < chart->label_count; k++) free(chart->labels[k].text);
  for (size_t k = 0; k < chart->legend_count; k++) free(chart->legend[k].text);
  for (size_t k = 0; k < chart->source_count; k++) free(chart->sources[k]);
  free(chart->sources);
  free(chart->panels);
  free(chart->series);
  free(chart->labels);
  free(chart->legend);
  free(chart->title);
  free(chart->x_name);
  free(chart->y_name);
  free(chart);
}

tp_status tp_chart_finish(tp_chart *own, tp_chart **chart, tp_message *message) {
  if (own == NULL || own->failed) {
    tp_chart_free(own);
    return tp_fail_memory(message, "the chart");
  }
  *chart = own;
  return TP_OK;
}
