/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The onset of motion in the reports: up to which tilt the block is certain to stand, beyond which
 * it is certain to move, and between them the window in which history decides (docs/mechanics.md
 * section 6a). */

#ifndef TP_REPORT_ONSET_H
#define TP_REPORT_ONSET_H

#include "output/json.h"
#include "report/page.h"

/* Is it known up to which tilt no motion can begin? */
bool tp_onset_is_known(const tp_onset *onset);

/* Is there a stretch of tilts in which history decides? */
bool tp_onset_leaves_window(const tp_case *own);

/* Sentences: what is certain, from the margin on. */
void tp_page_add_onset(tp_page *page, const tp_case *own);

/* All tilts at which motions can begin, where the lower end of the first does not tell it all. */
void tp_page_add_windows(tp_page *page, const tp_onset *onset);

/* The motions that can begin at the scene's tilt, as a table. */
void tp_page_add_motions(tp_page *page, const tp_case *own);

/* What can begin at the scene's tilt, in words: "slides or topples". */
void tp_text_beginnings(tp_text *text, const tp_case *own);

/* The verdict at the scene's tilt with all that can begin there: "may move: topples". */
void tp_text_verdict(tp_text *text, const tp_case *own);

#endif
