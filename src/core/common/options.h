/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Options of a program that may be compiled with an older library, in which their struct ends
 * sooner. Every struct of options begins with its size as its caller knows it; it grows at its end,
 * and the fields that a caller does not have are at their defaults. */

#ifndef TP_COMMON_OPTIONS_H
#define TP_COMMON_OPTIONS_H

#include "common/message.h"

/* Beside the defaults of a struct of options: it ends with its last field. In padding behind it an
 * older program leaves what it likes, and a field that were added there would read that. Where a
 * pointer has 32 bits it may: there the library is built into its program. */
#define TP_OPTIONS_END(type, last)                                                                 \
  _Static_assert(offsetof(type, last) + sizeof(((type *)NULL)->last) == sizeof(type) ||            \
                     sizeof(void *) < 8,                                                           \
                 #type " ends in padding")

/* The first `size` bytes of `defaults`, which know their size; what the caller has beyond is zero,
 * and `size` itself comes first, so that the calls can refuse it. */
void tp_options_fill(void *options, size_t size, const void *defaults);

/* `own` holds the defaults: put what is given over them. Bad input where the size that is given is
 * none, or more than the library knows; it names the entry. */
tp_status tp_options_take(void *own, const void *given, const char *entry, tp_message *message);

/* In a public entry, of its parameter `options`: from here on it is `own`, whole. */
#define TP_TAKE_OPTIONS(message, own, options)                                                     \
  do {                                                                                             \
    const tp_status tp_taken = tp_options_take(&(own), options, __func__, message);                \
    if (tp_taken != TP_OK) return tp_taken;                                                        \
    (options) = &(own);                                                                            \
  } while (false)

#endif
