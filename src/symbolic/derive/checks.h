/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Conditions of a formula put to the test: on either side of each the scene is solved in numbers.
 *
 * From the scene's values the symbols go out along each of them alone, and then together in
 * directions drawn at random (the same for the same scene), until a condition fails; between the
 * last numbers that do and the first that do not the crossing is bisected. Just inside the
 * certified solver has to agree with the formula, or the derivation fails; just outside it says
 * what comes then. A condition that no direction meets first is left without a check. */

#ifndef TP_DERIVE_CHECKS_H
#define TP_DERIVE_CHECKS_H

#include "derive/check_walk.h"

/* Fills in the list; for a scene of many vertices, or without conditions, none. */
TP_MUST_USE tp_status tp_checks_run(tp_derived_checks *checks, const tp_checked_formula *formula,
                                    tp_message *message);
void tp_checks_free(tp_derived_checks *checks);

#endif
