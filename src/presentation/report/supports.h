/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Bolts and pressures of supports in text. */

#ifndef TP_REPORT_SUPPORTS_H
#define TP_REPORT_SUPPORTS_H

#include "report/page.h"

/* A line for each of them: force, rows, spacing, force per metre, utilisation. */
void tp_page_add_supports(tp_page *page);

#endif
