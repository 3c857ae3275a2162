/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The part of the page that stands there where more digits were asked for than it shows. */

#ifndef TP_REPORT_DIGITS_H
#define TP_REPORT_DIGITS_H

#include "report/page.h"

void tp_page_add_digits(tp_page *page);

#endif
