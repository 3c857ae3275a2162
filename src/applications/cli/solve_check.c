/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Refuses options of topple solve that do not go together, and says what to leave out. */

#include "cli/solve_check.h"

#include "cli/sheet.h"

static void check_find(tp_solve_words *a, struct argp_state *state) {
  const bool named = a->find.key != NULL;
  if (named != a->has_target) tp_cli_refuse(state, "--find KEY and --for RESULT=VALUE go together");
  if ((a->find.has_low || a->find.has_high) && !named)
    tp_cli_refuse(state, "--from and --to go with --find");
  if (a->least_force && !named) tp_cli_refuse(state, "--least-force goes with --find");
  if (named && a->figure != NULL) {
    tp_cli_refuse(state, "--figure draws the solution of the scene as it is; leave out --find");
  }
  if (named && a->report != NULL) {
    tp_cli_refuse(state, "--report needs the solution of the scene as it is; leave out --find");
  }
  if (named && a->animation != NULL) {
    tp_cli_refuse(state, "--animation draws the scene as it is; leave out --find");
  }
  if (named && a->has_design_fos) {
    tp_cli_refuse(state,
                  "--fail-below judges the solution of the scene as it is; leave out --find");
  }
}

/* What goes with a table of blocks. */
static void check_batch(tp_solve_words *a, struct argp_state *state) {
  tp_cli_batch_check(&a->batch, state);
  if (!a->batch.asked) return;
  if (a->scene_count > 1) {
    tp_cli_refuse(state, "--batch takes one table; '%s' is one too many", a->scenes[1]);
  }
  if (a->json + a->csv + a->table > 1) {
    tp_cli_refuse(state, "the table is printed in one way: --json, --csv or --table");
  }
  if (a->elements || a->figure != NULL || a->find.key != NULL || a->verbose || a->watch ||
      a->report != NULL || a->animation != NULL || a->profile != NULL || a->outlines ||
      a->has_design_fos || a->pivots != TP_PIVOTS_BY_COUNT || tp_cli_settings_given(&a->settings)) {
    tp_cli_refuse(state, "--batch goes with --template, --output, --figures, --threads, --csv, "
                         "--json, --table, --digits and --level; numbers that hold for all rows "
                         "stand in the template, required_fos too");
  }
  a->batch.options.digits = a->digits;
  a->batch.options.level = a->level;
}

void tp_solve_words_check(tp_solve_words *a, struct argp_state *state) {
  const bool table = a->table || a->csv;
  check_batch(a, state);
  if (a->batch.asked) return;
  check_find(a, state);
  if (a->scene_count > 1 && !table) {
    tp_cli_refuse(state,
                  "one scene at a time, or several with --table or --csv; '%s' is one too many",
                  a->scenes[1]);
  }
  if (table &&
      (a->json || a->elements || a->figure != NULL || a->find.key != NULL || a->verbose ||
       a->report != NULL || a->animation != NULL || a->profile != NULL || (a->table && a->csv))) {
    tp_cli_refuse(
        state,
        "--table and --csv print a table alone; drop --json, --elements, --figure, "
        "--animation, --report, --find, --verbose, --write-profile and the other of the two");
  }
  tp_cli_check_language(a->language, a->report, state);
  const tp_cli_written files[] = {{"--report", a->report},
                                  {"--figure", a->figure},
                                  {"--animation", a->animation},
                                  {"--write-profile", a->profile}};
  tp_cli_refuse_same_files(files, sizeof files / sizeof files[0], state);
  if (table && a->watch) {
    tp_cli_refuse(state, "--watch watches one scene; leave out --table and --csv");
  }
  if (a->pivots != TP_PIVOTS_BY_COUNT && !a->json) {
    tp_cli_refuse(state, "--pivots goes with --json");
  }
  if (a->outlines && (!a->json || a->find.key != NULL)) {
    tp_cli_refuse(state, "--outlines goes with --json, without --find");
  }
}
