/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Reads a scene; of one with cases all are solved, and the scene of the one that governs is read.
 */

#include "cli/solve_cases.h"

#include "cli/sheet.h"

#include <stdio.h>
#include <stdlib.h>

/* The scene of a case with what is set. */
static tp_status read_governing(tp_scene **scene, const char *path, const tp_solve_words *words,
                                const char *name, tp_message *message) {
  tp_cli_settings settings = words->settings;
  settings.load_case = name;
  return tp_cli_read_scene(scene, path, &settings, message);
}

/* A scene without cases, or of one that was chosen, is read at once; settings may be of numbers
 * that some case alone gives. `all` NULL: it has none. */
static tp_status read_scene(tp_scene **scene, tp_scene **all, const char *path,
                            const tp_cli_settings *settings, tp_message *message) {
  tp_scene *read = NULL;
  const tp_status status = tp_cli_read_scene(&read, path, settings, message);
  if (status == TP_OK && tp_scene_load_case_count(read) == 0) {
    *scene = read;
    return TP_OK;
  }
  if (status == TP_OK && settings->count == 0) {
    *all = read;
    return TP_OK;
  }
  tp_scene_free(read);
  if (settings->load_case != NULL || settings->count == 0) return status;
  tp_cli_settings plain = *settings;
  tp_message why = {.text = ""};
  plain.count = 0;
  read = NULL;
  if (tp_cli_read_scene(&read, path, &plain, &why) != TP_OK) return status;
  if (tp_scene_load_case_count(read) == 0) {
    tp_scene_free(read);
    return status;
  }
  *all = read;
  message->text[0] = '\0';
  return TP_OK;
}

tp_status tp_cli_refuse_one_case(const char *path, const char *option, tp_message *message) {
  if (option == NULL) return TP_OK;
  snprintf(message->text, sizeof message->text,
           "%s: %s is of one load case, and the scene has several: choose one with --case NAME",
           path, option);
  return TP_BAD_INPUT;
}

tp_status tp_cli_solve_cases(tp_cli_solved *solved, const char *path, const tp_solve_words *words,
                             const tp_solve_options *options, tp_message *message) {
  const tp_cli_settings *settings = &words->settings;
  *solved = (tp_cli_solved){NULL, NULL, NULL};
  tp_scene *all = NULL;
  tp_status status = read_scene(&solved->scene, &all, path, settings, message);
  if (status != TP_OK || all == NULL) return status;
  if (tp_scene_block_count(all) > 0) {
    solved->scene = all;
    return TP_OK;
  }
  /* solutions of all cases say nothing of one of them */
  const char *option = words->find.key != NULL ? "--find" : words->outlines ? "--outlines" : NULL;
  status = tp_cli_refuse_one_case(path, option, message);
  if (status == TP_OK) {
    status = tp_solve_load_cases(&solved->cases, all, settings->items, settings->count, options,
                                 message);
  }
  tp_scene_free(all);
  if (status != TP_OK) return status;
  status = read_governing(&solved->scene, path, words, solved->cases->cases->name, message);
  if (status != TP_OK) return status;
  if (words->report != NULL && !words->elements) {
    return tp_cli_solve_for_sheet(&solved->solution, solved->scene, options, message);
  }
  solved->solution = solved->cases->cases->solution;
  return TP_OK;
}

void tp_cli_solved_clear(tp_cli_solved *solved) {
  tp_scene_free(solved->scene);
  if (solved->cases == NULL || solved->solution != solved->cases->cases->solution) {
    tp_solution_free(solved->solution);
  }
  tp_load_cases_free(solved->cases);
  *solved = (tp_cli_solved){NULL, NULL, NULL};
}

tp_status tp_cli_print_rows(const tp_solve_words *a, const tp_cli_solved *solved, size_t count,
                            int *ended) {
  size_t rows = 0;
  for (size_t k = 0; k < count; k++) rows += solved[k].cases != NULL ? solved[k].cases->count : 1;
  const tp_solution **own = calloc(rows + 1, sizeof *own);
  if (own == NULL) return TP_OUT_OF_MEMORY;
  rows = 0;
  for (size_t k = 0; k < count; k++) {
    const tp_load_cases *cases = solved[k].cases;
    for (size_t n = 0; cases != NULL && n < cases->count; n++) {
      own[rows++] = cases->cases[n].solution;
    }
    if (cases == NULL) own[rows++] = solved[k].solution;
  }
  char *report = NULL;
  const tp_status status =
      a->csv ? tp_report_csv(&report, own, rows) : tp_report_table(&report, own, rows);
  if (status == TP_OK) *ended = tp_cli_graver(*ended, tp_cli_print(report));
  free(report);
  free(own);
  return status;
}
