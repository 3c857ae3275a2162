/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Scenes of many blocks in one table, a row for each direction: in CSV for other programs, in
 * Markdown to be read. */

#include "common/host.h"
#include "output/encode.h"
#include "report/results.h"
#include "report/settings.h"
#include "report/system_words.h"
#include "report/table_notes.h"
#include "report/words.h"
#include "terms/names.h"

#include <stdlib.h>

/* ---- CSV ---------------------------------------------------------------------------------------
 */

static void add_csv_rows(tp_text *t, const tp_setting_columns *set, const tp_block_system *s) {
  const tp_json_subject x = {.system = s};
  for (size_t k = 0; k < s->case_count; k++) {
    tp_csv_setting_columns_row(t, set, &s->settings);
    tp_encode_csv(t, s->title != NULL ? s->title : "");
    tp_csv_fields_of_system_row(t, s->cases + k, &x);
    tp_text_add(t, "\n");
  }
}

tp_status tp_report_block_systems_csv(char **text, const tp_block_system *const *systems,
                                      size_t count) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(NULL, text);
  TP_REFUSE_NULL(NULL, systems);
  for (size_t k = 0; k < count; k++) TP_REFUSE_NULL(NULL, systems[k]);
  tp_setting_columns set = {.count = 0};
  const tp_settings **lists = calloc(count + 1, sizeof *lists);
  for (size_t k = 0; k < count && lists != NULL; k++) lists[k] = &systems[k]->settings;
  const bool gathered = lists != NULL && tp_setting_columns_gather(&set, lists, count);
  free(lists);
  if (!gathered) return TP_OUT_OF_MEMORY;
  tp_text t = {0};
  tp_csv_setting_columns_head(&t, &set);
  tp_text_add(&t, "scene");
  tp_csv_names_of_system_row(&t);
  tp_text_add(&t, "\n");
  for (size_t k = 0; k < count; k++) add_csv_rows(&t, &set, systems[k]);
  free(set.items);
  return tp_text_finish(&t, text);
}

tp_status tp_report_block_system_csv(char **text, const tp_block_system *system) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(NULL, text);
  TP_REFUSE_NULL(NULL, system);
  return tp_report_block_systems_csv(text, &system, 1);
}

/* ---- Markdown ----------------------------------------------------------------------------------
 */

static void add_goodman_bray(tp_text *t, const tp_goodman_bray *own) {
  tp_text_add(t, " | ");
  if (!own->applies) {
    tp_text_add(t, "-");
  } else if (!own->has_fos) {
    tp_text_add(t, "no friction is enough");
  } else {
    char n[TP_NUMBER_SIZE];
    tp_text_add(t, "%s%s", own->fos_is_least ? "above " : "",
                tp_text_significant_down(n, (tp_bounded){own->fos, 0, NULL}, 5));
  }
}

static void add_support(tp_text *t, const tp_system_case *c) {
  tp_text_add(t, " | ");
  if (!c->has_support) {
    tp_text_add(t, "-");
    return;
  }
  tp_text optimistic = {0};
  tp_text_system_design_support(t, c);
  if (tp_text_system_optimistic_support(&optimistic, c) && !optimistic.failed) {
    tp_text_add(t, " (optimistic: %s)", optimistic.data);
  }
  t->failed = t->failed || optimistic.failed;
  tp_text_drop(&optimistic);
}

static void add_row(tp_text *t, const tp_block_system *s, const tp_system_case *c) {
  char n[TP_NUMBER_SIZE];
  const tp_mechanism collapse = tp_system_case_mechanism(c);
  tp_text_add(t, "| ");
  tp_encode_markdown(t, s->title != NULL ? s->title : "a scene");
  tp_text_add(t, " | %s | %s° | %s | ", tp_direction_name(c->towards),
              tp_text_fixed(n, c->tilt_angle_deg, 3), tp_system_verdict_name(c->verdict));
  tp_text_system_safety(t, &c->governing_fos);
  tp_text_system_against(t, &c->governing_fos);
  if (c->has_required_fos) {
    tp_text_add(t, " (%s required: %s)", tp_text_significant(n, s->required_fos, 5),
                tp_design_name(c->meets_required));
  }
  tp_text_add(t, " | ");
  tp_text_system_factor(t, c);
  tp_text_add(t, " | ");
  tp_text_system_driving(t, c);
  add_goodman_bray(t, &c->goodman_bray);
  tp_text_add(t, " | ");
  tp_text_system_limit(t, c);
  tp_text_add(t, " | %s", collapse != TP_STANDS ? tp_mechanism_name(collapse) : "-");
  add_support(t, c);
  tp_text_add(t, " |\n");
}

tp_status tp_report_block_systems_table(char **text, const tp_block_system *const *systems,
                                        size_t count) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(NULL, text);
  TP_REFUSE_NULL(NULL, systems);
  for (size_t k = 0; k < count; k++) TP_REFUSE_NULL(NULL, systems[k]);
  tp_text t = {0};
  tp_text_add(
      &t, "| scene | towards | tilt or dip | verdict | FoS | forces hold, strength over | forces "
          "hold loads times | FoS, Goodman and Bray | greatest tilt or dip | collapse | support |\n"
          "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
  bool any = false;
  for (size_t k = 0; k < count; k++) {
    const tp_block_system *s = systems[k];
    any = any || s->notes.count + s->settings.count > 0;
    for (size_t c = 0; c < s->case_count; c++) add_row(&t, s, s->cases + c);
  }
  if (any) tp_text_add(&t, "\n");
  for (size_t k = 0; k < count; k++) {
    tp_table_notes(&t, systems[k]->title, &systems[k]->settings, &systems[k]->notes);
  }
  return tp_text_finish(&t, text);
}
