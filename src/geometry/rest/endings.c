/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Endings compared by how they end and by their sorted lists of touches. */

#include "rest/endings.h"

#include "common/grow.h"
#include "common/message.h"

#include <stdlib.h>
#include <string.h>

static void clear(tp_ending *ending) {
  tp_touches_clear(&ending->touches);
}

void tp_endings_clear(tp_endings *endings) {
  for (long k = 0; k < endings->count; k++) clear(endings->items + k);
  free(endings->items);
  *endings = (tp_endings){0};
}

static int compare_touches(const void *one, const void *other) {
  const tp_touch *a = one, *b = other;
  if (a->base != b->base) return a->base < b->base ? -1 : 1;
  if (a->block != b->block) return a->block < b->block ? -1 : 1;
  if (a->on_base_edge != b->on_base_edge) return a->on_base_edge ? 1 : -1;
  if (a->on_block_edge != b->on_block_edge) return a->on_block_edge ? 1 : -1;
  return 0;
}

/* To the side on which its weight passes of the point that it goes over. */
static int side_of(const tp_settling *s) {
  return fmpq_cmp(&s->bodies.centroid.x, &s->pivot.x) < 0 ? -1 : 1;
}

/* False when memory is exhausted. */
static bool describe(tp_ending *ending, const tp_settling *s) {
  *ending = (tp_ending){.how = s->how, .side = s->how == TP_SETTLED_ROLLS_OFF ? side_of(s) : 0};
  const long count = s->how == TP_SETTLED_RESTS ? s->touches.count : 0;
  if (count == 0) return true;
  tp_touch *items = malloc((size_t)count * sizeof *items);
  if (items == NULL) return false;
  memcpy(items, s->touches.items, (size_t)count * sizeof *items);
  qsort(items, (size_t)count, sizeof *items, compare_touches);
  ending->touches = (tp_touches){.count = count, .capacity = count, .items = items};
  return true;
}

static bool are_alike(const tp_ending *a, const tp_ending *b) {
  bool alike = a->how == b->how && a->side == b->side && a->touches.count == b->touches.count;
  for (long k = 0; k < a->touches.count && alike; k++) {
    alike = compare_touches(a->touches.items + k, b->touches.items + k) == 0;
  }
  return alike;
}

tp_status tp_endings_note(long *number, tp_endings *endings, const tp_settling *settling,
                          tp_message *message) {
  tp_ending own;
  if (!describe(&own, settling)) return tp_fail_memory(message, "the resting poses");
  for (long k = endings->count - 1; k >= 0; k--) { /* as a rule one of the last */
    if (!are_alike(endings->items + k, &own)) continue;
    clear(&own);
    *number = k;
    return TP_OK;
  }
  tp_ending *room = tp_grow(endings->items, endings->count, &endings->capacity, sizeof *room);
  if (room == NULL) {
    clear(&own);
    return tp_fail_memory(message, "the resting poses");
  }
  endings->items = room;
  endings->items[endings->count] = own;
  *number = endings->count++;
  return TP_OK;
}
