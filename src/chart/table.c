/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A chart's numbers: as CSV, a row for every point, and as JSON. */

#include "chart/chart.h"
#include "host.h"
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

static void add_member(tp_text *t, const char *key, const char *text) {
  tp_encode_json(t, key);
  tp_text_add(t, ": ");
  if (text == NULL) {
    tp_text_add(t, "null");
  } else {
    tp_encode_json(t, text);
  }
}

static void add_json_point(tp_text *t, const tp_chart *chart, const tp_chart_point *p) {
  tp_text_add(t, "{");
  tp_json_number(t, "x", p->x);
  tp_text_add(t, ", ");
  tp_json_number(t, "y", p->y);
  for (size_t k = 0; k < TP_CHART_NOTES && chart->note_names[k] != NULL; k++) {
    if (p->notes[k] == NULL) continue;
    tp_text_add(t, ", ");
    add_member(t, chart->note_names[k], p->notes[k]);
  }
  tp_text_add(t, "}");
}

tp_status tp_report_chart_json(char **text, const tp_chart *chart) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(NULL, text);
  TP_REFUSE_NULL(NULL, chart);
  tp_text t = {0};
  bool any = false;
  tp_text_add(&t, "{\n  \"topple\": \"" TP_VERSION "\",\n  \"chart\": \"%s\",\n  ", chart->kind);
  add_member(&t, "x", chart->x_name);
  tp_text_add(&t, ", ");
  add_member(&t, "y", chart->y_name);
  tp_text_add(&t, ",\n  \"series\": [");
  for (size_t k = 0; k < chart->series_count; k++) {
    const tp_chart_series *s = chart->series + k;
    if (s->drawn_only) continue;
    tp_text_add(&t, "%s\n    {\"panel\": %zu, ", any ? "," : "", s->panel + 1);
    any = true;
    for (size_t j = 0; j < TP_CHART_KEYS && chart->key_names[j] != NULL; j++) {
      add_member(&t, chart->key_names[j], s->keys[j]);
      tp_text_add(&t, ", ");
    }
    tp_text_add(&t, "\"points\": [");
    for (size_t p = 0; p < s->count; p++) {
      tp_text_add(&t, "%s\n      ", p > 0 ? "," : "");
      add_json_point(&t, chart, s->points + p);
    }
    tp_text_add(&t, "]}");
  }
  tp_text_add(&t, "]\n}\n");
  return tp_text_finish(&t, text);
}
