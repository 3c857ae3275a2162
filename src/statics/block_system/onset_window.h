/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Where a motion can begin as the blocks are: down to which number x it can, and just below that
 * none. */

#ifndef TP_BLOCK_SYSTEM_ONSET_WINDOW_H
#define TP_BLOCK_SYSTEM_ONSET_WINDOW_H

#include "block_system/moving.h"
#include "block_system/standing.h"

typedef struct tp_onset_window {
  double from, least, width; /* motions are looked for from where the blocks are, or from where no
                                forces hold them on, down to `least` */
  bool collapses;            /* no forces hold the blocks at any x from there to where they are */
  bool is_few;     /* of few blocks: also between both whether there are x at which none begins */
  bool reaches;    /* a motion can begin at `least` too */
  bool has_stands; /* none can at: */
  double stands, moves; /* the lower end of the window lies between them */
} tp_onset_window;

/* The motion of the search is one that can begin at `from`, or was proven along another number; it
 * is followed to `moves`. Of blocks that collapse one is looked for just beyond `from`. */
TP_MUST_USE tp_status tp_onset_window_find(tp_onset_window *window, tp_moving_search *moving,
                                           tp_standing_search *standing, tp_message *message);

#endif
