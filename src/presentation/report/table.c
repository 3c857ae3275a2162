/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Several solutions in one table: in Markdown to be read, in CSV for other programs. */

#include "common/host.h"
#include "output/encode.h"
#include "report/onset.h"
#include "report/results.h"
#include "report/settings.h"
#include "report/table_notes.h"
#include "report/words.h"
#include "terms/names.h"

#include <stdlib.h>
#include <string.h>

static void add_angle(tp_text *t, bool known, tp_bounded angle) {
  char n[TP_NUMBER_SIZE];
  tp_text_add(t, " | %s%s", known ? tp_text_fixed(n, angle, 3) : "-", known ? "°" : "");
}

static void add_limit(tp_text *t, const tp_limit *l) {
  add_angle(t, l->kind == TP_LIMIT_AT_ANGLE, l->critical_angle_deg);
  const bool nowhere = l->kind == TP_LIMIT_NOWHERE || l->kind == TP_LIMIT_NOT_ASKED;
  tp_text_add(t, " | %s", nowhere ? "-" : tp_mechanism_name(l->mechanism));
  if (l->tie) tp_text_add(t, ", %s", tp_mechanism_name(l->tied_with));
}

/* Behind the factor what it must reach, and the end of its column. */
static void add_required(tp_text *t, const tp_governing_fos *g) {
  char n[TP_NUMBER_SIZE];
  if (g->has_required_fos) {
    tp_text_add(t, " (%s required: %s)", tp_text_significant(n, g->required_fos, 5),
                tp_design_name(g->meets_required));
  }
  tp_text_add(t, " | ");
}

/* The governing factor and what it is against. */
static void add_fos(tp_text *t, const tp_case *c) {
  const tp_governing_fos *g = &c->governing_fos;
  char n[TP_NUMBER_SIZE];
  const bool number = g->fos.state == TP_FOS_NUMBER;
  tp_text_add(t, " | %s%s", number && g->sliding_judged && !g->complete ? "≤ " : "",
              number                                  ? tp_text_fixed_down(n, g->fos.value, 3)
              : g->fos.state == TP_FOS_UNDEFINED      ? "none"
              : g->fos.state == TP_FOS_UNDECIDED      ? "undecided"
              : g->fos.state == TP_FOS_NO_OVERTURNING ? "unbounded"
                                                      : "-");
  add_required(t, g);
  if (!g->has_factor) {
    tp_text_add(t, g->up_dip ? "fails up-dip" : g->beyond ? "fails before" : "-");
    return;
  }
  const tp_mechanism mechanism = g->factors[g->factor].mechanism;
  tp_text_add(t, "%s",
              mechanism == TP_MECHANISM_UNDECIDED ? "moves" : tp_mechanism_name(mechanism));
  tp_text_add(t, " (%s)", tp_fos_definition_name(g->factors[g->factor].definition));
}

/* Up to which tilt it is certain to stand. */
static void add_onset(tp_text *t, const tp_onset *o) {
  if (o->kind == TP_ONSET_NEVER) {
    tp_text_add(t, " | 90°");
  } else {
    add_angle(t, o->kind == TP_ONSET_AT_ANGLE, o->critical_angle_deg);
  }
}

static const tp_pivot *governing_pivot(const tp_case *c) {
  return c->has_toppling_pivot ? c->pivots + c->toppling_pivot : NULL;
}

static void add_case(tp_text *t, const tp_solution *s, const tp_case *c) {
  const tp_pivot *pivot = governing_pivot(c);
  const bool goes_on = c->limit.base_beyond_toe;
  tp_text_add(t, "| ");
  tp_encode_markdown(t, s->title != NULL ? s->title : "a scene");
  tp_text_add(t, " | %s", tp_direction_name(c->towards));
  add_angle(t, s->has_tilt_angle, s->tilt_angle_deg);
  tp_text_add(t, " | ");
  if (s->has_tilt_angle) {
    tp_text_verdict(t, c);
  } else {
    tp_text_add(t, "-");
  }
  add_fos(t, c);
  add_onset(t, &c->onset);
  tp_text_add(t, " | %s", pivot != NULL ? tp_pivot_kind_name(pivot->kind) : "-");
  add_angle(t, pivot != NULL && !pivot->never && !pivot->always,
            pivot != NULL ? pivot->critical_angle_deg : (tp_bounded){0});
  add_angle(t, c->sliding.known && !c->sliding.never && !c->sliding.always,
            c->sliding.critical_angle_deg);
  add_limit(t, goes_on ? &c->limit_otherwise : &c->limit);
  add_limit(t, goes_on ? &c->limit : &c->limit_otherwise);
  tp_text_add(t, " |\n");
}

static void add_all_notes(tp_text *t, const tp_solution *const *solutions, size_t count) {
  bool any = false;
  for (size_t k = 0; k < count; k++) {
    any = any || solutions[k]->notes.count + solutions[k]->settings.count > 0;
  }
  if (any) tp_text_add(t, "\n");
  for (size_t k = 0; k < count; k++) {
    tp_table_notes(t, solutions[k]->title, &solutions[k]->settings, &solutions[k]->notes);
  }
}

static const char *const columns =
    "| scene | towards | tilt | verdict | FoS | against | certain to stand up to | toe | moments | "
    "φ + i | base ends at the toe: limit | mechanism | base extends: limit | mechanism |\n"
    "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n";

tp_status tp_report_table(char **text, const tp_solution *const *solutions, size_t count) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(NULL, text);
  TP_REFUSE_NULL(NULL, solutions);
  for (size_t k = 0; k < count; k++) TP_REFUSE_NULL(NULL, solutions[k]);
  tp_text t = {0};
  tp_text_add(&t, "%s", columns);
  for (size_t k = 0; k < count; k++) {
    for (size_t c = 0; c < solutions[k]->case_count; c++) {
      add_case(&t, solutions[k], solutions[k]->cases + c);
    }
  }
  add_all_notes(&t, solutions, count);
  return tp_text_finish(&t, text);
}

/* ---- CSV ---------------------------------------------------------------------------------------
 */

static bool gather(tp_setting_columns *all, const tp_solution *const *solutions, size_t count) {
  const tp_settings **lists = calloc(count + 1, sizeof *lists);
  if (lists == NULL) return false;
  for (size_t k = 0; k < count; k++) lists[k] = &solutions[k]->settings;
  const bool done = tp_setting_columns_gather(all, lists, count);
  free(lists);
  return done;
}

/* What is required, where any of the scenes requires something. */
static bool is_any_required(const tp_solution *const *solutions, size_t count) {
  bool any = false;
  for (size_t k = 0; k < count; k++) {
    for (size_t c = 0; c < solutions[k]->case_count; c++) {
      any = any || solutions[k]->cases[c].governing_fos.has_required_fos;
    }
  }
  return any;
}

static void add_required_fields(tp_text *t, const tp_governing_fos *g) {
  tp_csv_bounded(t, g->has_required_fos, g->required_fos);
  tp_csv_words(t, g->has_required_fos ? tp_design_name(g->meets_required) : NULL);
  tp_csv_bounded(t, g->has_design_utilisation, g->design_utilisation);
}

static void write_csv(tp_text *t, const tp_setting_columns *all,
                      const tp_solution *const *solutions, size_t count) {
  const bool required = is_any_required(solutions, count);
  tp_csv_setting_columns_head(t, all);
  tp_text_add(t, "scene");
  tp_csv_names_of_verdict_row(t);
  if (required) {
    tp_text_add(t, ",required_fos,required_fos_error,meets_required,design_utilisation,"
                   "design_utilisation_error");
  }
  tp_text_add(t, "\n");
  for (size_t k = 0; k < count; k++) {
    const tp_solution *s = solutions[k];
    const tp_json_subject x = {.s = s};
    for (size_t c = 0; c < s->case_count; c++) {
      tp_csv_setting_columns_row(t, all, &s->settings);
      tp_encode_csv(t, s->title != NULL ? s->title : "");
      tp_csv_fields_of_verdict_row(t, s->cases + c, &x);
      if (required) add_required_fields(t, &s->cases[c].governing_fos);
      tp_text_add(t, "\n");
    }
  }
}

tp_status tp_report_csv(char **text, const tp_solution *const *solutions, size_t count) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(NULL, text);
  TP_REFUSE_NULL(NULL, solutions);
  for (size_t k = 0; k < count; k++) TP_REFUSE_NULL(NULL, solutions[k]);
  tp_setting_columns all;
  tp_text t = {0};
  if (!gather(&all, solutions, count)) return TP_OUT_OF_MEMORY;
  write_csv(&t, &all, solutions, count);
  free(all.items);
  return tp_text_finish(&t, text);
}
