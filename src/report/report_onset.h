/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The onset of motion in the reports. */

#ifndef TP_REPORT_ONSET_H
#define TP_REPORT_ONSET_H

#include "report/text.h"
#include "topple.h"

/* The keys `onset` and `motions` of a case. */
void tp_json_onset(tp_text *text, const tp_case *own);

#endif
