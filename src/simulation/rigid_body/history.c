/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Three growing arrays of events, moments and reactions. */

#include "rigid_body/history.h"

#include "common/grow.h"

#include <stdlib.h>
#include <string.h>

void tp_history_clear(tp_history *history) {
  free(history->events);
  free(history->moments);
  free(history->reactions);
  memset(history, 0, sizeof *history);
}

/* Room for one more; false when memory is exhausted. */
static bool make_room(void **items, size_t count, size_t *room, size_t size) {
  long own_room = (long)*room;
  void *more = tp_grow(*items, (long)count, &own_room, size);
  if (more == NULL) return false;
  *items = more;
  *room = (size_t)own_room;
  return true;
}

bool tp_history_event(tp_history *h, tp_tilt_event event) {
  void *items = h->events;
  if (!make_room(&items, h->event_count, &h->event_room, sizeof event)) return false;
  h->events = items;
  h->events[h->event_count++] = event;
  return true;
}

bool tp_history_moment(tp_history *h, tp_tilt_moment moment) {
  void *items = h->moments;
  if (!make_room(&items, h->moment_count, &h->moment_room, sizeof moment)) return false;
  h->moments = items;
  h->moments[h->moment_count++] = moment;
  return true;
}

bool tp_history_reaction(tp_history *h, long facet, double normal_n, double shear_n) {
  const tp_tilt_reaction reaction = {
      .moment = h->moment_count - 1, .facet = facet, .normal_n = normal_n, .shear_n = shear_n};
  void *items = h->reactions;
  if (!make_room(&items, h->reaction_count, &h->reaction_room, sizeof reaction)) return false;
  h->reactions = items;
  h->reactions[h->reaction_count++] = reaction;
  return true;
}

void tp_turn_range_take(tp_turn_range *range, double turned, double time_s) {
  if (range == NULL) return;
  if (turned > range->most) {
    range->most = turned;
    range->most_s = time_s;
  }
  if (turned < range->least) {
    range->least = turned;
    range->least_s = time_s;
  }
}
