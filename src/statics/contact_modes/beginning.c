/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Rounds of equations and laws, until these hold. */

#include "contact_modes/beginning.h"

#include "common/message.h"
#include "contact_modes/basis_proof.h"
#include "contact_modes/mode_laws.h"

#include <stdlib.h>

static void tell(double *accelerations, const tp_mode_equations *s) {
  const tp_resting *r = s->groups->resting;
  arb_struct a[3];
  for (int e = 0; e < 3; e++) arb_init(a + e);
  for (long row = 0; row < r->rows; row++) accelerations[row] = 0;
  for (long f = 0; f < s->groups->freedom; f++) {
    const double share = arf_get_d(arb_midref(arb_mat_entry(s->factors, f, 0)), ARF_RND_NEAR);
    for (long b = 0; b < r->rows / 3; b++) {
      tp_mode_acceleration(a, s, r->block[b], f);
      for (int e = 0; e < 3; e++) {
        accelerations[3 * b + e] += share * arf_get_d(arb_midref(a + e), ARF_RND_NEAR);
      }
    }
  }
  for (int e = 0; e < 3; e++) arb_clear(a + e);
}

/* What slips and bears nothing is held by nothing either: its block is free of it. */
static void let_idle_go(tp_trial_mode *trial, const tp_beginning_question *q) {
  static const double nothing = 1e-9;
  for (long k = 0; k < q->groups->resting->contact_count; k++) {
    const double *normals = q->normals + 2 * k;
    const bool bears = normals[0] > nothing || normals[1] > nothing;
    const bool slips = (trial[k].mode & (TP_MODES_FORWARD | TP_MODES_BACK)) != 0;
    if (slips && !bears && trial[k].spent == 0) trial[k] = (tp_trial_mode){.mode = TP_MODES_OPEN};
  }
}

static tp_status solve(tp_laws *laws, double *accelerations, tp_trial_mode *trial,
                       const tp_beginning_question *q, tp_message *message) {
  tp_mode_equations s = {.question = q, .groups = q->groups, .trial = trial};
  tp_status status = tp_mode_equations_init(&s, message);
  if (status != TP_OK) return status;
  const tp_basis_task task = {s.columns, s.right, s.preference, TP_EQUATION_BITS};
  status = tp_basis_solve(s.factors, &task, message);
  if (status == TP_OK) *laws = tp_mode_laws(trial, &s);
  if (status == TP_OK && *laws == TP_LAWS_HOLD) tell(accelerations, &s);
  tp_mode_equations_clear(&s);
  return status == TP_NO_ANSWER ? TP_OK : status;
}

tp_status tp_beginning_prove(bool *proven, double *accelerations, tp_trial_mode *trial,
                             const tp_beginning_question *q, tp_message *message) {
  enum { ROUNDS = 4 };
  const long count = q->groups->resting->contact_count;
  *proven = false;
  tp_mode_set *modes = calloc((size_t)count + 1, sizeof *modes);
  if (modes == NULL) return tp_fail_memory(message, "a proof");
  let_idle_go(trial, q);
  tp_status status = TP_OK;
  tp_laws laws = TP_LAWS_CHANGED;
  for (int k = 0; k < ROUNDS && laws == TP_LAWS_CHANGED && status == TP_OK; k++) {
    for (long c = 0; c < count; c++) modes[c] = trial[c].mode;
    status = tp_rigid_groups_find(q->groups, modes, message);
    laws = TP_LAWS_BROKEN;
    if (status == TP_OK && q->groups->freedom > 0) {
      status = solve(&laws, accelerations, trial, q, message);
    }
  }
  free(modes);
  *proven = status == TP_OK && laws == TP_LAWS_HOLD;
  return status;
}
