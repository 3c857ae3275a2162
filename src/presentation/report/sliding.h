/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Sliding of a case, in text. */

#ifndef TP_REPORT_SLIDING_H
#define TP_REPORT_SLIDING_H

#include "report/page.h"

void tp_page_add_sliding(tp_page *page, const tp_case *own);

#endif
