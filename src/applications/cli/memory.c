/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Memory for FLINT and GMP, which end the process by an abort where there is none. The library's
 * own requests fail with a status; within FLINT and GMP, which know of none, the program ends here:
 * with a message, and with nothing half-written, as reports and files are written when all that
 * belongs to them is computed. */

#include "cli/cli.h"

#include <flint/flint.h>
#include <gmp.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#if __has_include(<malloc.h>)
#include <malloc.h>
#endif

/* Without stdio, which takes memory. */
_Noreturn static void end(const char *complaint) {
  const ssize_t written = write(STDERR_FILENO, complaint, strlen(complaint));
  _exit(written < 0 ? TP_EXIT_SYSTEM : tp_status_exit(TP_OUT_OF_MEMORY));
}

static void *given(void *memory) {
  if (memory == NULL) {
    end("topple: out of memory while computing; a scene with fewer vertices or fewer digits "
        "need less\n");
  }
  return memory;
}

/* No bytes are a pointer to none for some allocators. */
static size_t some(size_t size) {
  return size > 0 ? size : 1;
}

static void *take(size_t size) {
  return given(malloc(some(size)));
}

static void *take_zeros(size_t count, size_t size) {
  return given(calloc(some(count), some(size)));
}

static void *resize(void *memory, size_t size) {
  return given(realloc(memory, some(size)));
}

static void *resize_known(void *memory, size_t size_before, size_t size) {
  (void)size_before;
  return resize(memory, size);
}

static void give_back(void *memory, size_t size) {
  (void)size;
  free(memory);
}

/* The attribute is part of the type that FLINT takes; for clang _Noreturn is none. */
__attribute__((noreturn)) static void give_up(void) {
  end("topple: FLINT, a library that Topple uses, aborted; please report the scene\n");
}

/* A large base has arrays that come and go a dozen times, each of a size that glibc would have anew
 * from the system and clear page by page: they come from one heap, which keeps what is freed. */
static void keep_freed_memory(void) {
#ifdef M_MMAP_THRESHOLD
  (void)mallopt(M_MMAP_THRESHOLD, 1 << 30);
  (void)mallopt(M_TRIM_THRESHOLD, INT_MAX);
#endif
}

void tp_cli_guard_memory(void) {
  keep_freed_memory();
  __flint_set_memory_functions(take, take_zeros, resize, free);
  flint_set_abort(give_up);
  mp_set_memory_functions(take, resize_known, give_back);
}
