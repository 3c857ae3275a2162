/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What the calls of topple_blocks.h have in common. */

#ifndef TP_BATCH_BLOCKS_H
#define TP_BATCH_BLOCKS_H

#include "batch/outlines.h"
#include "common/host.h"
#include "common/options.h"

/* Refuse outlines and options that no call can go by. */
TP_MUST_USE tp_status tp_blocks_check(const tp_outlines *outlines, const tp_blocks_options *options,
                                      const char *call, tp_message *message);

/* What every call begins with: refuse NULL, and outlines and options that it cannot go by;
 * `options` is from then on the address of `own`. */
#define TP_BLOCKS_BEGIN(message, columns, summary, outlines, own, options)                         \
  do {                                                                                             \
    TP_REFUSE_NULL(message, columns);                                                              \
    TP_REFUSE_NULL(message, summary);                                                              \
    TP_REFUSE_NULL(message, outlines);                                                             \
    TP_REFUSE_NULL(message, options);                                                              \
    TP_TAKE_OPTIONS(message, own, options);                                                        \
    const tp_status tp_checked = tp_blocks_check(outlines, options, __func__, message);            \
    if (tp_checked != TP_OK) return tp_checked;                                                    \
  } while (false)

/* A number of a block into its columns, where these are wanted. */
static inline void tp_columns_put(double *values, double *errors, size_t block, tp_bounded number) {
  if (values != NULL) values[block] = number.value;
  if (errors != NULL) errors[block] = number.error;
}

#endif
