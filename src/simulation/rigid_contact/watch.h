/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What can end a smooth motion: numbers that are positive as long as it goes on. Along a step they
 * are looked at eight times, by the polynomial of fifth degree through both ends, and where a gap
 * narrows and widens between two of these, at its least (rigid_contact/along.h); the first that has
 * changed its sign is then found to the last digits of the time, by steps from the same begin. Of
 * gaps, those alone are looked at that can close before the block has moved as far as it does. */

#ifndef TP_RIGID_CONTACT_WATCH_H
#define TP_RIGID_CONTACT_WATCH_H

#include "rigid_contact/smooth.h"

typedef enum tp_watched {
  TP_WATCH_NOTHING,  /* the step was smooth */
  TP_WATCH_GAP,      /* closes; with the number of its pair */
  TP_WATCH_FORCE,    /* an edge of a cone pulls; with the number of the contact that presses */
  TP_WATCH_SLIP,     /* turns back */
  TP_WATCH_MARGIN,   /* a contact comes to the end of a face */
  TP_WATCH_ARC,      /* or of an arc */
  TP_WATCH_OVERTURN, /* a quarter of a turn */
  TP_WATCH_LEAVE,    /* no part of the block is above the base any more */
  TP_WATCH_FAILED    /* the step cannot be made as short as it would have to be */
} tp_watched;

/* A step to do. */
typedef struct tp_watch {
  tp_contact_system *system;
  tp_smooth *smooth;
  double time, step;
  double numbers[TP_MOTION_NUMBERS];
  double tolerance;
  double overturn; /* the turn at which the block counts as overturned, or -INFINITY: it has been */
} tp_watch;

typedef struct tp_watch_end {
  tp_watched what;
  long number;
  double time;
  double numbers[TP_MOTION_NUMBERS];
  int columns; /* of its extrapolation */
  double step; /* that it did, or would have done */
} tp_watch_end;

/* The step, shorter where the tolerance asks for it, up to the first event. */
tp_watch_end tp_watch_step(const tp_watch *watch);

#endif
