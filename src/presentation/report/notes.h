/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Notes and cautions of a solution, and what was set in its scene. */

#ifndef TP_REPORT_NOTES_H
#define TP_REPORT_NOTES_H

#include "output/json.h"

/* On a page of 80 columns, each with its kind before it and its place behind it; nothing where
 * there are none. */
void tp_text_notes(tp_text *text, const tp_notes *notes);

/* There too: a line for each number that was set. */
void tp_text_settings(tp_text *text, const tp_settings *settings);

#endif
