/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* How open the joint is of a block that was shifted along its mated base. Both write nothing of a
 * block that was not. */

#ifndef TP_REPORT_JOINT_H
#define TP_REPORT_JOINT_H

#include "output/json.h"
#include "report/page.h"

void tp_page_add_joint(tp_page *page);
#endif
