/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The earthquakes that were looked at, the one that governs first. */

#ifndef TP_REPORT_EARTHQUAKES_H
#define TP_REPORT_EARTHQUAKES_H

#include "output/json.h"
#include "report/page.h"

void tp_page_add_earthquakes(tp_page *p);

/* "to the right, up-dip, without k_v"; the part is named where some of them have it. */
void tp_text_earthquake(tp_text *text, const tp_solution *solution, const tp_earthquake *own);

#endif
