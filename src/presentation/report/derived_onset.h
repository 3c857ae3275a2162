/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The onset of motion of a derivation, in every notation; nothing where it was not asked for. */

#ifndef TP_REPORT_DERIVED_ONSET_H
#define TP_REPORT_DERIVED_ONSET_H

#include "output/json.h"

void tp_text_derived_onset(tp_text *text, const tp_derivation *derivation);
void tp_latex_derived_onset(tp_text *text, const tp_derivation *derivation);
void tp_c_derived_onset(tp_text *text, const tp_derivation *derivation);

/* Why there is no formula; NULL where there is one, or none was asked for. */
const char *tp_derived_onset_missing(const tp_derived_onset *onset);

#endif
