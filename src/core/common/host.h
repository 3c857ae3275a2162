/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The border between the library and the program that calls it.
 *
 * Numbers are read and written with the decimal point of the thread's locale, and every proven
 * bound supposes rounding to nearest, gradual underflow and no traps. A program may have set any of
 * these otherwise, so every public entry that computes or writes begins with TP_GUARD_HOST: the
 * locale and the floating-point environment of the thread, and the range of exponents of MPFR, are
 * put aside, and come back as the entry returns, whichever way. It takes about a microsecond.
 * Threads that an entry starts have the environment of the thread that starts them. */

#ifndef TP_COMMON_HOST_H
#define TP_COMMON_HOST_H

#include "common/message.h"

#include <fenv.h>
#include <locale.h>

typedef struct tp_host {
  fenv_t arithmetic;
  locale_t locale;
  long exponent_least, exponent_most; /* of MPFR */
  unsigned mpfr_flags;
} tp_host;

/* Put aside what the thread has set, and set what the library needs. */
tp_host tp_host_put_aside(void);
void tp_host_bring_back(const tp_host *host);

#define TP_GUARD_HOST                                                                              \
  const tp_host tp_host_of_caller __attribute__((cleanup(tp_host_bring_back), unused)) =           \
      tp_host_put_aside()

/* In a public entry, whose name the message gives: a pointer that must not be NULL. */
#define TP_REFUSE_NULL(message, pointer)                                                           \
  do {                                                                                             \
    if ((pointer) == NULL) {                                                                       \
      return tp_refuse(message, TP_FAULT_ARGUMENT, (tp_place){0}, "%s: '%s' must not be NULL",     \
                       __func__, #pointer);                                                        \
    }                                                                                              \
  } while (false)

#endif
