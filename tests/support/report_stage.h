/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A solution to report, filled in by hand. */

#ifndef TP_TEST_REPORT_STAGE_H
#define TP_TEST_REPORT_STAGE_H

#include "topple.h"

tp_bounded number(double value);
/* A square on friction, tilted to the left by 20 degrees, with a limit of 40. */
tp_solution filled(void);

/* The report has the words, and not those others. */
void says(const tp_solution *s, const char *words, const char *others);

/* The JSON has the members, in a row. */
void json_has(const tp_solution *s, const char *members);

#endif
