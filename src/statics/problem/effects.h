/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The account of what ran and what called for it. */

#ifndef TP_PROBLEM_EFFECTS_H
#define TP_PROBLEM_EFFECTS_H

#include "common/message.h"

/* When an effect began, and the seconds of all effects noted by then. */
typedef struct tp_effect_begin {
  double now, noted;
} tp_effect_begin;

tp_effect_begin tp_effects_begin(const tp_solution *solution);

/* Note an effect; called for by a place in the scene, or where that has no file, by `instead`. Its
 * seconds are those since it began, without what other effects took that were noted since: no time
 * counts twice. A name noted before adds its seconds up. False when memory is exhausted. */
TP_MUST_USE bool tp_effects_note(tp_solution *solution, const char *name, tp_place place,
                                 const char *instead, tp_effect_begin since);

/* The same of an effect that took so many seconds. */
TP_MUST_USE bool tp_effects_add(tp_solution *solution, const char *name, tp_place place,
                                const char *instead, double seconds);

/* The status of a step that was `noted`, or could not be. */
TP_MUST_USE tp_status tp_effects_entered(tp_status status, tp_message *message, bool noted);

void tp_effects_clear(tp_solution *solution);

#endif
