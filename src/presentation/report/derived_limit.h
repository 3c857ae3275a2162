/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The static limit in symbols, in the reports of a derivation. */

#ifndef TP_REPORT_DERIVED_LIMIT_H
#define TP_REPORT_DERIVED_LIMIT_H

#include "output/json.h"

void tp_text_derived_limit(tp_text *text, const tp_derivation *derivation);
void tp_latex_derived_limit(tp_text *text, const tp_derivation *derivation);
void tp_c_derived_limit(tp_text *text, const tp_derivation *derivation);

/* Is there a limit, or none because forces hold the block at any tilt? */
bool tp_derived_limit_is_told(const tp_derived_limit *limit);

#endif
