/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Calls of the library that are tried while memory runs out: each succeeds, or says that it did. */

#ifndef TP_TEST_MEMORY_CALLS_H
#define TP_TEST_MEMORY_CALLS_H

typedef struct memory_call {
  const char *name;
  void (*run)(void);
  long points; /* requests that fail in turn under ./check --long */
} memory_call;

extern const memory_call memory_calls[];
extern const int memory_call_count;

#endif
