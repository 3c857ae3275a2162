/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What ranks say to one another, and one process to itself: sums of whole numbers, and how each
 * fared. One process is rank 0 of 1, and takes the same way. */

#ifndef TP_STUDY_TOGETHER_H
#define TP_STUDY_TOGETHER_H

#include "study/study.h"

static inline size_t tp_rank_of(const tp_study_ranks *ranks) {
  return ranks != NULL ? ranks->rank : 0;
}
static inline size_t tp_rank_count(const tp_study_ranks *ranks) {
  return ranks != NULL ? ranks->count : 1;
}
static inline bool tp_rank_is_first(const tp_study_ranks *ranks) {
  return tp_rank_of(ranks) == 0;
}

/* Where the part of a rank begins, of `count` pieces of work; that of the rank beyond the last is
 * their end. */
static inline uint64_t tp_rank_share(const tp_study_ranks *ranks, size_t rank, uint64_t count) {
  const uint64_t of = tp_rank_count(ranks);
  return count / of * rank + count % of * rank / of;
}

/* `before` NULL: not wanted. */
TP_MUST_USE tp_status tp_together_sum(const tp_study_ranks *ranks, uint64_t *before, uint64_t *all,
                                      const uint64_t *own, size_t count, tp_message *message);

/* After a sum of who failed (1 each): the first rank has the status and the message of the first
 * that did; the others TP_OK, and nothing more to do. */
TP_MUST_USE tp_status tp_together_tell(const tp_study_ranks *ranks, tp_status status,
                                       uint64_t failed_before, tp_message *message);

/* Both: `*failed` where any rank did. */
TP_MUST_USE tp_status tp_together_agree(const tp_study_ranks *ranks, tp_status status, bool *failed,
                                        tp_message *message);

/* To the first rank, and of it. */
TP_MUST_USE tp_status tp_together_send(const tp_study_ranks *ranks, const void *bytes, size_t size,
                                       tp_message *message);
TP_MUST_USE tp_status tp_together_receive(const tp_study_ranks *ranks, size_t rank, void **bytes,
                                          size_t *size, tp_message *message);

#endif
