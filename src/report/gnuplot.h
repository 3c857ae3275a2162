/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Running gnuplot: its commands go in by a pipe, its figure comes out into a file. */

#ifndef TP_GNUPLOT_H
#define TP_GNUPLOT_H

#include "report/file.h"

/* Have gnuplot carry out `script`, which plots to its standard output, into the file. */
TP_MUST_USE tp_status tp_gnuplot_run(const tp_file *file, const char *script, tp_message *message);

#endif
