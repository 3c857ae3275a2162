/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Friction of facets that have their own, in text and JSON. */

#ifndef TP_REPORT_FRICTION_H
#define TP_REPORT_FRICTION_H

#include "output/json.h"
#include "report/page.h"

void tp_page_add_friction(tp_page *page);
#endif
