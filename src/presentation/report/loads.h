/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What the loads of a scene do, as text and JSON. */

#ifndef TP_REPORT_LOADS_H
#define TP_REPORT_LOADS_H

#include "output/json.h"
#include "report/page.h"

/* At which tilts the moments balance, and a caution where water stands above its face. */
void tp_page_add_balance(tp_page *page, const tp_case *own);

/* That, and the account of moments about the governing pivot, and the tilts at which it begins to
 * move and holds again. Nothing where the scene has no loads. */
void tp_page_add_loads(tp_page *page, const tp_case *own);

#endif
