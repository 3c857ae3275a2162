/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* That no motion begins below the onset: for each mode the signs that keep it from beginning. */

#ifndef TP_ONSET_EXCLUSION_H
#define TP_ONSET_EXCLUSION_H

#include "derive/onset_formulas.h"

/* Into the conditions of the formulas, whose tangent is set: by energy, by one plane or by two
 * (derive/onset_formulas.h). NULL, or why not, as a static string. */
const char *tp_onset_exclude(tp_onset_formulas *formulas);

#endif
