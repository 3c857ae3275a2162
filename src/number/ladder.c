/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "number/ladder.h"

static const tp_rung rungs[] = {
    {TP_LEVEL_DOUBLE, 64},  {TP_LEVEL_BALL, 160},   {TP_LEVEL_EXACT, 320},
    {TP_LEVEL_EXACT, 1280}, {TP_LEVEL_EXACT, 5120},
};

tp_status tp_ladder_climb(tp_ladder_step step, void *context, tp_rung *reached) {
  for (size_t k = 0; k < sizeof rungs / sizeof rungs[0]; k++) {
    bool certain = false;
    *reached = rungs[k];
    const tp_status status = step(context, rungs[k], &certain);
    if (status != TP_OK) return status;
    if (certain) return TP_OK;
  }
  return TP_UNDECIDED;
}

const char *tp_level_name(tp_level level) {
  switch (level) {
  case TP_LEVEL_DOUBLE:
    return "double";
  case TP_LEVEL_BALL:
    return "ball";
  case TP_LEVEL_EXACT:
    return "exact";
  }
  return "unknown";
}
