/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* How many threads a call starts where its caller names no number. */

#define _GNU_SOURCE /* sched_getaffinity */
#include "common/threads.h"

#include <sched.h>
#include <stdbool.h>
#include <unistd.h>

size_t tp_threads_present(void) {
  cpu_set_t set;
  const bool known = sched_getaffinity(0, sizeof set, &set) == 0;
  const long present = known ? CPU_COUNT(&set) : sysconf(_SC_NPROCESSORS_ONLN);
  return present > 1 ? (size_t)present : 1;
}
