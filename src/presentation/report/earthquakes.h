/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The earthquakes that were looked at, the one that governs first. */

#ifndef TP_REPORT_EARTHQUAKES_H
#define TP_REPORT_EARTHQUAKES_H

#include "output/json.h"
#include "report/page.h"

void tp_page_add_earthquakes(tp_page *p);

#endif
