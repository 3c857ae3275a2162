/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The charts that `topple tilt` writes beside its report. */

#ifndef TP_CLI_TILT_CHARTS_H
#define TP_CLI_TILT_CHARTS_H

#include "cli/cli.h"

/* One that is asked for. */
typedef struct tp_tilt_chart {
  const char *path; /* NULL: it is not */
  tp_chart_format format;
} tp_tilt_chart;

typedef struct tp_tilt_charts {
  tp_tilt_chart reactions, phase, spectrum;
  tp_overturning_options overturning; /* of the spectrum */
} tp_tilt_charts;

/* From the command line: a file that is refused where its ending is of no format; frequencies as
 * FROM:TO:COUNT. */
void tp_tilt_charts_take(tp_tilt_chart *chart, const char *path, const char *option,
                         const struct argp_state *state);
void tp_tilt_charts_frequencies(tp_tilt_charts *charts, const char *text,
                                const struct argp_state *state);
/* The factors of --overturning, likewise. */
void tp_tilt_charts_factors(tp_tilt_options *options, const char *text,
                            const struct argp_state *state);

/* Reactions and phase portraits of a test. */
TP_MUST_USE tp_status tp_tilt_charts_write(const tp_tilt_charts *charts, const tp_tilt_test *test,
                                           tp_message *message);

/* The overturning spectrum of a scene, whose file is `name`, with progress where stderr is a
 * terminal. An interrupted one has the frequencies that were done by then, and `*ended` says so. */
TP_MUST_USE tp_status tp_tilt_charts_spectrum(const tp_tilt_charts *charts, const tp_scene *scene,
                                              const char *name, int *ended, tp_message *message);

#endif
