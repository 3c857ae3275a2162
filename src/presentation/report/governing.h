/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The factor of safety that governs, in the reports. */

#ifndef TP_REPORT_GOVERNING_H
#define TP_REPORT_GOVERNING_H

#include "output/json.h"
#include "report/page.h"

/* "FoS 2.292 against toppling about the toe (moments)", or why there is none; nothing where the
 * scene gives no tilt. No line end; `space` stands before its last part. */
void tp_text_governing(tp_text *text, const tp_case *own, const char *space);

/* The same of any factor that governs. */
void tp_text_factor(tp_text *text, const tp_governing_fos *governing);

/* "toppling about the toe" */
void tp_text_against(tp_text *text, const tp_factor *factor);

/* "another motion begins first", why a factor does not count. */
const char *tp_text_standing(tp_factor_standing standing);

/* The line, and all factors with their definitions. */
void tp_page_add_governing(tp_page *page, const tp_case *own);

#endif
