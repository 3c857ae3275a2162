/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* How many blocks stand, by the direction that governs. Limit analysis alone promises nothing: what
 * forces can hold, and is not proven to stand, is undecided. */

#include "survey/judge_system.h"

#include "block_system/governing_case.h"
#include "common/message.h"
#include "output/text.h"

#include <math.h>
#include <stdlib.h>

static tp_batch_standing standing_of_system(const tp_system_case *c) {
  if (c->verdict == TP_SYSTEM_COLLAPSES || c->verdict == TP_SYSTEM_MAY_MOVE) return TP_BATCH_FAILS;
  if (c->has_required_fos && c->meets_required == TP_DESIGN_NOT_MET) return TP_BATCH_BELOW;
  if (c->verdict != TP_SYSTEM_STANDS) return TP_BATCH_UNDECIDED;
  return c->has_required_fos && c->meets_required == TP_DESIGN_OPEN ? TP_BATCH_UNDECIDED
                                                                    : TP_BATCH_HOLDS;
}

static tp_mechanism verdict_of(const tp_system_case *c) {
  const tp_mechanism collapse = tp_system_case_mechanism(c);
  switch (c->verdict) {
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

/* 2: not met, or it does not stand; 1: open; 0: met, as tp_severity has it. */
static int rank_of(const tp_system_case *c) {
  if (c->verdict == TP_SYSTEM_COLLAPSES || c->verdict == TP_SYSTEM_MAY_MOVE) return 2;
  if (c->has_required_fos && c->meets_required == TP_DESIGN_NOT_MET) return 2;
  if (c->verdict != TP_SYSTEM_STANDS) return 1;
  return c->has_required_fos && c->meets_required == TP_DESIGN_OPEN ? 1 : 0;
}

tp_severity tp_batch_system_severity(const tp_block_system *system) {
  const tp_system_case *c = tp_system_governing(system);
  const tp_fos fos = tp_system_case_factor(c).fos;
  const double required = c->has_required_fos ? system->required_fos.value : 1;
  const bool number = fos.state == TP_FOS_NUMBER && fos.value.value > 0;
  const double need = number                               ? required / fos.value.value
                      : fos.state == TP_FOS_NO_OVERTURNING ? 0
                                                           : INFINITY;
  return (tp_severity){rank_of(c), need};
}

/* What the factor does not say, and the cautions. */
static char *tell_remark(const tp_block_system *s, const tp_system_case *c) {
  tp_text text = {0};
  char *remark = NULL;
  if (c->verdict == TP_SYSTEM_CAN_HOLD) {
    tp_text_add(&text, "forces can hold the blocks; that a motion begins all the same is neither "
                       "excluded nor proven");
  }
  if (c->verdict == TP_SYSTEM_MAY_MOVE) {
    tp_text_add(&text, "forces can hold the blocks, but a motion can begin all the same");
  }
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
  const tp_system_case *c = tp_system_governing(s);
  const tp_mechanism collapse = tp_system_case_mechanism(c);
  char *remark = tell_remark(s, c);
  if (remark == NULL) return tp_fail_memory(message, "a table");
  free(row->remark);
  row->remark = remark;
  row->has_case = true;
  row->as_it_lies = s->lies_in_place;
  row->standing = standing_of_system(c);
  row->status = tp_block_system_is_undecided(s) ? TP_UNDECIDED : TP_OK;
  row->dip_deg = c->tilt_angle_deg;
  row->towards = c->towards;
  row->verdict = verdict_of(c);
  row->fos = tp_system_case_factor(c).fos;
  row->has_fos_mechanism = collapse != TP_STANDS;
  row->fos_mechanism = collapse;
  row->has_required_fos = c->has_required_fos;
  row->required_fos = s->required_fos;
  row->meets_required = c->meets_required;
  row->dip_deg.digits = row->fos.value.digits = row->required_fos.digits = NULL;
  return TP_OK;
}
