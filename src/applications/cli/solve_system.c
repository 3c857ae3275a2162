/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Report or JSON of many blocks, and the exit status: 1 where the required factor is certainly not
 * met, 4 where that or the verdict is open. */

#include "cli/solve_system.h"

#include <stdio.h>

tp_status tp_cli_check_system(const char *path, const tp_solve_words *a, tp_message *message) {
  const char *option = a->find.key != NULL  ? "--find"
                       : a->report != NULL  ? "--report"
                       : a->figure != NULL  ? "--figure"
                       : a->profile != NULL ? "--profile"
                       : a->table           ? "--table"
                       : a->csv             ? "--csv"
                       : a->outlines        ? "--outlines"
                       : a->elements        ? "--elements"
                                            : NULL;
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
                      "can hold the blocks, and that no motion begins all the same is not excluded",
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

tp_status tp_cli_solve_system(const tp_scene *scene, const tp_solve_words *a, int *ended,
                              tp_message *message) {
  tp_block_system *system = NULL;
  const tp_solve_options options = tp_solve_options_default();
  char *report = NULL;
  tp_status status = tp_solve_block_system(&system, scene, &options, message);
  if (status == TP_OK) {
    status = a->json ? tp_report_block_system_json(&report, system)
                     : tp_report_block_system(&report, system);
    status = tp_cli_print_report(status, report, ended);
  }
  if (status == TP_OK && *ended == 0) *ended = judge(system, a);
  tp_block_system_free(system);
  return status;
}
