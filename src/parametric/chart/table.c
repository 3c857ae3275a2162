/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A chart's numbers as CSV, one row a point with the shortest decimals, and as JSON. */

#include "chart/chart.h"
#include "common/host.h"
#include "output/encode.h"
#include "output/json.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The fewest digits that give the double back. */
static void add_number(tp_text *t, double value) {
  char text[40];
  for (int digits = 15; digits <= 17; digits++) {
    snprintf(text, sizeof text, "%.*g", digits, value);
    if (strtod(text, NULL) == value) break;
  }
  tp_text_add(t, "%s", text);
}

static void add_row(tp_text *t, const tp_chart *chart, const tp_chart_series *s,
                    const tp_chart_point *p) {
  tp_text_add(t, "%zu", s->panel + 1);
  for (size_t k = 0; k < TP_CHART_KEYS && chart->key_names[k] != NULL; k++) {
    tp_text_add(t, ",");
    if (s->keys[k] != NULL) tp_encode_csv(t, s->keys[k]);
  }
  const double numbers[4] = {p->x.value, p->y.value, p->x.error, p->y.error};
  for (int k = 0; k < 4; k++) {
    tp_text_add(t, ",");
    add_number(t, numbers[k]);
  }
  for (size_t k = 0; k < TP_CHART_NOTES && chart->note_names[k] != NULL; k++) {
    tp_text_add(t, ",");
    if (p->notes[k] != NULL) tp_encode_csv(t, p->notes[k]);
  }
  tp_text_add(t, "\n");
}

tp_status tp_report_chart_csv(char **text, const tp_chart *chart) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(NULL, text);
  TP_REFUSE_NULL(NULL, chart);
  tp_text t = {0};
  tp_text_add(&t, "panel");
  for (size_t k = 0; k < TP_CHART_KEYS && chart->key_names[k] != NULL; k++) {
    tp_text_add(&t, ",%s", chart->key_names[k]);
  }
  tp_text_add(&t, ",");
  tp_encode_csv(&t, chart->x_name);
  tp_text_add(&t, ",");
  tp_encode_csv(&t, chart->y_name);
  tp_text_add(&t, ",x_error,y_error");
  for (size_t k = 0; k < TP_CHART_NOTES && chart->note_names[k] != NULL; k++) {
    tp_text_add(&t, ",%s", chart->note_names[k]);
  }
  tp_text_add(&t, "\n");
  for (size_t k = 0; k < chart->series_count; k++) {
    const tp_chart_series *s = chart->series + k;
    for (size_t p = 0; p < s->count && !s->drawn_only; p++) add_row(&t, chart, s, s->points + p);
  }
  return tp_text_finish(&t, text);
}

static void json_point(tp_json *j, const tp_chart *chart, const tp_chart_point *p) {
  tp_json_object(j, NULL, TP_JSON_LINE);
  tp_json_bounded(j, "x", p->x);
  tp_json_bounded(j, "y", p->y);
  for (size_t k = 0; k < TP_CHART_NOTES && chart->note_names[k] != NULL; k++) {
    if (p->notes[k] != NULL) tp_json_string(j, chart->note_names[k], p->notes[k]);
  }
  tp_json_close(j);
}

static void json_series(tp_json *j, const tp_chart *chart, const tp_chart_series *s) {
  tp_json_object(j, NULL, TP_JSON_LINE);
  tp_json_count(j, "panel", s->panel + 1);
  for (size_t k = 0; k < TP_CHART_KEYS && chart->key_names[k] != NULL; k++) {
    tp_json_string(j, chart->key_names[k], s->keys[k]);
  }
  tp_json_array(j, "points", TP_JSON_LIST);
  for (size_t k = 0; k < s->count; k++) json_point(j, chart, s->points + k);
  tp_json_close(j);
  tp_json_close(j);
}

tp_status tp_report_chart_json(char **text, const tp_chart *chart) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(NULL, text);
  TP_REFUSE_NULL(NULL, chart);
  tp_json j = {0};
  tp_json_report(&j);
  tp_json_string(&j, "chart", chart->kind);
  tp_json_string(&j, "x", chart->x_name);
  tp_json_beside(&j);
  tp_json_string(&j, "y", chart->y_name);
  tp_json_array(&j, "series", TP_JSON_LIST);
  for (size_t k = 0; k < chart->series_count; k++) {
    if (!chart->series[k].drawn_only) json_series(&j, chart, chart->series + k);
  }
  tp_json_close(&j);
  tp_json_close(&j);
  return tp_json_finish(&j, text);
}
