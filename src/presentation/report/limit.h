/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The static limit in the reports. */

#ifndef TP_REPORT_LIMIT_H
#define TP_REPORT_LIMIT_H

#include "output/json.h"
#include "report/page.h"

void tp_page_add_limit(tp_page *page, const tp_case *own);

#endif
