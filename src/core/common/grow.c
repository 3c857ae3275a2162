/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Doubles the room of an array by realloc when it is full. */

#include "common/grow.h"

#include <stdlib.h>

enum { FIRST_ROOM = 8 };

void *tp_grow(void *items, long count, long *room, size_t size) {
  if (count < *room) return items;
  const long wanted = 2 * *room + FIRST_ROOM;
  void *grown = realloc(items, (size_t)wanted * size);
  if (grown != NULL) *room = wanted;
  return grown;
}
