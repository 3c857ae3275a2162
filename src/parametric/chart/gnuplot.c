/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Arguments of gnuplot without the user's settings, run by chart/program.h with the script as its
 * input. */

#include "chart/gnuplot.h"

#include "chart/program.h"

#include <string.h>

tp_status tp_gnuplot_run(char **figure, size_t *length, const char *script, tp_message *message) {
  static const char *const arguments[] = {"gnuplot", "-d", NULL}; /* none but its own settings */
  const tp_plot_program program = {
      .name = "gnuplot",
      .arguments = arguments,
      .input = script,
      .input_length = strlen(script),
      .where_missing = "which draws the figures, is not installed: 'apt-get install gnuplot-nox' "
                       "on Debian, or './run --with charts' in Topple's folder; the numbers of a "
                       "chart need none: --output FILE.csv"};
  return tp_program_run(figure, length, &program, message);
}
