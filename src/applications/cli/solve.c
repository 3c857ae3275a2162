/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* topple solve SCENE...: solves scenes, prints report, table or JSON, draws, searches with --find,
 * and sets the exit status (docs/solve.md). */

#define _GNU_SOURCE /* asprintf */

#include "cli/drawn_report.h"
#include "cli/sheet.h"
#include "cli/signals.h"
#include "cli/solve_cases.h"
#include "cli/solve_judge.h"
#include "cli/solve_solid.h"
#include "cli/solve_system.h"
#include "cli/verdict_colours.h"
#include "cli/watch.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static tp_status print_text(const tp_scene *scene, const tp_solution *solution,
                            const tp_solve_words *a, int *ended) {
  char *report = NULL, *account = NULL, *effects = NULL, *drawing = NULL;
  tp_status status = tp_report_text(&report, solution);
  if (status == TP_OK && a->verbose) status = tp_report_effects(&effects, solution);
  if (status == TP_OK && a->verbose) status = tp_report_drawing(&drawing, scene);
  if (status == TP_OK && a->elements) status = tp_report_elements(&account, solution);
  if (status == TP_OK && *ended == 0) *ended = tp_cli_print_verdicts(report);
  free(report);
  if (drawing != NULL) status = tp_cli_print_report(status, drawing, ended);
  if (effects != NULL) status = tp_cli_print_report(status, effects, ended);
  if (account != NULL) status = tp_cli_print_report(status, account, ended);
  return status;
}

/* The table of all cases, before the report of the one that governs. */
static tp_status print_cases(const tp_load_cases *cases, int *ended) {
  char *report = NULL;
  const tp_status status = tp_report_load_cases(&report, cases);
  const tp_status printed = tp_cli_print_report(status, report, ended);
  if (printed == TP_OK && *ended == 0) *ended = tp_cli_print("\n");
  return printed;
}

static tp_status print_solution(const tp_cli_solved *own, const tp_solve_words *a, int *ended,
                                tp_message *message) {
  if (!a->json) {
    const tp_status status = own->cases != NULL ? print_cases(own->cases, ended) : TP_OK;
    return status == TP_OK ? print_text(own->scene, own->solution, a, ended) : status;
  }
  char *report = NULL;
  const tp_status status =
      own->cases != NULL ? tp_report_load_cases_json(&report, own->cases, a->pivots)
      : a->outlines
          ? tp_report_json_outlines(&report, own->scene, own->solution, a->pivots, message)
          : tp_report_json_pivots(&report, own->solution, a->pivots);
  return tp_cli_print_report(status, report, ended);
}

/* The key of the direction of the anchor whose force is looked for, for the caller to free: as the
 * scene gives it. NULL when memory is exhausted. */
static char *direction_key(const tp_scene *scene, const char *force) {
  const char *dot = strrchr(force, '.');
  const int length = dot != NULL ? (int)(dot - force) : (int)strlen(force);
  char *key = NULL;
  tp_bounded number;
  tp_message unused;
  if (asprintf(&key, "%.*s.dip_deg", length, force) < 0) return NULL;
  if (tp_scene_number(&number, scene, key, &unused) == TP_OK) return key;
  free(key);
  return asprintf(&key, "%.*s.direction_deg", length, force) < 0 ? NULL : key;
}

static tp_status print_found(const tp_scene *scene, const tp_solution *solution,
                             const tp_solve_words *a, int *ended, tp_message *message) {
  tp_found *found = NULL;
  char *report = NULL, *notes = NULL;
  tp_find_options options = a->find;
  char *direction = a->least_force ? direction_key(scene, options.key) : NULL;
  options.least_over = direction;
  tp_status status = a->least_force && direction == NULL
                         ? TP_OUT_OF_MEMORY
                         : tp_find(&found, scene, &options, message);
  if (status == TP_OK) {
    status = a->json ? tp_report_found_json(&report, found, solution)
                     : tp_report_found(&report, found, &a->find);
  }
  if (status == TP_OK && !a->json) status = tp_report_notes(&notes, solution);
  status = tp_cli_print_report(status, report, ended);
  if (notes != NULL) status = tp_cli_print_report(status, notes, ended);
  tp_found_free(found);
  free(direction);
  return status;
}

static tp_status solve_scene(tp_cli_solved *own, const char *path, const tp_solve_words *a,
                             tp_message *message) {
  tp_solve_options solve = tp_solve_options_default();
  solve.elements = a->elements;
  solve.digits = a->digits;
  solve.level = a->level;
  solve.pivots = a->figure != NULL || a->report != NULL ? TP_PIVOTS_ALL : a->pivots;
  const tp_status status = tp_cli_solve_cases(own, path, a, &solve, message);
  if (status != TP_OK || own->solution != NULL) return status;
  const bool of_many = tp_scene_block_count(own->scene) > 0;
  if (tp_scene_is_solid(own->scene)) return tp_cli_check_solid(path, a, message);
  if (of_many || a->animation != NULL) return tp_cli_check_system(path, a, of_many, message);
  return a->report != NULL && !a->elements
             ? tp_cli_solve_for_sheet(&own->solution, own->scene, &solve, message)
             : tp_solve(&own->solution, own->scene, &solve, message);
}

/* ---- several scenes ----------------------------------------------------------------------------
 */

/* Of one scene alone: the others go on. */
static bool is_of_scene(tp_status status) {
  return status == TP_BAD_INPUT || status == TP_NO_ANSWER || status == TP_UNDECIDED;
}

/* Those that can be solved, in their order; what is wrong with the others is told. */
static tp_status solve_all(tp_cli_solved *solved, const char **paths, size_t *count, int *ended,
                           const tp_solve_words *a, tp_message *message) {
  tp_status status = TP_OK;
  for (int k = 0; k < a->scene_count && status == TP_OK; k++) {
    tp_cli_solved *own = solved + *count;
    status = solve_scene(own, a->scenes[k], a, message);
    if (status == TP_OK) {
      paths[(*count)++] = a->scenes[k];
      continue;
    }
    tp_cli_solved_clear(own);
    if (is_of_scene(status)) {
      *ended = tp_cli_graver(*ended, tp_cli_end(status, message, 0));
      message->text[0] = '\0';
      status = TP_OK;
    }
  }
  return status;
}

static int end(const tp_cli_solved *own, const tp_solve_words *a, const char *path) {
  return own->cases != NULL ? tp_cli_judge_cases(own->cases, a, path)
                            : tp_cli_judge(own->solution, a, path);
}

/* Scenes with a report of their own: of many blocks, and of a solid. */
static bool stands_alone(const tp_scene *scene) {
  return tp_scene_block_count(scene) > 0 || tp_scene_is_solid(scene);
}

static tp_status solve_alone(const tp_cli_solved *solved, const tp_solve_words *a, int *ended,
                             tp_message *message) {
  const tp_scene *scene = solved->scene;
  if (tp_scene_load_case_count(scene) > 0) {
    const char *path = a->scene;
    const tp_status status = tp_cli_check_cases_of_many(a->scene, a, message);
    return status == TP_OK ? tp_cli_solve_systems(solved, &path, 1, a, ended, message) : status;
  }
  return tp_scene_is_solid(scene) ? tp_cli_solve_solid(scene, a, ended, message)
                                  : tp_cli_solve_system(scene, a, ended, message);
}

static tp_status print_solved(const tp_cli_solved *solved, const char **paths, size_t count,
                              const tp_solve_words *a, int *ended, tp_message *message) {
  if (count == 1 && tp_scene_is_solid(solved[0].scene)) {
    return solve_alone(solved, a, ended, message);
  }
  bool of_many = false;
  tp_status status = tp_cli_check_kinds(&of_many, solved, paths, count, message);
  if (status != TP_OK || count == 0) return status;
  if (of_many) return tp_cli_solve_systems(solved, paths, count, a, ended, message);
  status = tp_cli_print_rows(a, solved, count, ended);
  for (size_t k = 0; k < count && status == TP_OK; k++) {
    *ended = tp_cli_graver(*ended, end(solved + k, a, paths[k]));
  }
  return status;
}

static tp_status print_table(const tp_solve_words *a, int *ended, tp_message *message) {
  size_t count = 0;
  tp_cli_solved *solved = calloc((size_t)a->scene_count, sizeof *solved);
  const char **paths = calloc((size_t)a->scene_count, sizeof *paths);
  tp_status status = solved != NULL && paths != NULL ? TP_OK : TP_OUT_OF_MEMORY;
  if (status == TP_OK) status = solve_all(solved, paths, &count, ended, a, message);
  if (status == TP_OK) status = print_solved(solved, paths, count, a, ended, message);
  for (size_t k = 0; solved != NULL && k < count; k++) tp_cli_solved_clear(solved + k);
  free(solved);
  free(paths);
  return status;
}

/* ---- one scene ---------------------------------------------------------------------------------
 */

typedef struct reported {
  const tp_cli_solved *solved;
  const tp_solve_words *words;
} reported;

static tp_status print_reported(const void *of, int *ended, tp_message *message) {
  const reported *own = of;
  return print_solution(own->solved, own->words, ended, message);
}

static tp_status print_and_draw(const tp_solve_words *a, const tp_cli_solved *solved, int *ended,
                                tp_message *message) {
  const reported own = {solved, a};
  tp_cli_drawn_report report = {.print = print_reported, .of = &own, .ended = ended};
  const tp_status drawn = tp_cli_draw(a->figure, solved->scene, solved->solution,
                                      tp_cli_drawn_report_consent(&report), message);
  return tp_cli_drawn_report_end(&report, drawn, message);
}

static tp_status write_report(const tp_solve_words *a, const tp_cli_solved *own,
                              tp_message *message) {
  tp_sheet_options options;
  tp_cli_date date;
  const tp_status status = tp_cli_sheet_options(&options, &date, message);
  options.language = a->language;
  options.load_cases = own->cases;
  return status == TP_OK
             ? tp_cli_write_sheet(a->report, own->scene, own->solution, &options, message)
             : status;
}

static tp_status print_one(const tp_solve_words *a, int *ended, tp_message *message) {
  tp_cli_solved own;
  tp_status status = solve_scene(&own, a->scene, a, message);
  if (status == TP_OK && stands_alone(own.scene)) {
    status = solve_alone(&own, a, ended, message);
    tp_cli_solved_clear(&own);
    return status;
  }
  if (status == TP_OK) {
    status = a->find.key != NULL ? print_found(own.scene, own.solution, a, ended, message)
             : a->figure != NULL ? print_and_draw(a, &own, ended, message)
                                 : print_solution(&own, a, ended, message);
  }
  if (status == TP_OK && *ended == 0 && a->report != NULL) {
    status = write_report(a, &own, message);
  }
  if (status == TP_OK && *ended == 0 && a->profile != NULL) {
    status = tp_scene_write_profile(a->profile, own.scene, message);
  }
  if (status == TP_OK && *ended == 0 && a->find.key == NULL) *ended = end(&own, a, a->scene);
  tp_cli_solved_clear(&own);
  return status;
}

/* ---- again and again ---------------------------------------------------------------------------
 */

/* Once, as without --watch; what is wrong with the scene is told, and the watch goes on. */
static bool print_again(void *context) {
  const tp_solve_words *a = context;
  tp_message message = {.text = ""};
  int ended = 0;
  const tp_status status = print_one(a, &ended, &message);
  (void)tp_cli_end(status, &message, ended);
  if (ended == TP_EXIT_SYSTEM) return false; /* nobody reads any more */
  tp_cli_tell("-- watching the scene and the files that it names; ctrl-C ends --");
  return true;
}

static tp_status watch(const tp_solve_words *a, tp_message *message) {
  tp_solve_words own = *a;
  return tp_cli_watch(a->scene, print_again, &own, message);
}

static tp_status solve(const void *words, int *ended, tp_message *message) {
  const tp_solve_words *a = words;
  if (a->batch.asked) {
    return tp_cli_solve_batch(&a->batch, a->scene,
                              a->json    ? TP_CLI_BATCH_JSON
                              : a->csv   ? TP_CLI_BATCH_CSV
                              : a->table ? TP_CLI_BATCH_MARKDOWN
                                         : TP_CLI_BATCH_TEXT,
                              ended, message);
  }
  if (a->watch && access(a->scene, R_OK) == 0) return watch(a, message);
  return a->table || a->csv ? print_table(a, ended, message) : print_one(a, ended, message);
}

int tp_cli_solve(int argc, char **argv) {
  tp_solve_words a = tp_solve_words_default();
  const int ended = tp_cli_run(&tp_solve_parser, &a, solve, argc, argv);
  tp_cli_end_by_signal();
  return ended;
}
