/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* How many threads a call starts where its caller names no number. */

#ifndef TP_COMMON_THREADS_H
#define TP_COMMON_THREADS_H

#include <stddef.h>

/* As many as the process may run on: its affinity, else the processors that there are; 1 at least.
 */
size_t tp_threads_present(void);

#endif
