/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What the settings of a tilt test take from its answer, within other reports. */

#ifndef TP_REPORT_CONVERGE_H
#define TP_REPORT_CONVERGE_H

#include "output/text.h"

/* The cases as text. */
void tp_text_convergence(tp_text *text, const tp_tilt_convergence *convergence);

#endif
