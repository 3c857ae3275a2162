/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* topple solve --batch TABLE: its options, and what it does (docs/batch.md). */

#ifndef TP_CLI_BATCH_H
#define TP_CLI_BATCH_H

#include "cli/cli.h"

enum { TP_CLI_OUTPUTS = 8 };

typedef struct tp_cli_batch {
  bool asked;
  int output_count;
  const char *outputs[TP_CLI_OUTPUTS];
  const char *figures; /* folder; NULL: none */
  tp_batch_options options;
} tp_cli_batch;

/* Keys of its options, apart from those of topple solve. */
enum {
  TP_CLI_BATCH = 600,
  TP_CLI_BATCH_TEMPLATE,
  TP_CLI_BATCH_OUTPUT,
  TP_CLI_BATCH_FIGURES,
  TP_CLI_BATCH_THREADS
};

/* As rows of a table of options, of the group. */
#define TP_CLI_BATCH_OPTIONS(group)                                                                \
  {"batch",                                                                                        \
   TP_CLI_BATCH,                                                                                   \
   NULL,                                                                                           \
   0,                                                                                              \
   "Solve each row of a table of blocks, which stands in place of the scene, and list them, the "  \
   "worst first; with --csv, --json or --table as such",                                           \
   group},                                                                                         \
      {"template",                                                                                 \
       TP_CLI_BATCH_TEMPLATE,                                                                      \
       "SCENE",                                                                                    \
       0,                                                                                          \
       "With --batch: the scene over which the cells of a row are put",                            \
       group},                                                                                     \
      {"output",                                                                                   \
       TP_CLI_BATCH_OUTPUT,                                                                        \
       "FILE",                                                                                     \
       0,                                                                                          \
       "With --batch: write the table into FILE, which ends in .csv, .html, .json, .md or "        \
       ".xlsx; may be given several times",                                                        \
       group},                                                                                     \
      {"figures",                                                                                  \
       TP_CLI_BATCH_FIGURES,                                                                       \
       "DIR",                                                                                      \
       0,                                                                                          \
       "With --batch: draw each block into the folder DIR, as SVG",                                \
       group},                                                                                     \
  {                                                                                                \
    "threads", TP_CLI_BATCH_THREADS, "N", 0,                                                       \
        "With --batch: number of threads (default: one per core)", group                           \
  }

/* Is the key one of them? Then it is taken. */
bool tp_cli_batch_take(tp_cli_batch *batch, int key, const char *argument,
                       const struct argp_state *state);
/* Was any of them given without --batch? */
void tp_cli_batch_check(const tp_cli_batch *batch, const struct argp_state *state);

/* How the table is printed. */
typedef enum tp_cli_batch_as {
  TP_CLI_BATCH_TEXT,
  TP_CLI_BATCH_MARKDOWN,
  TP_CLI_BATCH_CSV,
  TP_CLI_BATCH_JSON
} tp_cli_batch_as;

TP_MUST_USE tp_status tp_cli_solve_batch(const tp_cli_batch *batch, const char *table,
                                         tp_cli_batch_as as, int *ended, tp_message *message);

#endif
