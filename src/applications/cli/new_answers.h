/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What is asked of a scene that is begun, and what may be answered. */

#ifndef TP_CLI_NEW_ANSWERS_H
#define TP_CLI_NEW_ANSWERS_H

#include "topple.h"

#include <stdio.h>

enum { TP_CLI_ANSWER = 256, TP_CLI_PARTS = 8 };

/* What is asked for. Texts as they were given; an empty one was not. */
typedef struct tp_cli_new_scene {
  char title[TP_CLI_ANSWER], length_unit[TP_CLI_ANSWER];
  char block[TP_CLI_ANSWER];   /* width and height, as 2x4 */
  char outline[TP_CLI_ANSWER]; /* or a file of the outline, as seen from the scene */
  char drawing[TP_CLI_ANSWER]; /* or a drawing, likewise; then what is said of it: */
  char block_layer[TP_CLI_ANSWER], base_layer[TP_CLI_ANSWER], hole_layer[TP_CLI_ANSWER];
  char reference[TP_CLI_ANSWER], gap[TP_CLI_ANSWER], parts[TP_CLI_PARTS][TP_CLI_ANSWER];
  int part_count;
  bool drawn_base; /* the base is the drawing's */
  char unit_weight[TP_CLI_ANSWER], friction[TP_CLI_ANSWER];
  char tilt[TP_CLI_ANSWER], towards[TP_CLI_ANSWER], frame[TP_CLI_ANSWER];
} tp_cli_new_scene;

/* What is wrong with a text for it, with what would be right; NULL: nothing. Whether the scene
 * solves is found by solving it. */
const char *tp_cli_wrong_unit(const char *text);
const char *tp_cli_wrong_size(const char *text);
const char *tp_cli_wrong_number(const char *text); /* a decimal or a fraction; empty: none */
const char *tp_cli_wrong_towards(const char *text);

/* As a scalar of YAML in double quotes. */
void tp_cli_write_quoted(FILE *out, const char *text);

#endif
