/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The text of a scene that is begun: what is known of the block, and comments that say what every
 * key means and what is left out. */

#ifndef TP_CLI_NEW_SCENE_H
#define TP_CLI_NEW_SCENE_H

#include "cli/new_answers.h"

/* To be freed. All texts passed the checks above. */
TP_MUST_USE tp_status tp_cli_new_scene_text(char **text, const tp_cli_new_scene *scene);

#endif
