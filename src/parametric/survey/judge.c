/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* How a block stands, by the worst direction that its scene looks at; the order of blocks. */

#include "survey/judge.h"

#include "common/message.h"
#include "evaluation/case_numbers.h"
#include "output/text.h"
#include "stability/severity.h"
#include "survey/cell_check.h"
#include "topple_solve.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static bool is_certain_to_stand(const tp_case *c) {
  return c->mechanism == TP_STANDS || c->mechanism == TP_INTERLOCKED;
}

/* Of a scene with partial factors it is the factored one that is judged: it lacks the factor
 * required, and whether the block stands as it lies is not told. */
static tp_batch_standing standing_of(const tp_case *c, bool factored) {
  const tp_governing_fos *g = &c->governing_fos;
  const bool open = c->mechanism == TP_MECHANISM_UNDECIDED;
  const bool lacks = g->has_required_fos && g->meets_required == TP_DESIGN_NOT_MET && !open;
  if (lacks && factored) return TP_BATCH_BELOW;
  if (!open && !is_certain_to_stand(c)) return TP_BATCH_FAILS;
  if (lacks) return TP_BATCH_BELOW;
  if (open || !g->complete || g->fos.state == TP_FOS_UNDECIDED) return TP_BATCH_UNDECIDED;
  if (g->has_required_fos && g->meets_required != TP_DESIGN_MET) return TP_BATCH_UNDECIDED;
  return TP_BATCH_HOLDS;
}

void tp_batch_add_bounds(tp_text *text, const tp_batch_row *row) {
  static const double fifth = 1e5;
  if (row->fos.state != TP_FOS_UNDECIDED) return;
  const double least = floor(row->at_least * fifth) / fifth;
  const bool has_least = least > 0, has_most = isfinite(row->at_most);
  if (!has_least && !has_most) return;
  tp_text_add(text, "%sthe factor of safety is", text->length > 0 ? "; " : "");
  if (has_least) tp_text_add(text, " at least %.5f%s", least, has_most ? " and" : "");
  if (has_most) tp_text_add(text, " at most %.5f", ceil(row->at_most * fifth) / fifth);
}

/* What is known of an undecided factor, and the cautions, one after the other. */
static char *make_remark(const tp_batch_row *row, const tp_solution *s) {
  tp_text text = {0};
  char *remark = NULL;
  tp_batch_add_bounds(&text, row);
  for (size_t k = 0; k < s->notes.count; k++) {
    const tp_note *note = s->notes.items + k;
    if (note->kind == TP_CAUTION) {
      tp_text_add(&text, "%s%s", text.length > 0 ? "; " : "", note->text);
    }
  }
  tp_text_add(&text, "%s", "");
  return tp_text_finish(&text, &remark) == TP_OK ? remark : NULL;
}

static tp_status check(const tp_solution *s, tp_message *message) {
  bool judged = true;
  for (size_t k = 0; k < s->case_count; k++) {
    judged = judged && s->cases[k].governing_fos.sliding_judged;
  }
  if (s->has_tilt_angle && judged) return TP_OK;
  return tp_refuse(message, TP_FAULT_KEY, (tp_place){0}, "%s%s%s",
                   s->has_tilt_angle ? "" : tp_row_no_dip, s->has_tilt_angle || judged ? "" : "; ",
                   judged ? "" : tp_row_no_friction);
}

tp_status tp_batch_judge(tp_batch_row *row, const tp_solution *s, tp_message *message) {
  const tp_status status = check(s, message);
  if (status != TP_OK) return status;
  const tp_case *c = s->cases + tp_severity_worst(s);
  const tp_governing_fos *g = &c->governing_fos;
  const tp_factor *factor = tp_case_factor(c);
  tp_batch_row own = {
      .has_case = true, .fos = g->fos, .at_least = g->at_least, .at_most = g->at_most};
  char *remark = make_remark(&own, s);
  if (remark == NULL) return tp_fail_memory(message, "a table");
  char *load_case = s->load_case != NULL ? strdup(s->load_case) : NULL;
  if (s->load_case != NULL && load_case == NULL) {
    free(remark);
    return tp_fail_memory(message, "a table");
  }
  free(row->remark);
  free(row->load_case);
  row->remark = remark;
  row->load_case = load_case;
  row->has_case = true;
  row->as_it_lies = s->frame.world;
  row->standing = standing_of(c, s->partial_factors != NULL);
  row->status = tp_solution_is_undecided(s) ? TP_UNDECIDED : TP_OK;
  if (row->status == TP_UNDECIDED && row->standing == TP_BATCH_HOLDS) {
    row->standing = TP_BATCH_UNDECIDED;
  }
  row->dip_deg = s->tilt_angle_deg;
  row->towards = c->towards;
  row->verdict = c->mechanism;
  row->fos = g->fos;
  row->at_least = g->at_least;
  row->at_most = g->at_most;
  row->has_fos_mechanism = factor != NULL;
  if (factor != NULL) row->fos_mechanism = factor->mechanism;
  row->has_required_fos = g->has_required_fos;
  row->required_fos = g->required_fos;
  row->meets_required = g->meets_required;
  row->has_design_utilisation = g->has_design_utilisation;
  row->design_utilisation = g->design_utilisation;
  row->has_margin = c->has_margin;
  row->margin_deg = c->margin_deg;
  row->dip_deg.digits = row->fos.value.digits = row->required_fos.digits = row->margin_deg.digits =
      row->design_utilisation.digits = NULL; /* which the solution owns */
  return TP_OK;
}

/* The factor over what it is to be; of an undecided one its upper bound, then its lower one. */
enum { BY_MOST, BY_LEAST, SHARES };

static void set_shares(double shares[SHARES], const tp_batch_row *row) {
  const double required = row->has_required_fos ? row->required_fos.value : 1;
  shares[BY_MOST] = shares[BY_LEAST] = 0;
  if (!row->has_case) return;
  switch (row->fos.state) {
  case TP_FOS_NUMBER:
    shares[BY_MOST] = shares[BY_LEAST] = row->fos.value.value / required;
    return;
  case TP_FOS_NO_OVERTURNING:
    shares[BY_MOST] = shares[BY_LEAST] = INFINITY;
    return;
  case TP_FOS_UNDECIDED:
    shares[BY_MOST] = row->at_most / required;
    shares[BY_LEAST] = row->at_least / required;
    return;
  default:
    return;
  }
}

int tp_batch_compare(const void *one, const void *other) {
  const tp_batch_row *a = one, *b = other;
  double of_a[SHARES], of_b[SHARES];
  if (a->standing != b->standing) return a->standing < b->standing ? -1 : 1;
  set_shares(of_a, a);
  set_shares(of_b, b);
  for (int k = 0; k < SHARES; k++) {
    if (of_a[k] < of_b[k] || of_b[k] < of_a[k]) return of_a[k] < of_b[k] ? -1 : 1;
  }
  const int names = strcmp(a->name, b->name);
  if (names != 0) return names;
  return (a->line > b->line) - (a->line < b->line);
}
