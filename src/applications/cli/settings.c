/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The argp child parser of --set, --case and --unit, and the call that reads a scene with them. */

#include "cli/settings.h"

#include <string.h>
#include <strings.h>

enum { KEY_SET = 0x5e7, KEY_UNIT, KEY_CASE }; /* apart from the keys of every command */

static const struct argp_option options[] = {
    {"set", KEY_SET, "KEY=VALUE", 0,
     "With this number at KEY, as friction_angle_deg=30: a number or a formula, as in a scene "
     "file; "
     "may be given several times",
     0},
    {"case", KEY_CASE, "NAME", 0, "The load case of this name, of a scene that has cases", 0},
    {"unit", KEY_UNIT, "UNIT", 0,
     "Length unit of a drawing that is given in place of the scene: mm, cm, m, km, in or ft", 0},
    {0}};

static void take_setting(tp_cli_settings *settings, const char *word,
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

static error_t parse(int key, char *argument, struct argp_state *state) {
  tp_cli_settings *settings = state->input;
  switch (key) {
  case KEY_SET:
    take_setting(settings, argument, state);
    return 0;
  case KEY_CASE:
    settings->load_case = argument;
    return 0;
  case KEY_UNIT:
    settings->unit = argument;
    return 0;
  default:
    return ARGP_ERR_UNKNOWN;
  }
}

static const struct argp parser = {.options = options, .parser = parse};
/* Behind a command's own options, of whose groups none is greater. */
const struct argp_child tp_cli_settings_child[] = {{.argp = &parser, .group = 3}, {.argp = NULL}};

bool tp_cli_settings_given(const tp_cli_settings *settings) {
  return settings->count > 0 || settings->unit != NULL || settings->load_case != NULL;
}

bool tp_cli_is_scene(const char *path) {
  static const char *const endings[] = {".yaml", ".yml",  ".dxf", ".svg", ".wkt", ".geojson",
                                        ".shp",  ".gpkg", ".stl", ".ply", ".obj"};
  const char *ending = strrchr(path, '.');
  for (size_t k = 0; ending != NULL && k < sizeof endings / sizeof endings[0]; k++) {
    if (strcasecmp(ending, endings[k]) == 0) return true;
  }
  return false;
}

/* What is set is of the case. */
static tp_status read_case(tp_scene **scene, const char *path, const tp_cli_settings *settings,
                           tp_message *message) {
  tp_scene *read = NULL, *own = NULL;
  const char *unit = settings->unit != NULL ? settings->unit : "";
  tp_status status = tp_scene_read_with(&read, path, unit, NULL, 0, message);
  if (status == TP_OK) status = tp_scene_load_case(&own, read, settings->load_case, message);
  if (status == TP_OK && settings->count == 0) {
    *scene = own;
    own = NULL;
  } else if (status == TP_OK) {
    status = tp_scene_with_settings(scene, own, settings->items, settings->count, message);
  }
  tp_scene_free(own);
  tp_scene_free(read);
  return status;
}

tp_status tp_cli_read_scene(tp_scene **scene, const char *path, const tp_cli_settings *settings,
                            tp_message *message) {
  if (settings->load_case != NULL) return read_case(scene, path, settings, message);
  return tp_scene_read_with(scene, path, settings->unit != NULL ? settings->unit : "",
                            settings->items, settings->count, message);
}
