/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The options of topple solve, as one struct. */

#ifndef TP_CLI_SOLVE_ASKED_H
#define TP_CLI_SOLVE_ASKED_H

#include "cli/batch.h"
#include "cli/settings.h"

typedef struct tp_solve_words {
  const char *scene; /* the first of `scenes` */
  char **scenes;     /* those of --table and --csv */
  int scene_count;
  const char *figure;    /* file to draw into; NULL: none */
  const char *animation; /* file to draw many blocks into as they begin to move; NULL: none */
  const char *report;    /* file to write a calculation sheet into; NULL: none */
  const char *language;  /* of that sheet; NULL: the scene's */
  const char *profile;   /* file to write the base's profile into; NULL: none */
  bool json, elements, table, csv, verbose;
  bool outlines;            /* the geometry beside the JSON */
  tp_cli_batch batch;       /* a table in place of the scene */
  bool watch;               /* again whenever a file changes */
  tp_cli_settings settings; /* numbers of the scenes that are others */
  tp_pivots_listed pivots;
  bool has_design_fos;
  double design_fos;
  int digits;
  tp_level level;
  bool has_target;
  tp_find_options find; /* key NULL: nothing is to be found */
  bool least_force;     /* the key is a force, and is to be least over its direction */
} tp_solve_words;

#endif
