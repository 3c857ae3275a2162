/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A solution as JSON: what the table of `topple solve` calls (core/terms/results/solve.csv), and
 * the calls that write the whole. */

#include "report/solution_json.h"

#include "common/host.h"
#include "problem/bearing.h"
#include "report/results.h"

static bool are_all_told(const tp_case *c) {
  for (size_t k = 0; k < c->pivot_count; k++) {
    if (!c->pivots[k].computed) return false;
  }
  return c->pivot_count == c->candidate_count;
}

void tp_json_enter_load_case(tp_json_subject *x, const tp_load_case *own) {
  x->s = own->solution;
}

void tp_json_enter_case(tp_json_subject *x, const tp_case *c) {
  const bool few = c->candidate_count <= TP_PIVOTS_MANY;
  x->c = c;
  x->case_index = (size_t)(c - x->s->cases);
  x->all_pivots =
      (x->listed == TP_PIVOTS_ALL || (x->listed == TP_PIVOTS_BY_COUNT && few)) && are_all_told(c);
}

bool tp_json_lists_pivot(const tp_json_subject *x, size_t k) {
  const tp_pivot *p = x->c->pivots + k;
  const bool governs = x->c->has_toppling_pivot && k == x->c->toppling_pivot;
  return x->all_pivots || p->admissible || governs || tp_pivot_bears(p, &x->c->limit);
}

bool tp_pivot_has_fos(const tp_pivot *p, tp_fos fos) {
  return fos.state == TP_FOS_NUMBER && (p->admissible || tp_text_fos(fos) == NULL);
}

const char *tp_text_holds_from_is(tp_limit_kind kind) {
  switch (kind) {
  case TP_LIMIT_AT_ANGLE:
    break;
  case TP_LIMIT_UNDECIDED:
    return "undecided";
  case TP_LIMIT_NOWHERE:
    return "at no tilt";
  case TP_LIMIT_INTERLOCKED:
  case TP_LIMIT_NOT_ASKED:
    return "however far it is tilted back";
  }
  return NULL;
}

const char *tp_text_margin_is(const tp_solution *s, const tp_case *c) {
  if (c->has_margin) return NULL;
  if (!s->has_tilt_angle) return "no tilt given";
  switch (c->onset.kind) {
  case TP_ONSET_NOWHERE:
    return "certain to stand at no tilt";
  case TP_ONSET_NEVER:
    return "certain to stand at every tilt";
  case TP_ONSET_NOT_ASKED:
    return c->first == TP_INTERLOCKED           ? "certain to stand at every tilt"
           : c->first == TP_MECHANISM_UNDECIDED ? "undecided"
                                                : "certain to stand at no tilt";
  case TP_ONSET_UNDECIDED:
  case TP_ONSET_AT_ANGLE:
    break;
  }
  return "undecided";
}

const char *tp_text_steepen_is(const tp_solution *s, const tp_case *c) {
  if (!s->frame.world || s->frame.level || c->may_steepen) return NULL;
  if (!s->has_tilt_angle) return "no tilt given";
  if (c->mechanism == TP_MECHANISM_UNDECIDED || c->onset.kind == TP_ONSET_UNDECIDED ||
      c->onset.kind == TP_ONSET_NOT_ASKED) {
    return "undecided";
  }
  const bool stands = c->mechanism == TP_STANDS || c->mechanism == TP_INTERLOCKED;
  return stands ? "certain to stand at every dip" : "does not stand as it lies";
}

const char *tp_text_sliding_method(const tp_solution *s) {
  return s->loaded               ? "forces along and across the facet"
         : s->friction_is_patton ? "Patton, phi_b + i"
                                 : "phi + i";
}

const char *tp_text_reduction(tp_fos fos) {
  return fos.state == TP_FOS_UNDEFINED ? "none: not certain to stand at any strength"
                                       : tp_text_fos(fos);
}

const char *tp_text_driving(tp_fos fos) {
  return fos.state == TP_FOS_UNDEFINED ? "none: a motion can begin even without driving loads"
                                       : tp_text_fos(fos);
}

const char *tp_text_no_factor(const tp_governing_fos *g) {
  if (g->up_dip) return "none: at this tilt it fails up-dip";
  if (g->beyond) return "none: it already fails at a lower tilt";
  if (g->fos.state == TP_FOS_NO_TILT) return "none: the scene gives no tilt";
  if (g->fos.state == TP_FOS_NOT_ASKED) return "none: turning is blocked about every pivot";
  return NULL;
}

const char *tp_text_factor_is(const tp_governing_fos *g) {
  const char *why = tp_text_no_factor(g);
  return why != NULL ? why : tp_text_fos(g->fos);
}

void tp_json_solution(tp_json *j, const tp_solution *s, tp_pivots_listed listed) {
  tp_json_subject x = {.s = s, .listed = listed};
  tp_json_members_of_solve(j, s, &x);
}

tp_status tp_report_json(char **text, const tp_solution *solution) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(NULL, text);
  TP_REFUSE_NULL(NULL, solution);
  return tp_report_json_pivots(text, solution, TP_PIVOTS_BY_COUNT);
}

tp_status tp_report_json_pivots(char **text, const tp_solution *solution, tp_pivots_listed listed) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(NULL, text);
  TP_REFUSE_NULL(NULL, solution);
  tp_json_subject x = {.s = solution, .listed = listed};
  return tp_json_document_of_solve(text, solution, &x);
}
