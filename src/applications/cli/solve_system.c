/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Report or JSON of many blocks, and the exit status: 1 where the required factor is certainly not
 * met, 4 where that or the verdict is open. */

#include "cli/solve_system.h"
#include "cli/sheet.h"

#include <stdio.h>
#include <string.h>
#include <strings.h>

tp_status tp_cli_check_system(const char *path, const tp_solve_words *a, tp_message *message) {
  const char *option = a->find.key != NULL            ? "--find"
                       : a->profile != NULL           ? "--profile"
                       : a->table                     ? "--table"
                       : a->csv && a->scene_count > 1 ? "--csv with other scenes beside it"
                       : a->outlines                  ? "--outlines"
                       : a->elements                  ? "--elements"
                                                      : NULL;
  const char *ending = a->figure != NULL ? strrchr(a->figure, '.') : NULL;
  if (option == NULL && ending != NULL && strcasecmp(ending, ".dxf") == 0) {
    snprintf(message->text, sizeof message->text,
             "%s: the figure of a scene of many blocks is .svg, .pdf or .png, not '%s'", path,
             a->figure);
    return TP_BAD_INPUT;
  }
  if (option == NULL) return TP_OK;
  snprintf(message->text, sizeof message->text,
           "%s: %s is of scenes of one block, and this one has many: leave it out; --json has all "
           "that is found",
           path, option);
  return TP_BAD_INPUT;
}

static int judge(const tp_block_system *system, const tp_solve_words *a) {
  if (a->has_design_fos || system->has_required_fos) {
    const double required = a->has_design_fos ? a->design_fos : system->required_fos.value;
    switch (tp_block_system_meets(system, required)) {
    case TP_DESIGN_MET:
      break;
    case TP_DESIGN_NOT_MET:
      tp_cli_complain("%s: the required factor of safety %g is not met", a->scene, required);
      return TP_EXIT_REFUTED;
    case TP_DESIGN_OPEN:
      tp_cli_complain("%s: whether the required factor of safety %g is met is undecided: forces "
                      "can hold the blocks, and that a motion begins all the same is neither "
                      "excluded nor proven",
                      a->scene, required);
      return tp_status_exit(TP_UNDECIDED);
    }
  }
  if (!tp_block_system_is_undecided(system)) return 0;
  tp_cli_complain("%s: undecided: the tilt is too close to the critical one, or some block is held "
                  "by corners alone",
                  a->scene);
  return tp_status_exit(TP_UNDECIDED);
}

/* The report, and what becomes of it where a figure goes with it. */
typedef struct report {
  const tp_block_system *system;
  const tp_solve_words *words;
  int *ended;
  tp_status status;
} report;

static tp_status print(const report *own) {
  char *text = NULL;
  const tp_status status = own->words->json  ? tp_report_block_system_json(&text, own->system)
                           : own->words->csv ? tp_report_block_system_csv(&text, own->system)
                                             : tp_report_block_system(&text, own->system);
  return tp_cli_print_report(status, text, own->ended);
}

/* The figure is ready: it is left behind only if the report is written. */
static bool print_with_figure(void *context) {
  report *own = context;
  own->status = print(own);
  return own->status == TP_OK && *own->ended == 0;
}

static tp_status print_and_draw(report *own, const tp_scene *scene, tp_message *message) {
  const tp_status drawn = tp_cli_draw_system(own->words->figure, scene, own->system,
                                             (tp_figure_consent){print_with_figure, own}, message);
  if (own->status == TP_OK && *own->ended == 0) return drawn;
  message->text[0] = '\0'; /* not that of the figure, for want of the report */
  return own->status;
}

static tp_status write_report(const tp_scene *scene, const tp_block_system *system,
                              const tp_solve_words *a, tp_message *message) {
  tp_sheet_options options;
  tp_cli_date date;
  const tp_status status = tp_cli_sheet_options(&options, &date, message);
  options.language = a->language;
  return status == TP_OK ? tp_cli_write_system_sheet(a->report, scene, system, &options, message)
                         : status;
}

tp_status tp_cli_solve_system(const tp_scene *scene, const tp_solve_words *a, int *ended,
                              tp_message *message) {
  tp_block_system *system = NULL;
  const tp_solve_options options = tp_solve_options_default();
  tp_status status = tp_solve_block_system(&system, scene, &options, message);
  if (status == TP_OK) {
    report own = {system, a, ended, TP_OK};
    status = a->figure != NULL ? print_and_draw(&own, scene, message) : print(&own);
  }
  if (status == TP_OK && *ended == 0 && a->report != NULL) {
    status = write_report(scene, system, a, message);
  }
  if (status == TP_OK && *ended == 0) *ended = judge(system, a);
  tp_block_system_free(system);
  return status;
}
