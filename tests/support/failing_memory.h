/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* malloc and its kin with one request that fails, the same each time it is run. Linked into a
 * program it counts and fails as told here; loaded before the C library (LD_PRELOAD) as told by
 * TOPPLE_FAIL_AT. */

#ifndef TP_TEST_FAILING_MEMORY_H
#define TP_TEST_FAILING_MEMORY_H

#include <stdbool.h>

typedef struct failing_memory {
  long fail_at;  /* the request that fails, from 1; 0: none */
  long requests; /* so far */
  long live;     /* blocks that were taken and not given back */
  bool lasting;  /* all that come after it fail too */
  bool spared;   /* requests neither count nor fail */
  bool was_new;  /* one that failed was C++'s operator new */
} failing_memory;

extern failing_memory failing_memory_state;

#endif
