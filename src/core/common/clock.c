/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Monotonic clock of POSIX, in seconds. */

#define _POSIX_C_SOURCE 200809L
#include "common/clock.h"

#include <time.h>

double tp_clock_now(void) {
  struct timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}
