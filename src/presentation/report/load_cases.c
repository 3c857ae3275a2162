/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Load cases as a table for a terminal, the one that governs first, and as JSON. */

#include "common/host.h"
#include "output/encode.h"
#include "output/wrap.h"
#include "report/results.h"
#include "report/words.h"
#include "terms/names.h"

#include <string.h>

static int width_of(const char *text) {
  return (int)tp_text_width(text, strlen(text));
}

static void add_factor(tp_text *t, const tp_load_case *own) {
  char n[TP_NUMBER_SIZE];
  const bool number = own->fos.state == TP_FOS_NUMBER;
  tp_text_add(t, "  %-9s",
              number                                    ? tp_text_fixed_down(n, own->fos.value, 3)
              : own->fos.state == TP_FOS_NO_OVERTURNING ? "unbounded"
              : own->fos.state == TP_FOS_UNDECIDED      ? "undecided"
                                                        : "none");
}

static void add_required(tp_text *t, const tp_load_case *own) {
  static const char *const words[] = {"met", "NOT MET", "undecided"};
  char n[TP_NUMBER_SIZE];
  tp_text_add(t, "  %-8s",
              own->has_required_fos ? tp_text_significant(n, own->required_fos, 5) : "-");
  tp_text_add(t, "  %-11s",
              own->has_design_utilisation ? tp_text_fixed_up(n, own->design_utilisation, 3)
              : own->has_utilisation      ? tp_text_fixed_up(n, own->utilisation, 3)
                                          : "-");
  tp_text_add(t, "  %-9s", own->has_required_fos ? words[own->meets_required] : "-");
}

static void add_case(tp_text *t, const tp_load_case *own, int width) {
  tp_text_add(t, "  ");
  tp_encode_column(t, own->name, width);
  add_factor(t, own);
  add_required(t, own);
  tp_text_add(t, "  %s, %s\n", tp_direction_name(own->towards),
              own->has_factor && own->against != TP_MECHANISM_UNDECIDED
                  ? tp_text_motion(own->against)
                  : tp_mechanism_name(own->mechanism));
}

/* On lines of their own, each factor behind a comma. */
static void add_factors(tp_text *t, const tp_load_case *own, bool *any) {
  const char *words = own->solution->partial_factors;
  if (words == NULL) return;
  tp_text_add(t, "%s  ", *any ? "" : "\nPartial factors\n");
  *any = true;
  const size_t named = strlen(own->name); /* that of a set often is the name of its case */
  if (strncmp(words, own->name, named) == 0 && words[named] == ':') {
    words += named + 1 + strspn(words + named + 1, " ");
  }
  tp_wrapping wrapping = {.indent = 4, .column = 2 + (size_t)width_of(own->name) + 2};
  tp_encode_plain(t, own->name);
  tp_text_add(t, ": ");
  tp_text_add_wrapped(t, words, &wrapping);
  tp_text_add(t, "\n");
}

tp_status tp_report_load_cases(char **text, const tp_load_cases *cases) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(NULL, text);
  TP_REFUSE_NULL(NULL, cases);
  int width = (int)strlen("case");
  for (size_t k = 0; k < cases->count; k++) {
    if (width_of(cases->cases[k].name) > width) width = width_of(cases->cases[k].name);
  }
  tp_text t = {0};
  tp_text_add(&t, "Load cases, the one that governs first\n\n  %-*s  %-9s  %-8s  %-11s  %-9s  %s\n",
              width, "case", "FoS", "required", "required/FoS", "", "against");
  for (size_t k = 0; k < cases->count; k++) add_case(&t, cases->cases + k, width);
  bool any = false;
  for (size_t k = 0; k < cases->count; k++) add_factors(&t, cases->cases + k, &any);
  return tp_text_finish(&t, text);
}

tp_status tp_report_load_cases_json(char **text, const tp_load_cases *cases,
                                    tp_pivots_listed listed) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(NULL, text);
  TP_REFUSE_NULL(NULL, cases);
  if (cases->count == 0) return TP_BAD_INPUT;
  tp_json_subject x = {.load_cases = cases, .s = cases->cases[0].solution, .listed = listed};
  return tp_json_document_of_solve(text, x.s, &x);
}
