/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A sweep as CSV or JSON, each point written as it is solved. */

#include "common/host.h"
#include "output/encode.h"
#include "report/kept_file.h"
#include "report/results.h"
#include "report/settings.h"
#include "scene/scene.h"

#include <stdlib.h>
#include <string.h>

typedef struct writer {
  tp_sweep_format format;
  bool of_many, of_solid; /* what the scene is of; neither: one block */
  tp_json json;           /* of CSV its text alone */
  tp_text_sink sink;
  bool stopped; /* by the sink */
} writer;

/* Hand over what there is. */
static bool drain(writer *w) {
  tp_text *t = &w->json.text;
  if (t->failed) return false;
  if (t->length > 0) w->stopped = w->stopped || !w->sink.take(w->sink.context, t->data);
  t->length = 0;
  return !w->stopped;
}

/* ---- CSV ---------------------------------------------------------------------------------------
 */

static void add_head(tp_text *t, const tp_settings *set, const writer *w) {
  for (size_t k = 0; k < set->count; k++) {
    tp_csv_setting_name(t, set->items[k].key, set->items[k].unit);
    tp_text_add(t, ",");
  }
  tp_text_add(t, "status");
  if (w->of_many) {
    tp_csv_names_of_system_row(t);
  } else if (w->of_solid) {
    tp_csv_names_of_solid_row(t);
  } else {
    tp_csv_names_of_verdict_row(t);
    tp_csv_names_of_pivot_row(t);
  }
  tp_text_add(t, ",message\n");
}

/* Of a point that was not solved, and of a solid, both cases are NULL. */
static void add_row(tp_text *t, const tp_sweep_point *point, const writer *w, const tp_case *own,
                    const tp_system_case *system) {
  const tp_json_subject x = {.s = point->solution, .system = point->system};
  for (size_t k = 0; k < point->set->count; k++) {
    tp_csv_setting_value(t, point->set->items + k);
    tp_text_add(t, ",");
  }
  tp_text_add(t, "%s", tp_status_meaning(point->status));
  if (w->of_many) {
    tp_csv_fields_of_system_row(t, system, &x);
  } else if (w->of_solid) {
    tp_csv_fields_of_solid_row(t, point->solid, &x);
  } else {
    tp_csv_fields_of_verdict_row(t, own, &x);
    tp_csv_fields_of_pivot_row(t, own, &x);
  }
  tp_text_add(t, ",");
  tp_encode_csv(t, point->message);
  tp_text_add(t, "\n");
}

static void add_rows(tp_text *t, const tp_sweep_point *point, const writer *w) {
  const tp_solution *s = point->solution;
  const tp_block_system *b = point->system;
  if (point->index == 0) add_head(t, point->set, w);
  if (s == NULL && b == NULL) add_row(t, point, w, NULL, NULL);
  for (size_t k = 0; s != NULL && k < s->case_count; k++) {
    add_row(t, point, w, s->cases + k, NULL);
  }
  for (size_t k = 0; b != NULL && k < b->case_count; k++) {
    add_row(t, point, w, NULL, b->cases + k);
  }
}

/* ---- JSON --------------------------------------------------------------------------------------
 */

static void add_point(tp_json *j, const tp_sweep_point *point) {
  const tp_solution *s = point->solution;
  const tp_block_system *b = point->system;
  if (point->index == 0) {
    tp_json_report(j);
    tp_json_array(j, "points", TP_JSON_LIST);
  }
  tp_json_object(j, NULL, TP_JSON_LINE);
  tp_json_subject x = {.s = s, .system = b};
  tp_json_members_of_sweep_point(j, point, &x);
  tp_json_break(j);
  tp_json_array(j, "cases", TP_JSON_LIST);
  for (size_t k = 0; s != NULL && k < s->case_count; k++) {
    tp_json_object(j, NULL, TP_JSON_LINE);
    tp_json_members_of_sweep_row(j, s->cases + k, &x);
    tp_json_close(j);
  }
  for (size_t k = 0; b != NULL && k < b->case_count; k++) {
    tp_json_object(j, NULL, TP_JSON_LINE);
    tp_json_members_of_sweep_system_row(j, b->cases + k, &x);
    tp_json_close(j);
  }
  if (point->solid != NULL) {
    tp_json_object(j, NULL, TP_JSON_LINE);
    tp_json_members_of_sweep_solid_row(j, point->solid, &x);
    tp_json_close(j);
  }
  tp_json_close(j);
  tp_json_close(j);
}

static tp_status end_json(writer *w) {
  char *rest = NULL;
  tp_json_close(&w->json);
  tp_json_close(&w->json);
  const tp_status status = tp_json_finish(&w->json, &rest);
  if (status == TP_OK) (void)w->sink.take(w->sink.context, rest);
  free(rest);
  return status;
}

/* ---- written -----------------------------------------------------------------------------------
 */

static bool write_point(void *context, const tp_sweep_point *point) {
  writer *w = context;
  if (w->format == TP_SWEEP_CSV) {
    add_rows(&w->json.text, point, w);
  } else {
    add_point(&w->json, point);
  }
  return drain(w);
}

tp_status tp_sweep_write(tp_sweep_summary *summary, const tp_scene *scene,
                         const tp_sweep_options *options, tp_sweep_format format, tp_text_sink sink,
                         tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, summary);
  TP_REFUSE_NULL(message, scene);
  TP_REFUSE_NULL(message, options);
  TP_REFUSE_NULL(message, sink.take);
  if (format != TP_SWEEP_CSV && format != TP_SWEEP_JSON) {
    return tp_refuse(message, TP_FAULT_ARGUMENT, (tp_place){0}, "there is no such format");
  }
  writer w = {.format = format,
              .of_many = tp_scene_block_count(scene) > 0,
              .of_solid = tp_scene_is_solid(scene),
              .sink = sink};
  tp_status status = tp_sweep(summary, scene, options, (tp_sweep_sink){write_point, &w}, message);
  if (status == TP_OK && w.json.text.failed) status = tp_fail_memory(message, "the table");
  if (status == TP_OK && format == TP_SWEEP_JSON && !w.stopped) status = end_json(&w);
  tp_text_drop(&w.json.text);
  return status;
}

static bool keep(void *context, const char *text) {
  tp_text *own = context;
  tp_text_append(own, text, strlen(text));
  return !own->failed;
}

tp_status tp_sweep_write_file(tp_sweep_summary *summary, const char *path, const tp_scene *scene,
                              const tp_sweep_options *options, tp_sweep_format format,
                              tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  TP_REFUSE_NULL(message, options);
  TP_REFUSE_NULL(message, summary);
  TP_REFUSE_NULL(message, path);
  tp_text text = {0};
  tp_sweep_summary sum = {.count = 0};
  tp_status status =
      tp_sweep_write(&sum, scene, options, format, (tp_text_sink){keep, &text}, message);
  if (status == TP_OK && text.failed) status = tp_fail_memory(message, "the table");
  if (status == TP_OK)
    status = tp_report_keep_file(scene, path, text.data, text.length, "the table", message);
  if (status == TP_OK) *summary = sum;
  tp_text_drop(&text);
  return status;
}
