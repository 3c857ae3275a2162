/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Running gnuplot: its commands go in, its figure comes out. Neither its settings of the user nor
 * the environment, but for where programs and libraries are, reach it. */

#ifndef TP_CHART_GNUPLOT_H
#define TP_CHART_GNUPLOT_H

#include "topple.h"

/* Have gnuplot carry out `script`, which plots to its standard output. `*figure` is allocated with
 * malloc. A gnuplot that neither reads nor writes for a minute is ended. */
TP_MUST_USE tp_status tp_gnuplot_run(char **figure, size_t *length, const char *script,
                                     tp_message *message);

#endif
