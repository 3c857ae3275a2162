/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What is told of a simulated tilt test, in lines of 80 columns. Its numbers are printed with the
 * digits that the bracket leaves sense to, not as certain ones. */

#ifndef TP_REPORT_TILT_TEXT_H
#define TP_REPORT_TILT_TEXT_H

#include "output/text.h"

/* How it was run; a label, then nine columns in what is said. */
void tp_tilt_add_settings(tp_text *text, const tp_tilt_test *test);
/* At which tilt it begins to move, and what statics says of it. */
void tp_tilt_add_verdict(tp_text *text, const tp_tilt_case *own, const tp_tilt_test *test);
/* What happened, a line each; nothing where nothing did. */
void tp_tilt_add_events(tp_text *text, const tp_tilt_case *own, const tp_tilt_test *test);
/* Of that, for who tells it otherwise: the words of one event; which facets statics counts
 * otherwise; how many events from one on are of the same facet, of which so many or more are told
 * as one; so many are told. */
void tp_tilt_add_event_words(tp_text *text, const tp_tilt_event *event, const tp_tilt_case *own,
                             const tp_tilt_test *test);
void tp_tilt_add_facets(tp_text *text, const tp_tilt_case *own, const tp_tilt_test *test);
size_t tp_tilt_chatter_length(const tp_tilt_case *own, size_t first);
enum { TP_TILT_CHATTER = 6, TP_TILT_EVENTS_TOLD = 60 };
/* Which shaking overturns it, where that was asked. */
void tp_tilt_add_overturning(tp_text *text, const tp_tilt_case *own, const tp_tilt_test *test);
/* How near a rocking block came to overturning, where its base shakes. */
void tp_tilt_add_peak(tp_text *text, const tp_tilt_case *own);
/* How it ended, and these. */
void tp_tilt_add_ending(tp_text *text, const tp_tilt_case *own, const tp_tilt_test *test);

#endif
