/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Defaults and checks of the options that all calls on many blocks share (docs/blocks.md). */

#include "batch/blocks.h"

TP_OPTIONS_END(tp_blocks_options, towards);

void tp_blocks_options_init(tp_blocks_options *options, size_t size) {
  const tp_blocks_options defaults = {.size = sizeof defaults,
                                      .limit = true,
                                      .strength_reduction = true,
                                      .towards = TP_TOWARDS_LEFT};
  tp_options_fill(options, size, &defaults);
}

tp_numbers tp_numbers_of(double all) {
  return (tp_numbers){.all = all};
}

tp_numbers tp_numbers_each(const double *each) {
  return (tp_numbers){.each = each};
}

tp_status tp_blocks_check(const tp_outlines *outlines, const tp_blocks_options *options,
                          const char *call, tp_message *message) {
  if (options->towards != TP_TOWARDS_LEFT && options->towards != TP_TOWARDS_RIGHT) {
    return tp_refuse(message, TP_FAULT_ARGUMENT, (tp_place){0},
                     "%s: 'towards' must be the left or the right", call);
  }
  return tp_outlines_check(outlines, call, message);
}
