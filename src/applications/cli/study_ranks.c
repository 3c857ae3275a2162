/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A study by the ranks of mpirun: read by all, of which the first that cannot complains, and run
 * together by the library. */

#include "cli/study_run.h"

/* Where a rank failed no other goes on; `*failed` says so. */
static tp_status agree(const tp_study_ranks *ranks, tp_status status, bool *failed,
                       tp_message *message) {
  const uint64_t own = status != TP_OK;
  uint64_t before = 0, all = 0;
  *failed = true;
  if (!ranks->sum(ranks->context, &before, &all, &own, 1)) return TP_DEPENDENCY_FAILED;
  *failed = all > 0;
  if (before == 0 || status == TP_OK) return status;
  message->text[0] = '\0'; /* one before this one complains */
  return TP_OK;
}

tp_status tp_cli_study_by_ranks(tp_study_result **result, const tp_ranks *ranks, const char *path,
                                const tp_study_options *options, tp_message *message) {
  tp_study *study = NULL;
  tp_study_options own = *options;
  bool failed = false;
  own.ranks = &ranks->own;
  tp_status status = tp_study_read(&study, path, message);
  status = agree(own.ranks, status, &failed, message);
  if (!failed) status = tp_cli_study_run(result, study, &own, message);
  tp_study_free(study);
  return status;
}
