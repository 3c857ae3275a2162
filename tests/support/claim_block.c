/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "claim_block.h"

#include "suite.h"

#include <inttypes.h>

uint64_t seed;
tp_message claim_message;

void claim(bool condition, const char *what) {
  if (!condition)
    ck_abort_msg("%s: TOPPLE_RANDOM_SEED=%" PRIu64 "; %s", what, seed, claim_message.text);
}

wide dot(const polygon *p, long a, long b, long c, long d) {
  return (wide)(p->x[b] - p->x[a]) * (p->x[d] - p->x[c]) +
         (wide)(p->y[b] - p->y[a]) * (p->y[d] - p->y[c]);
}
