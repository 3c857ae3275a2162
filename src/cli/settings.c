/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "cli/settings.h"

#include <string.h>

void tp_cli_take_setting(tp_cli_settings *settings, const char *word,
                         const struct argp_state *state) {
  const char *equals = strchr(word, '=');
  if (equals == NULL || equals == word || equals[1] == '\0') {
    tp_cli_refuse(state, "--set takes KEY=VALUE, as friction_angle_deg=30; not '%s'", word);
  } else if (settings->count == TP_CLI_SETTINGS) {
    tp_cli_refuse(state, "--set is given at most %d times", TP_CLI_SETTINGS);
  } else {
    settings->items[settings->count++] = word;
  }
}

tp_status tp_cli_read_scene(tp_scene **scene, const char *path, const tp_cli_settings *settings,
                            tp_message *message) {
  return tp_scene_read_with(scene, path, settings->unit != NULL ? settings->unit : "",
                            settings->items, settings->count, message);
}
