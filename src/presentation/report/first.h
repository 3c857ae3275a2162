/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What happens at the limit, and what happens first: by contact forces, but where it slides sooner
 * than they say or they say nothing. */

#ifndef TP_REPORT_FIRST_H
#define TP_REPORT_FIRST_H

#include "report/page.h"

/* "slides and topples about (-21.6, -57.7)" */
void tp_page_add_limit_motion(tp_page *page, const tp_case *own, const tp_limit *limit);

/* "topples about the valley at (0, 0)" */
void tp_page_add_first(tp_page *page, const tp_case *own);

#endif
