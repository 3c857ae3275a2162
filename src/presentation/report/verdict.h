/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The verdict of a case on the page: what stands, what does not, and what happens first. */

#ifndef TP_REPORT_VERDICT_H
#define TP_REPORT_VERDICT_H

#include "report/page.h"

void tp_page_add_verdict(tp_page *page, const tp_case *own);

#endif
