/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What stands below a table of scenes. */

#ifndef TP_REPORT_TABLE_NOTES_H
#define TP_REPORT_TABLE_NOTES_H

#include "output/text.h"

#include "topple.h"

/* In Markdown: what was set in a scene, and its notes and cautions, by its name. */
void tp_table_notes(tp_text *text, const char *title, const tp_settings *settings,
                    const tp_notes *notes);

#endif
