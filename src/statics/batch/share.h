/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* One piece of work for each of many blocks, shared out to threads.
 *
 * Blocks are handed out in chunks of a fixed size, in their order; a block is worked on alone and
 * fills its own places of the columns, so what comes out does not depend on the number of threads:
 * counts are sums, and the complaint is that of the first bad block. */

#ifndef TP_BATCH_SHARE_H
#define TP_BATCH_SHARE_H

#include "common/message.h"

/* What a thread works with: nothing of it outlives a block but the counts. */
typedef struct tp_workspace {
  double *room; /* of numbers, as tp_workspace_reserve has made it */
  size_t capacity;
  bool borrowed; /* the room is not its own */
  tp_blocks_summary summary;
} tp_workspace;

/* Room for `count` numbers, whose values are lost; false when memory is exhausted. */
TP_MUST_USE bool tp_workspace_reserve(tp_workspace *workspace, size_t count);
void tp_workspace_clear(tp_workspace *workspace);

/* The block's status: TP_OK, TP_NO_ANSWER, TP_UNDECIDED and TP_BAD_INPUT are its own, and counted;
 * any other ends the whole. The message is without the number of the block. */
typedef tp_status tp_block_work(tp_workspace *workspace, const void *task, size_t block,
                                tp_message *message);

/* Each of `count` blocks, in chunks of `chunk`, by as many threads as the options say. */
TP_MUST_USE tp_status tp_share_out(tp_blocks_summary *summary, tp_block_work *work,
                                   const void *task, size_t count, size_t chunk, size_t threads,
                                   tp_message *message);

#endif
