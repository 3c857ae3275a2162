/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The option --set KEY=VALUE, given any number of times. */

#ifndef TP_CLI_SETTINGS_H
#define TP_CLI_SETTINGS_H

#include "cli/cli.h"

enum { TP_CLI_SETTINGS = 200 };

typedef struct tp_cli_settings {
  size_t count;
  const char *items[TP_CLI_SETTINGS];
  const char *unit; /* of a drawing that is given in place of a scene; NULL: as it says */
} tp_cli_settings;

/* Take one more word of the command line. */
void tp_cli_take_setting(tp_cli_settings *settings, const char *word,
                         const struct argp_state *state);

/* Read a scene, with all of them. */
TP_MUST_USE tp_status tp_cli_read_scene(tp_scene **scene, const char *path,
                                        const tp_cli_settings *settings, tp_message *message);

#endif
