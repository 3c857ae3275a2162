/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* That no motion begins below the onset: for each mode the signs that keep it from beginning. */

#ifndef TP_DERIVE_ONSET_EXCLUSION_H
#define TP_DERIVE_ONSET_EXCLUSION_H

#include "derive/onset_planes.h"

/* Into the conditions, for the onset at `tangent`: by energy, by one plane or by two
 * (derive/onset_formulas.h). NULL, or why not, as a static string. */
const char *tp_onset_exclude(tp_conditions *conditions, const tp_onset_planes *planes,
                             const fmpz_mpoly_q_t tangent);

#endif
