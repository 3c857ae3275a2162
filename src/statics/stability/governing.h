/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Which factor of safety governs: the least over what can happen, each by the definition that its
 * mode has in practice. */

#ifndef TP_STABILITY_GOVERNING_H
#define TP_STABILITY_GOVERNING_H

#include "topple.h"

/* The factor of safety that governs each case, from what the solution holds. */
void tp_solution_govern(tp_solution *solution, const tp_scene *scene);

#endif
