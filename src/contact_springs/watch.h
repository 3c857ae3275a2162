/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Does the block rest, or is it in motion for good? Told by means over windows of a sixteenth of
 * sqrt(extent / g), the time in which a block that is let go moves: vibrations of the springs are
 * far faster, so that they drop out.
 *
 * It collapses where through sixteen windows one after the other the kinetic energy grew and the
 * unbalanced force neither fell nor turned; no displacement counts. It is quiet where the
 * unbalanced force and the kinetic energy are as good as none, next to the weight and the weight
 * times the extent, through four: it rests, where its drive is steady. While the base is shaken
 * neither is told. */

#ifndef TP_SPRING_WATCH_H
#define TP_SPRING_WATCH_H

#include "contact_springs/stepper.h"

typedef struct tp_spring_watch_window {
  long steps;
  double x_n, y_n, moment_nm, kinetic; /* sums over its steps */
} tp_spring_watch_window;

typedef struct tp_spring_watch {
  double weight_n, extent_m, window_s, window_end_s;
  tp_spring_watch_window window;
  tp_body_force last_force; /* means of the window before: over weight and weight x extent */
  double last_kinetic;
  long growing, resting; /* windows in a row */
} tp_spring_watch;

typedef enum tp_spring_watch_news {
  TP_WATCH_NOTHING,
  TP_WATCH_COLLAPSES,
  TP_WATCH_QUIET
} tp_spring_watch_news;

void tp_spring_watch_init(tp_spring_watch *watch, const tp_rigid_body *body, double time_s);

/* After each step; news only at the end of a window. */
tp_spring_watch_news tp_spring_watch_step(tp_spring_watch *watch, const tp_stepper *stepper);

/* How long a collapse has gone on when it is told. */
double tp_spring_watch_delay_s(const tp_spring_watch *watch);

#endif
