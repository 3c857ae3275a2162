/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Running a program that draws: its input goes in, its figure comes out, by its standard streams
 * alone. No text from outside is ever among its arguments, and no shell is between. Of the
 * environment it gets where programs and libraries are. */

#ifndef TP_CHART_PROGRAM_H
#define TP_CHART_PROGRAM_H

#include "topple_basics.h"

typedef struct tp_plot_program {
  const char *name;             /* as PATH knows it */
  const char *const *arguments; /* from its name on; NULL ends them */
  const char *input;
  size_t input_length;
  const char *where_missing; /* what it is for, and what to install, behind its name */
} tp_plot_program;

/* `*figure` is allocated with malloc. A program that neither reads nor writes for a minute is
 * ended, as is one that writes more than 256 MB. TP_SYSTEM_FAILED where it is not there or fails.
 */
TP_MUST_USE tp_status tp_program_run(char **figure, size_t *length, const tp_plot_program *program,
                                     tp_message *message);

#endif
