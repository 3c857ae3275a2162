/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* How long random tests take. */

#ifndef TP_TEST_ROUNDS_H
#define TP_TEST_ROUNDS_H

#include <stdlib.h>
#include <string.h>

/* How often a random test draws: `brief` times, `many` times under ./check --long, which sets
 * TOPPLE_LONG. The brief ones are of a fixed seed and take seconds. */
static inline long rounds(long brief, long many) {
  const char *text = getenv("TOPPLE_LONG");
  return text == NULL || text[0] == '\0' || strcmp(text, "0") == 0 ? brief : many;
}

#endif
