/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What a contact can do as a motion begins, and sets of that.
 *
 * Each end is open (it parts, u_n > 0) or closed (u_n = 0); where one is closed, the contact sticks
 * (u_t = 0) or slips forward or back, as one. So there are ten modes of an edge and four of a
 * corner, whose one end is the first. */

#ifndef TP_CONTACT_MODES_MODE_SET_H
#define TP_CONTACT_MODES_MODE_SET_H

#include <stdbool.h>

typedef enum tp_mode_slip { TP_MODE_STICKS, TP_MODE_FORWARD, TP_MODE_BACK } tp_mode_slip;

/* A bit a mode: 0 of both ends open, then by the ends that are closed, of each by the slip. */
typedef unsigned tp_mode_set;

enum {
  TP_MODES_OPEN = 1,       /* all open */
  TP_MODES_OF_CORNER = 15, /* all */
  TP_MODES_OF_EDGE = 1023, /* all */
  TP_MODES_STICK = 2 + 16 + 128,
  TP_MODES_FORWARD = 4 + 32 + 256,
  TP_MODES_BACK = 8 + 64 + 512,
  TP_MODES_FIRST_CLOSED = 2 + 4 + 8 + 128 + 256 + 512,
  TP_MODES_SECOND_CLOSED = 16 + 32 + 64 + 128 + 256 + 512
};

static inline tp_mode_set tp_modes_all(int ends) {
  return ends == 1 ? TP_MODES_OF_CORNER : TP_MODES_OF_EDGE;
}

/* The one mode in which no relative motion is left at the ends. */
static inline tp_mode_set tp_modes_at_rest(int ends) {
  return ends == 1 ? 2 : 128;
}

static inline tp_mode_set tp_modes_closed(int end) {
  return end == 0 ? TP_MODES_FIRST_CLOSED : TP_MODES_SECOND_CLOSED;
}

/* With these ends closed, at least one, and this slip. */
static inline tp_mode_set tp_mode_of(bool first, bool second, tp_mode_slip slip) {
  const int closed = (first ? 1 : 0) + (second ? 2 : 0);
  return 1u << (1 + 3 * (closed - 1) + (int)slip);
}

static inline bool tp_modes_is_one(tp_mode_set set) {
  return set != 0 && (set & (set - 1)) == 0;
}

#endif
