/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What the calls of topple_blocks.h have in common. */

#ifndef TP_BLOCKS_H
#define TP_BLOCKS_H

#include "batch/outlines.h"
#include "options.h"

/* Refuse outlines and options that no call can go by. */
TP_MUST_USE tp_status tp_blocks_check(const tp_outlines *outlines, const tp_blocks_options *options,
                                      const char *call, tp_message *message);

#endif
