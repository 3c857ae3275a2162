/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The calls of ranks with a message where one fails, and the complaint of one passed on to the
 * first. */

#include "study/together.h"

#include <stdlib.h>
#include <string.h>

static tp_status fail_lost(tp_message *message) {
  return tp_fail(message, TP_DEPENDENCY_FAILED, (tp_place){0},
                 "the ranks of the study do not reach one another");
}

tp_status tp_together_sum(const tp_study_ranks *ranks, uint64_t *before, uint64_t *all,
                          const uint64_t *own, size_t count, tp_message *message) {
  if (tp_rank_count(ranks) == 1) {
    if (before != NULL) memset(before, 0, count * sizeof *before);
    memcpy(all, own, count * sizeof *all);
    return TP_OK;
  }
  return ranks->sum(ranks->context, before, all, own, count) ? TP_OK : fail_lost(message);
}

tp_status tp_together_send(const tp_study_ranks *ranks, const void *bytes, size_t size,
                           tp_message *message) {
  return ranks->send(ranks->context, bytes, size) ? TP_OK : fail_lost(message);
}

tp_status tp_together_receive(const tp_study_ranks *ranks, size_t rank, void **bytes, size_t *size,
                              tp_message *message) {
  return ranks->receive(ranks->context, rank, bytes, size) ? TP_OK : fail_lost(message);
}

/* How a rank failed. */
typedef struct complaint {
  tp_status status;
  tp_message message;
} complaint;

static tp_status take_complaint(const tp_study_ranks *ranks, size_t rank, tp_message *message) {
  void *bytes = NULL;
  size_t size = 0;
  complaint own = {.status = TP_DEPENDENCY_FAILED};
  const tp_status status = tp_together_receive(ranks, rank, &bytes, &size, message);
  if (status == TP_OK && size == sizeof own) memcpy(&own, bytes, sizeof own);
  free(bytes);
  if (status != TP_OK) return status;
  if (message != NULL) *message = own.message;
  return own.status;
}

tp_status tp_together_tell(const tp_study_ranks *ranks, tp_status status, uint64_t failed_before,
                           tp_message *message) {
  if (tp_rank_count(ranks) == 1) return status;
  /* which rank it was, and 1, known to it alone */
  const uint64_t own = status != TP_OK && failed_before == 0 ? ranks->rank + 1 : 0;
  uint64_t before = 0, all = 0;
  const tp_status told = tp_together_sum(ranks, &before, &all, &own, 1, message);
  if (told != TP_OK) return told;
  if (tp_rank_is_first(ranks)) {
    return own > 0 ? status : take_complaint(ranks, (size_t)all - 1, message);
  }
  if (own == 0) return TP_OK;
  complaint sent = {.status = status};
  if (message != NULL) sent.message = *message;
  return tp_together_send(ranks, &sent, sizeof sent, message);
}

tp_status tp_together_agree(const tp_study_ranks *ranks, tp_status status, bool *failed,
                            tp_message *message) {
  const uint64_t own = status != TP_OK;
  uint64_t before = 0, all = 0;
  *failed = true;
  const tp_status told = tp_together_sum(ranks, &before, &all, &own, 1, message);
  if (told != TP_OK) return told;
  *failed = all > 0;
  return *failed ? tp_together_tell(ranks, status, before, message) : TP_OK;
}
