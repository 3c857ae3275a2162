/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A drawing that a scene is begun of: which files are one, and what the scene says of it. */

#ifndef TP_CLI_NEW_DRAWING_H
#define TP_CLI_NEW_DRAWING_H

#include "cli/new_answers.h"

#include <stdio.h>

/* By the ending of its name; a CSV by its columns: one that names layers, names or bulges is a
 * drawing, any other an outline. */
bool tp_cli_is_drawing(const char *path);

/* Is there an option that only a drawing takes? */
bool tp_cli_says_of_drawing(const tp_cli_new_scene *scene);

/* What is wrong with a text "WORD=NUMBER", with what would be right; NULL: nothing. */
const char *tp_cli_wrong_part(const char *text);
const char *tp_cli_wrong_reference(const char *text);

/* The key `drawing` of the scene. */
void tp_cli_write_drawing(FILE *out, const tp_cli_new_scene *scene);

#endif
