/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Arrays that grow by doubling, so that n items cost some 2 n copies in all. */

#ifndef TP_COMMON_GROW_H
#define TP_COMMON_GROW_H

#include <stddef.h>

/* The array with room for one item more than `count`: itself, or where it is full a larger one that
 * has taken its place, `*room` items of `size` bytes. NULL when memory is exhausted: then the array
 * is as it was. */
void *tp_grow(void *items, long count, long *room, size_t size);

#endif
