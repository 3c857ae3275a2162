/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The questions of `topple new`, on a terminal. */

#ifndef TP_CLI_NEW_ASK_H
#define TP_CLI_NEW_ASK_H

#include "cli/new_answers.h"

/* All that a scene is begun of; of a file, an outline or a drawing, only what does not stand in it.
 * A file that is answered is kept as `outline`. False: the answers ended. */
bool tp_cli_ask_scene(tp_cli_new_scene *scene);
bool tp_cli_ask_of_file(tp_cli_new_scene *scene, bool drawing);

#endif
