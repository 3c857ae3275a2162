/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Prints 15, 16, then 17 significant digits until the text reads back as the same double. */

#include "number/shortest.h"

#include <stdio.h>
#include <stdlib.h>

const char *tp_shortest(char out[TP_SHORTEST_SIZE], double value) {
  for (int digits = 15; digits <= 17; digits++) {
    snprintf(out, TP_SHORTEST_SIZE, "%.*g", digits, value);
    if (strtod(out, NULL) == value) break;
  }
  return out;
}
