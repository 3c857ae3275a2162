/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* All that is said of one scene, and what the other parts are made of. */

#define _GNU_SOURCE
#include "sayings.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

char **next_saying(sayings *s) {
  return s->texts + s->count++;
}

void note_status(sayings *s, tp_status status, const tp_message *message) {
  char **text = next_saying(s);
  if (asprintf(text, "status %d: %s", (int)status, status == TP_OK ? "" : message->text) < 0) {
    *text = NULL;
  }
}

void note_number(sayings *s, long number) {
  char **text = next_saying(s);
  if (asprintf(text, "%ld", number) < 0) *text = NULL;
}

/* Times differ from run to run, and must be printed alike. */
void same_times(tp_solution *solution) {
  for (size_t k = 0; k < solution->effect_count; k++) solution->effects[k].seconds = 0.00123456789;
}

void say_file(sayings *s, const char *path) {
  FILE *file = fopen(path, "rb");
  char *text = calloc(1, 1 << 20);
  if (file != NULL) fread(text, 1, (1 << 20) - 1, file);
  if (file != NULL) fclose(file);
  /* Cairo counts the surfaces of a process */
  for (char *at = text; at != NULL && (at = strstr(at, "surface")) != NULL;) {
    at += strlen("surface");
    memmove(at, at + strspn(at, "0123456789"), strlen(at + strspn(at, "0123456789")) + 1);
  }
  *next_saying(s) = text;
}

void say_reports(sayings *s, const tp_solution *solution) {
  typedef tp_status (*report)(char **text, const tp_solution *solution);
  static const report reports[] = {tp_report_text, tp_report_json, tp_report_elements,
                                   tp_report_notes, tp_report_effects};
  for (size_t k = 0; k < sizeof reports / sizeof reports[0]; k++) {
    if (reports[k](next_saying(s), solution) != TP_OK) s->count--;
  }
  if (tp_report_json_pivots(next_saying(s), solution, TP_PIVOTS_ALL) != TP_OK) s->count--;
  const tp_solution *const both[2] = {solution, solution};
  if (tp_report_table(next_saying(s), both, 2) != TP_OK) s->count--;
  if (tp_report_csv(next_saying(s), both, 2) != TP_OK) s->count--;
  note_number(s, tp_solution_is_undecided(solution));
  note_number(s, tp_solution_meets(solution, 1.25));
  if (solution->case_count > 0) note_number(s, tp_case_meets(solution->cases, 1.25));
}

static bool consent(void *context) {
  ++*(int *)context;
  return true;
}

static void say_figures(sayings *s, const tp_scene *scene, const tp_solution *solution) {
  tp_message message = {.text = ""};
  char path[100];
  int asked = 0;
  const tp_figure_consent ask = {consent, &asked};
  snprintf(path, sizeof path, "%s/figure.svg", s->folder);
  note_status(s, tp_report_figure(path, scene, solution, &message), &message);
  say_file(s, path);
  note_status(s, tp_report_figure_if(path, scene, solution, ask, &message), &message);
  say_file(s, path);
  note_number(s, asked);
  static const char *const kinds[] = {"html", "md", "pdf"};
  tp_sheet_options options = tp_sheet_options_default();
  options.times = 0;
  options.date = "2026-11-22";
  for (size_t k = 0; k < sizeof kinds / sizeof kinds[0]; k++) {
    snprintf(path, sizeof path, "%s/sheet.%s", s->folder, kinds[k]);
    note_status(s, tp_report_sheet(path, scene, solution, &options, &message), &message);
    say_file(s, path);
    note_number(s, tp_sheet_is_file_name(path));
    note_number(s, tp_sheet_is_language(tp_sheet_languages()));
  }
}

void say_solved(sayings *s, const tp_scene *scene, bool elements, int digits, bool figure) {
  tp_message message = {.text = ""};
  tp_solution *solution = NULL;
  tp_solve_options options = tp_solve_options_default();
  options.elements = elements;
  options.digits = digits;
  note_status(s, tp_solve(&solution, scene, &options, &message), &message);
  if (solution == NULL) return;
  same_times(solution);
  say_reports(s, solution);
  if (tp_report_json_outlines(next_saying(s), scene, solution, TP_PIVOTS_ALL, &message) != TP_OK) {
    s->count--;
  }
  if (figure) say_figures(s, scene, solution);
  tp_solution_free(solution);
}

void sayings_forget(sayings *s) {
  for (size_t k = 0; k < s->count; k++) tp_text_free(s->texts[k]);
  tp_cleanup();
  s->count = 0;
}
