/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* topple solve SCENE...: solves scenes, prints report, table or JSON, draws, searches with --find,
 * and sets the exit status (docs/solve.md). */

#define _GNU_SOURCE /* asprintf */

#include "cli/sheet.h"
#include "cli/signals.h"
#include "cli/solve_words.h"
#include "cli/verdict_colours.h"
#include "cli/watch.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static const char *direction(const tp_case *c) {
  return c->towards == TP_TOWARDS_LEFT ? "left" : "right";
}

static const char *stance(const tp_solution *solution) {
  return solution->frame.world ? "as it lies," : "tilted";
}

/* What a case leaves open; NULL: nothing. */
static const char *what_is_open(const tp_case *c) {
  if (c->limit.kind == TP_LIMIT_UNDECIDED) return "the limit by contact forces";
  if (c->limit.fos.state == TP_FOS_UNDECIDED || c->onset.fos.state == TP_FOS_UNDECIDED)
    return "the factor of safety by contact forces";
  if (c->onset.kind == TP_ONSET_UNDECIDED) return "the tilt up to which it is certain to stand";
  if (c->mechanism == TP_MECHANISM_UNDECIDED || c->first == TP_MECHANISM_UNDECIDED) {
    return "the mechanism";
  }
  return NULL;
}

/* That, why, and what would help. */
static void print_open(const tp_case *c, const tp_solution *solution, const char *scene) {
  const char *what = what_is_open(c);
  if (what == NULL) return;
  tp_cli_complain(
      "%s: undecided at %ld bits: %s, %s towards the %s; %s", scene, solution->bits, what,
      stance(solution), direction(c),
      c->limit.too_dear || c->onset.too_dear
          ? "its proof exceeds the work allowed: coordinates and loads with fewer digits help, "
            "or a tilt farther from the critical one"
          : "the deciding quantity is too close to a tie for these bits, or the case holds at "
            "single tilts only: slightly different friction, cohesion or tilt decides it");
}

/* Why a case does not meet the design factor. */
static void print_short_of(const tp_case *c, const tp_solution *solution, double design_fos,
                           const char *scene) {
  const tp_governing_fos *g = &c->governing_fos;
  const char *why =
      g->fos.state == TP_FOS_NO_TILT ? "the scene gives no tilt, so no factor: add tilt.angle_deg"
      : !g->sliding_judged
          ? "sliding is not judged: the scene gives no friction angle; add friction_angle_deg"
      : c->mechanism != TP_STANDS && c->mechanism != TP_INTERLOCKED
          ? "at this tilt it is not certain to stand"
          : "its governing factor is below";
  tp_cli_complain("%s: %s towards the %s, the design factor of safety %g is not met: %s", scene,
                  stance(solution), direction(c), design_fos, why);
}

/* By the factor that is asked for, else by that of the scene. */
static int judge(const tp_solution *solution, const tp_solve_words *a, const char *scene) {
  const tp_governing_fos *g = &solution->cases[0].governing_fos;
  if (!a->has_design_fos && !g->has_required_fos) return 0;
  const double design_fos = a->has_design_fos ? a->design_fos : g->required_fos.value;
  const tp_design all = tp_solution_meets(solution, design_fos);
  if (all == TP_DESIGN_MET) return 0;
  if (all == TP_DESIGN_OPEN) {
    tp_cli_complain("%s: whether the design factor of safety %g is met is undecided", scene,
                    design_fos);
    return tp_status_exit(TP_UNDECIDED);
  }
  for (size_t k = 0; k < solution->case_count; k++) {
    if (tp_case_meets(solution->cases + k, design_fos) == TP_DESIGN_NOT_MET) {
      print_short_of(solution->cases + k, solution, design_fos, scene);
    }
  }
  return TP_EXIT_REFUTED;
}

/* After the report: what it leaves open is a failure of its own, and so is a design factor that is
 * not met, which is certain and comes before it. */
static int end_open(const tp_solution *solution, const tp_solve_words *a, const char *scene) {
  const int judged = judge(solution, a, scene);
  if (!tp_solution_is_undecided(solution)) return judged;
  for (size_t k = 0; k < solution->case_count; k++) {
    print_open(solution->cases + k, solution, scene);
  }
  if (solution->open_number) {
    tp_cli_complain("%s: a number is not certain to %d digit%s at %ld bits, and is given with its "
                    "actual bound",
                    scene, solution->digits, solution->digits == 1 ? "" : "s", solution->bits);
  }
  return judged != 0 ? judged : tp_status_exit(TP_UNDECIDED);
}

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

static tp_status print_solution(const tp_scene *scene, const tp_solution *solution,
                                const tp_solve_words *a, int *ended, tp_message *message) {
  if (!a->json) return print_text(scene, solution, a, ended);
  char *report = NULL;
  const tp_status status =
      a->outlines ? tp_report_json_outlines(&report, scene, solution, a->pivots, message)
                  : tp_report_json_pivots(&report, solution, a->pivots);
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

static tp_status solve_scene(tp_solution **solution, tp_scene **scene, const char *path,
                             const tp_solve_words *a, tp_message *message) {
  tp_solve_options solve = tp_solve_options_default();
  solve.elements = a->elements;
  solve.digits = a->digits;
  solve.level = a->level;
  solve.pivots = a->figure != NULL || a->report != NULL ? TP_PIVOTS_ALL : a->pivots;
  tp_status status = tp_cli_read_scene(scene, path, &a->settings, message);
  if (status != TP_OK) return status;
  return a->report != NULL && !a->elements
             ? tp_cli_solve_for_sheet(solution, *scene, &solve, message)
             : tp_solve(solution, *scene, &solve, message);
}

/* ---- several scenes ----------------------------------------------------------------------------
 */

/* Of one scene alone: the others go on. */
static bool is_of_scene(tp_status status) {
  return status == TP_BAD_INPUT || status == TP_NO_ANSWER || status == TP_UNDECIDED;
}

/* Those that can be solved, in their order; what is wrong with the others is told. */
static tp_status solve_all(tp_solution **solutions, const char **paths, size_t *count, int *ended,
                           const tp_solve_words *a, tp_message *message) {
  tp_status status = TP_OK;
  for (int k = 0; k < a->scene_count && status == TP_OK; k++) {
    tp_scene *scene = NULL;
    status = solve_scene(solutions + *count, &scene, a->scenes[k], a, message);
    tp_scene_free(scene);
    if (status == TP_OK) {
      paths[(*count)++] = a->scenes[k];
    } else if (is_of_scene(status)) {
      *ended = tp_cli_graver(*ended, tp_cli_end(status, message, 0));
      message->text[0] = '\0';
      status = TP_OK;
    }
  }
  return status;
}

static tp_status print_table(const tp_solve_words *a, int *ended, tp_message *message) {
  const size_t most = (size_t)a->scene_count;
  size_t count = 0;
  char *report = NULL;
  tp_solution **solutions = calloc(most, sizeof *solutions);
  const char **paths = calloc(most, sizeof *paths);
  tp_status status = solutions != NULL && paths != NULL ? TP_OK : TP_OUT_OF_MEMORY;
  if (status == TP_OK) status = solve_all(solutions, paths, &count, ended, a, message);
  if (status == TP_OK && count > 0) {
    const tp_solution *const *own = (const tp_solution *const *)solutions;
    status = a->csv ? tp_report_csv(&report, own, count) : tp_report_table(&report, own, count);
  }
  if (status == TP_OK && count > 0) *ended = tp_cli_graver(*ended, tp_cli_print(report));
  for (size_t k = 0; k < count && status == TP_OK; k++) {
    *ended = tp_cli_graver(*ended, end_open(solutions[k], a, paths[k]));
  }
  free(report);
  for (size_t k = 0; solutions != NULL && k < count; k++) tp_solution_free(solutions[k]);
  free(solutions);
  free(paths);
  return status;
}

/* ---- one scene ---------------------------------------------------------------------------------
 */

/* The report that goes with a figure. */
typedef struct report {
  const tp_scene *scene;
  const tp_solution *solution;
  const tp_solve_words *words;
  int *ended;
  tp_status status;
  tp_message message;
} report;

/* The figure is ready: it is left behind only if the report is written. */
static bool print_with_figure(void *context) {
  report *own = context;
  own->status = print_solution(own->scene, own->solution, own->words, own->ended, &own->message);
  return own->status == TP_OK && *own->ended == 0;
}

static tp_status print_and_draw(const tp_solve_words *a, const tp_scene *scene,
                                const tp_solution *solution, int *ended, tp_message *message) {
  report own = {scene, solution, a, ended, TP_OK, {.text = ""}};
  const tp_status drawn = tp_cli_draw(a->figure, scene, solution,
                                      (tp_figure_consent){print_with_figure, &own}, message);
  if (own.status == TP_OK && *ended == 0) return drawn;
  *message = own.message; /* not that of the figure, for want of the report */
  return own.status;
}

static tp_status write_report(const tp_solve_words *a, const tp_scene *scene,
                              const tp_solution *solution, tp_message *message) {
  tp_sheet_options options;
  tp_cli_date date;
  const tp_status status = tp_cli_sheet_options(&options, &date, message);
  options.language = a->language;
  return status == TP_OK ? tp_cli_write_sheet(a->report, scene, solution, &options, message)
                         : status;
}

static tp_status print_one(const tp_solve_words *a, int *ended, tp_message *message) {
  tp_scene *scene = NULL;
  tp_solution *solution = NULL;
  tp_status status = solve_scene(&solution, &scene, a->scene, a, message);
  if (status == TP_OK) {
    status = a->find.key != NULL ? print_found(scene, solution, a, ended, message)
             : a->figure != NULL ? print_and_draw(a, scene, solution, ended, message)
                                 : print_solution(scene, solution, a, ended, message);
  }
  if (status == TP_OK && *ended == 0 && a->report != NULL) {
    status = write_report(a, scene, solution, message);
  }
  if (status == TP_OK && *ended == 0 && a->profile != NULL) {
    status = tp_scene_write_profile(a->profile, scene, message);
  }
  if (status == TP_OK && *ended == 0 && a->find.key == NULL) {
    *ended = end_open(solution, a, a->scene);
  }
  tp_solution_free(solution);
  tp_scene_free(scene);
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
