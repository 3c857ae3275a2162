/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Does the block rest, or is it in motion for good? Told by means over windows of a sixteenth of
 * sqrt(extent / g), the time in which a block that is released moves: vibrations of the springs are
 * far faster, so that they drop out.
 *
 * It collapses where through sixteen windows one after the other the kinetic energy grew and the
 * unbalanced force neither fell nor turned; or where in three times sixteen windows it moved on in
 * one direction by no less each time, as a block does that slides under strong damping, and by more
 * than springs give as the table tilts. No displacement alone counts. It is quiet where the
 * unbalanced force and the kinetic energy are as good as none, next to the weight and the weight
 * times the extent, through four windows: it rests, where its drive is steady. While the base is
 * shaken neither is told. */

#ifndef TP_CONTACT_SPRINGS_WATCH_H
#define TP_CONTACT_SPRINGS_WATCH_H

#include "contact_springs/stepper.h"

typedef struct tp_spring_watch_window {
  long steps;
  double x_n, y_n, moment_nm, kinetic; /* sums over its steps */
} tp_spring_watch_window;

/* A displacement of the block: its turn times the extent, m. */
typedef struct tp_drift {
  double x, y, turned;
} tp_drift;

enum { TP_WATCH_DECADES = 24 };

typedef struct tp_spring_watch {
  double weight_n, extent_m, window_s, window_end_s;
  tp_spring_watch_window window;
  tp_body_force last_force; /* means of the window before: over weight and weight x extent */
  double last_kinetic;
  long growing, resting;  /* windows in a row */
  long windows, drifting; /* all windows; sixteens of them in which it moved on */
  tp_drift from, last_drift;
  double slower_until_s[TP_WATCH_DECADES]; /* the kinetic energy was below 10^-k until then */
  double give_m;                           /* how far springs give under the weight, about */
  double begun_s;                          /* when what is told began */
} tp_spring_watch;

typedef enum tp_spring_watch_news {
  TP_WATCH_NOTHING,
  TP_WATCH_COLLAPSES,
  TP_WATCH_QUIET
} tp_spring_watch_news;

void tp_spring_watch_init(tp_spring_watch *watch, const tp_stepper *stepper);

/* After each step; news only at the end of a window. */
tp_spring_watch_news tp_spring_watch_step(tp_spring_watch *watch, const tp_stepper *stepper);

#endif
