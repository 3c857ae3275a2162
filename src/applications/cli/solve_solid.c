/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Report, JSON or a row of CSV of a solid, and the exit status: 1 where the required factor is
 * certainly not met, 4 where that or the verdict is open. */

#include "cli/solve_solid.h"
#include "cli/drawn_report.h"
#include "cli/sheet.h"
#include "cli/solve_judge.h"

#include <stdio.h>
#include <string.h>
#include <strings.h>

tp_status tp_cli_check_solid(const char *path, const tp_solve_words *a, tp_message *message) {
  const char *option = a->find.key != NULL            ? "--find"
                       : a->profile != NULL           ? "--write-profile"
                       : a->table                     ? "--table"
                       : a->csv && a->scene_count > 1 ? "--csv with other scenes beside it"
                       : a->outlines                  ? "--outlines"
                       : a->elements                  ? "--elements"
                       : a->animation != NULL         ? "--animation"
                                                      : NULL;
  const char *ending = a->figure != NULL ? strrchr(a->figure, '.') : NULL;
  if (option == NULL && ending != NULL && strcasecmp(ending, ".dxf") == 0) {
    snprintf(message->text, sizeof message->text,
             "%s: the figure of a solid is .svg, .pdf, .png or .glb, not '%s'", path, a->figure);
    return TP_BAD_INPUT;
  }
  if (option == NULL) return TP_OK;
  snprintf(message->text, sizeof message->text,
           "%s: %s is of scenes of a block in a section, and this one has a solid: leave it out; "
           "--json has all that is found",
           path, option);
  return TP_BAD_INPUT;
}

static int judge_solid(const tp_solid *solid, const tp_solve_words *a) {
  if (a->has_design_fos || solid->has_required_fos) {
    const double required = a->has_design_fos ? a->design_fos : solid->required_fos;
    const int ended =
        tp_cli_judge_required(tp_solid_meets(solid, required), required, a->scene, "");
    if (ended != 0) return ended;
  }
  if (!tp_solid_is_undecided(solid)) return 0;
  tp_cli_complain("%s: undecided: the tilt is too close to the critical one", a->scene);
  return tp_status_exit(TP_UNDECIDED);
}

static tp_status write_report(const tp_scene *scene, const tp_solid *solid, const tp_solve_words *a,
                              tp_message *message) {
  tp_sheet_options options;
  tp_cli_date date;
  const tp_status status = tp_cli_sheet_options(&options, &date, message);
  options.language = a->language;
  return status == TP_OK ? tp_cli_write_solid_sheet(a->report, scene, solid, &options, message)
                         : status;
}

typedef struct solved {
  const tp_solid *solid;
  const tp_solve_words *words;
} solved;

static tp_status print(const void *of, int *ended, tp_message *message) {
  const solved *own = of;
  char *text = NULL;
  (void)message;
  const tp_status status = own->words->json  ? tp_report_solid_json(&text, own->solid)
                           : own->words->csv ? tp_report_solid_row_csv(&text, own->solid)
                                             : tp_report_solid(&text, own->solid);
  return tp_cli_print_report(status, text, ended);
}

static tp_status print_and_draw(const solved *own, int *ended, tp_message *message) {
  tp_cli_drawn_report report = {.print = print, .of = own, .ended = ended};
  const tp_status drawn = tp_cli_draw_solid(own->words->figure, own->solid,
                                            tp_cli_drawn_report_consent(&report), message);
  return tp_cli_drawn_report_end(&report, drawn, message);
}

tp_status tp_cli_solve_solid(const tp_scene *scene, const tp_solve_words *a, int *ended,
                             tp_message *message) {
  tp_solid *solid = NULL;
  tp_status status = tp_solve_solid(&solid, scene, message);
  if (status == TP_OK) {
    const solved own = {solid, a};
    status = a->figure != NULL ? print_and_draw(&own, ended, message) : print(&own, ended, message);
  }
  if (status == TP_OK && *ended == 0 && a->report != NULL) {
    status = write_report(scene, solid, a, message);
  }
  if (status == TP_OK && *ended == 0) *ended = judge_solid(solid, a);
  tp_solid_free(solid);
  return status;
}
