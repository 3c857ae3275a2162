/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The account of what ran and what called for it. */

#ifndef TP_EFFECTS_H
#define TP_EFFECTS_H

#include "message.h"

/* Seconds of a clock that never goes back. */
double tp_effects_now(void);

/* Note an effect that began at `since`; called for by a place in the scene, or where that has no
 * file, by `instead`. A name noted before adds its seconds up. */
void tp_effects_note(tp_solution *solution, const char *name, tp_place place, const char *instead,
                     double since);

#endif
