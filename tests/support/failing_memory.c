/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#define _GNU_SOURCE
#include "failing_memory.h"

#include <dlfcn.h>
#include <errno.h>
#include <malloc.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* The C library's own, under the names that it keeps for those who replace them. */
extern void *__libc_malloc(size_t size);
extern void *__libc_calloc(size_t count, size_t size);
extern void *__libc_realloc(void *memory, size_t size);
extern void *__libc_memalign(size_t alignment, size_t size);
extern void __libc_free(void *memory);

failing_memory failing_memory_state;

/* The children of a program are not to fail. */
__attribute__((constructor)) static void read_environment(void) {
  const char *at = getenv("TOPPLE_FAIL_AT");
  if (at == NULL) return;
  failing_memory_state.fail_at = strtol(at, NULL, 10);
  unsetenv("TOPPLE_FAIL_AT");
  unsetenv("LD_PRELOAD");
}

/* How many requests there were, for who asks for it. */
__attribute__((destructor)) static void write_count(void) {
  if (getenv("TOPPLE_COUNT_REQUESTS") != NULL) {
    dprintf(STDERR_FILENO, "requests: %ld\n", failing_memory_state.requests);
  }
}

/* operator new is the one in the C++ library that takes memory while Topple runs. */
static bool is_new(const void *caller) {
  Dl_info object;
  return dladdr(caller, &object) != 0 && strstr(object.dli_fname, "libstdc++") != NULL;
}

static bool refused(const void *caller) {
  failing_memory *s = &failing_memory_state;
  if (s->spared || ++s->requests < s->fail_at || s->fail_at == 0) return false;
  if (s->requests > s->fail_at && !s->lasting) return false;
  s->was_new = s->was_new || is_new(caller);
  errno = ENOMEM;
  return true;
}

static void *counted(void *memory) {
  failing_memory_state.live += memory != NULL;
  return memory;
}

void *malloc(size_t size) {
  return refused(__builtin_return_address(0)) ? NULL : counted(__libc_malloc(size));
}

void *calloc(size_t count, size_t size) {
  return refused(__builtin_return_address(0)) ? NULL : counted(__libc_calloc(count, size));
}

void *realloc(void *memory, size_t size) {
  if (refused(__builtin_return_address(0))) return NULL;
  void *own = __libc_realloc(memory, size);
  if (memory == NULL) return counted(own);
  failing_memory_state.live -= size == 0 && own == NULL;
  return own;
}

void *memalign(size_t alignment, size_t size) {
  return refused(__builtin_return_address(0)) ? NULL : counted(__libc_memalign(alignment, size));
}

void *aligned_alloc(size_t alignment, size_t size) {
  return memalign(alignment, size);
}

int posix_memalign(void **memory, size_t alignment, size_t size) {
  void *own = memalign(alignment, size);
  if (own == NULL) return ENOMEM;
  *memory = own;
  return 0;
}

void free(void *memory) {
  failing_memory_state.live -= memory != NULL;
  __libc_free(memory);
}
