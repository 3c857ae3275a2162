/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Beginning of a scene by topple new: its text is made, solved as a trial and written. */

#ifndef TP_CLI_NEW_BEGIN_H
#define TP_CLI_NEW_BEGIN_H

#include "cli/new_answers.h"

/* The file of the block, of an outline or a drawing, as a scene at `output` is to name it. */
TP_MUST_USE tp_status tp_cli_new_scene_of(tp_cli_new_scene *scene, const char *file,
                                          const char *output, tp_message *message);

/* Solved as it is to be written, once, and of a drawing without a base once more, as its base is
 * then said in words; then written, with what became of the drawing told before. `output` is "-"
 * for stdout. */
TP_MUST_USE tp_status tp_cli_begin_scene(tp_cli_new_scene *scene, const char *output, int *ended,
                                         tp_message *message);

#endif
