/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* How many blocks stand, by the direction that governs. Limit analysis alone promises nothing: what
 * forces can hold, and is not proven to stand, is undecided. */

#include "survey/judge_system.h"

#include "block_system/governing_case.h"
#include "common/message.h"
#include "number/bounded.h"
#include "survey/judge.h"

#include <stdlib.h>

static tp_batch_standing standing_of_system(tp_system_verdict verdict, bool is_required,
                                            tp_design meets) {
  if (verdict == TP_SYSTEM_COLLAPSES || verdict == TP_SYSTEM_MAY_MOVE) return TP_BATCH_FAILS;
  if (is_required && meets == TP_DESIGN_NOT_MET) return TP_BATCH_BELOW;
  if (verdict != TP_SYSTEM_STANDS) return TP_BATCH_UNDECIDED;
  return is_required && meets == TP_DESIGN_OPEN ? TP_BATCH_UNDECIDED : TP_BATCH_HOLDS;
}

static tp_mechanism verdict_of(const tp_system_case *c) {
  const tp_mechanism collapse = tp_system_case_mechanism(c);
  switch (tp_system_case_worst_verdict(c)) {
  case TP_SYSTEM_STANDS:
    return TP_STANDS;
  case TP_SYSTEM_CAN_HOLD:
  case TP_SYSTEM_MAY_MOVE:
    return TP_MAY_MOVE;
  case TP_SYSTEM_COLLAPSES:
    return collapse != TP_STANDS ? collapse : TP_MECHANISM_UNDECIDED;
  case TP_SYSTEM_UNDECIDED:
    break;
  }
  return TP_MECHANISM_UNDECIDED;
}

tp_severity tp_batch_system_severity(const tp_block_system *system) {
  const tp_safety safety = {.verdict = tp_system_case_rule(tp_system_most_severe(system)).verdict,
                            .least = system->governing_fos.at_least,
                            .most = system->governing_fos.at_most};
  return tp_severity_of_safety(&safety, system->has_required_fos, system->required_fos.value);
}

/* What the factor does not say, and the cautions. */
static char *tell_remark(const tp_batch_row *row, const tp_block_system *s,
                         const tp_system_case *c) {
  tp_text text = {0};
  char *remark = NULL;
  const tp_system_case *worst = tp_system_most_severe(s);
  const tp_system_verdict verdict = tp_system_case_worst_verdict(worst);
  if (verdict == TP_SYSTEM_CAN_HOLD) {
    tp_text_add(&text, "forces can hold the blocks; that a motion begins all the same is neither "
                       "excluded nor proven");
  }
  if (verdict == TP_SYSTEM_MAY_MOVE) {
    tp_text_add(&text, "forces can hold the blocks, but a motion can begin all the same");
  }
  if (verdict != worst->verdict) {
    tp_text_add(&text, "%swithout the earthquake", text.length > 0 ? "; this is " : "this is ");
  }
  tp_batch_add_bounds(&text, row);
  if (c->goodman_bray.applies && c->goodman_bray.has_fos) {
    char n[TP_NUMBER_SIZE];
    tp_text_add(&text, "%sby Goodman and Bray the factor is %s", text.length > 0 ? "; " : "",
                tp_text_significant_down(n, (tp_bounded){c->goodman_bray.fos, 0, NULL}, 5));
  }
  for (size_t k = 0; k < s->notes.count; k++) {
    if (s->notes.items[k].kind != TP_CAUTION) continue;
    tp_text_add(&text, "%s%s", text.length > 0 ? "; " : "", s->notes.items[k].text);
  }
  tp_text_add(&text, "%s", "");
  return tp_text_finish(&text, &remark) == TP_OK ? remark : NULL;
}

tp_status tp_batch_judge_system(tp_batch_row *row, const tp_block_system *s, tp_message *message) {
  const tp_system_case *c = tp_system_governing(s), *worst = tp_system_most_severe(s);
  const tp_system_safety *safety = &s->governing_fos;
  const tp_design meets = tp_block_system_meets(s, s->required_fos.value);
  const tp_batch_row own = {
      .fos = safety->fos, .at_least = safety->at_least, .at_most = safety->at_most};
  char *remark = tell_remark(&own, s, c);
  if (remark == NULL) return tp_fail_memory(message, "a table");
  free(row->remark);
  row->remark = remark;
  row->has_case = true;
  row->as_it_lies = s->lies_in_place;
  row->standing =
      standing_of_system(tp_system_case_worst_verdict(worst), s->has_required_fos, meets);
  row->status = tp_block_system_is_undecided(s) ? TP_UNDECIDED : TP_OK;
  row->dip_deg = c->tilt_angle_deg;
  row->towards = c->towards;
  row->verdict = verdict_of(worst);
  row->fos = safety->fos;
  row->at_least = safety->at_least;
  row->at_most = safety->at_most;
  row->has_fos_mechanism = safety->has_definition && safety->mechanism != TP_STANDS;
  row->fos_mechanism = safety->mechanism;
  row->has_required_fos = s->has_required_fos;
  row->required_fos = s->required_fos;
  row->meets_required = meets;
  row->has_design_utilisation = s->has_required_fos && safety->fos.state == TP_FOS_NUMBER &&
                                safety->fos.value.value > safety->fos.value.error;
  if (row->has_design_utilisation) {
    row->design_utilisation = tp_bounded_over(s->required_fos, safety->fos.value);
  }
  row->dip_deg.digits = row->fos.value.digits = row->required_fos.digits =
      row->design_utilisation.digits = NULL;
  return TP_OK;
}
