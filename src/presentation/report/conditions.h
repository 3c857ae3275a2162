/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Where a derived formula holds: its conditions, and those of them that were looked at from both
 * sides. */

#ifndef TP_REPORT_CONDITIONS_H
#define TP_REPORT_CONDITIONS_H

#include "output/json.h"

/* Of the limit, which holds on its conditions' zeros too, or of the onset, which does not. */
typedef struct tp_condition_list {
  const char *what;
  bool zeros;
  bool positive; /* all parameters are, and the conditions suppose so */
  size_t count;
  const tp_fraction *items;
  const tp_derived_checks *checks;
} tp_condition_list;

/* "\n  as long as, …", a line for each, what was solved about it below; last how many were not. */
void tp_text_conditions(tp_text *text, const tp_condition_list *list);

void tp_latex_conditions(tp_text *text, const tp_condition_list *list);

/* `double tan_limit_left(…)`, behind an opened comment that it closes, and `int is_limit_left(…)`.
 */
void tp_c_conditional(tp_text *text, const tp_condition_list *list, const tp_derivation *derivation,
                      const char *tangent, const char *side);

#endif
