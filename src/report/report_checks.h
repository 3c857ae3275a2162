/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Conditions of derived formulas that were looked at from both sides. */

#ifndef TP_REPORT_CHECKS_H
#define TP_REPORT_CHECKS_H

#include "report/text.h"

/* A line below a condition, where it was met: "      holds at c = 7.41; at c = 7.43 …". `what` is
 * the limit or the onset. */
void tp_text_check(tp_text *text, const tp_derived_checks *checks, size_t condition,
                   const char *what);

/* A sentence on those that were not met; nothing where there are none. */
void tp_text_unmet(tp_text *text, const tp_derived_checks *checks, size_t conditions);

/* `,\n     "checks": [{…}]`, where they were run. */
void tp_json_checks(tp_text *text, const tp_derived_checks *checks);

#endif
