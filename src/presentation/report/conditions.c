/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Conditions of a derived formula as inequalities in text, LaTeX, C and JSON, with the scenes
 * solved on both sides of each. */

#include "report/conditions.h"

#include "report/c_arguments.h"
#include "terms/names.h"

#include <stdlib.h>
#include <string.h>

/* What was solved about a condition, where it was met. */
static void add_check(tp_text *t, const tp_derived_checks *checks, size_t condition,
                      const char *what) {
  for (size_t k = 0; k < checks->count; k++) {
    const tp_derived_check *c = checks->items + k;
    if (c->condition != condition) continue;
    tp_text_add(t, "      solved at %s: the %s is the formula's; at %s: ", c->inside, what,
                c->outside);
    switch (c->beyond) {
    case TP_CHECK_SAME:
      tp_text_add(t, "it still is\n");
      break;
    case TP_CHECK_OTHER:
      tp_text_add(t, "it is another\n");
      break;
    case TP_CHECK_NONE:
      tp_text_add(t, "there is none\n");
      break;
    case TP_CHECK_CONTACT:
      tp_text_add(t, "the contact is another\n");
      break;
    case TP_CHECK_REFUSED:
      tp_text_add(t, "the scene has no answer\n");
      break;
    case TP_CHECK_UNDECIDED:
      tp_text_add(t, "undecided\n");
      break;
    }
  }
}

void tp_text_conditions(tp_text *t, const tp_condition_list *l) {
  tp_text_add(t, "\n  as long as%s",
              l->count == 0 ? " all of these are above zero: always\n"
              : l->positive ? ", all parameters being above zero,\n"
                            : "\n");
  for (size_t k = 0; k < l->count; k++) {
    tp_text_add(t, "    %s %s 0\n", l->items[k].formula, l->zeros ? ">=" : ">");
    add_check(t, l->checks, k, l->what);
  }
  if (!l->checks->run || l->checks->count >= l->count) return;
  tp_text_add(t, "  (%zu of these %zu: others fail first in all directions tried)\n",
              l->count - l->checks->count, l->count);
}

void tp_latex_conditions(tp_text *t, const tp_condition_list *l) {
  for (size_t k = 0; k < l->count; k++) {
    tp_text_add(t, "\\[ %s %s 0 \\]\n", l->items[k].formula, l->zeros ? "\\ge" : ">");
  }
}

void tp_c_conditional(tp_text *t, const tp_condition_list *l, const tp_derivation *d,
                      const char *tangent, const char *side) {
  tp_text_add(t, " */\ndouble tan_%s_%s", l->what, side);
  tp_c_arguments(t, d, "double phi");
  tp_text_add(t, "  (void)phi;\n  return %s;\n}\n\n/* does that formula hold? */\nint is_%s_%s",
              tangent, l->what, side);
  tp_c_arguments(t, d, "double phi");
  tp_text_add(t, "  (void)phi;\n  return 1");
  for (size_t k = 0; k < l->count; k++) {
    tp_text_add(t, "\n         && %s %s 0", l->items[k].formula, l->zeros ? ">=" : ">");
  }
  tp_text_add(t, ";\n}\n");
}
