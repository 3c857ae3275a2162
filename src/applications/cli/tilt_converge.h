/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* topple tilt SCENE --converge: what is asked, and its run. */

#ifndef TP_CLI_TILT_CONVERGE_H
#define TP_CLI_TILT_CONVERGE_H

#include "cli/cli.h"

typedef struct tp_cli_converge {
  const char *path;   /* of the scene, for complaints */
  const char *figure; /* NULL: none */
  tp_chart_format format;
  bool json;
} tp_cli_converge;

/* The scene's test over its settings, told and drawn. */
TP_MUST_USE tp_status tp_cli_tilt_converge(const tp_cli_converge *asked, const tp_scene *scene,
                                           const tp_tilt_options *options, int *ended,
                                           tp_message *message);

#endif
