/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* How a command takes its scene: the options --set KEY=VALUE, given any number of times, --case and
 * --unit, of a drawing that stands in place of the scene. Every command that takes one has these by
 * its children of argp, and says in ARGP_KEY_INIT whose they are. */

#ifndef TP_CLI_SETTINGS_H
#define TP_CLI_SETTINGS_H

#include "cli/cli.h"

enum { TP_CLI_SETTINGS = 200 };

typedef struct tp_cli_settings {
  size_t count;
  const char *items[TP_CLI_SETTINGS];
  const char *load_case; /* of a scene that has cases; NULL: none is chosen */
  const char *unit;      /* of a drawing that is given in place of a scene; NULL: as it says */
} tp_cli_settings;

/* The child, whose input is a tp_cli_settings. */
extern const struct argp_child tp_cli_settings_child[];

/* Was any of the options given? */
bool tp_cli_settings_given(const tp_cli_settings *settings);

/* Is a file read as a scene: a scene, or a drawing by its name? All else is points. */
bool tp_cli_is_scene(const char *path);

/* Read a scene, or a drawing in place of one, with all of them. */
TP_MUST_USE tp_status tp_cli_read_scene(tp_scene **scene, const char *path,
                                        const tp_cli_settings *settings, tp_message *message);

#endif
