/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The tilts at which some mode can begin: all spans of all modes, sorted by their lower ends and
 * put together where they meet. Ends whose order stays open are one ball that holds both, and a gap
 * that may be none counts as none: a block is never said to stand in it. */

#ifndef TP_MOTION_WINDOWS_H
#define TP_MOTION_WINDOWS_H

#include "motion/motion.h"

typedef struct tp_motion_window {
  tp_tilt from, to;
  long begins;  /* the span that begins at its lower end; without one, ends at its upper */
  bool has_ray; /* what begins there is the motion of one ray: */
  long ray;
  tp_mechanism mechanism;
  bool tie; /* another one begins there too: */
  tp_mechanism tied_with;
  bool tie_exact; /* at one tilt by construction; else their balls are not told apart */
} tp_motion_window;

typedef struct tp_motion_windows {
  long count;
  tp_motion_window *items; /* from below */
} tp_motion_windows;

TP_MUST_USE tp_motion_outcome tp_windows_init(tp_motion_windows *windows, const tp_motions *motions,
                                              const tp_judge *judge);
void tp_windows_clear(tp_motion_windows *windows);

/* Does the window, or the span, its ends included, hold the tilt in degrees? */
tp_answer tp_window_holds(const tp_motion_window *window, const arb_t degrees);
tp_answer tp_tilt_span_holds(const tp_tilt_span *span, const arb_t degrees);

#endif
