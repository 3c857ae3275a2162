/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Runs of an engine of dynamics on the table, and what each tells of the block: does it stand? */

#ifndef TP_TILT_TRIAL_H
#define TP_TILT_TRIAL_H

#include "tilt/tilting.h"

/* What a run says. */
typedef enum tp_tilt_verdict {
  TP_VERDICT_STANDS,
  TP_VERDICT_MOVES, /* also where it moved, and rests again elsewhere: cautious */
  TP_VERDICT_OPEN,
  TP_VERDICT_STOPPED
} tp_tilt_verdict;

/* At a tilt in degrees: a fresh start there, or from level at the table's speed and held. Until it
 * begins to move, which `last` is then; `history` may be NULL. */
TP_MUST_USE tp_status tp_tilting_try(tp_tilt_verdict *verdict, tp_body_state *last,
                                     tp_tilting *tilting, double angle_deg, tp_history *history);

/* A run as it is, counted and timed. */
TP_MUST_USE tp_status tp_tilting_run(tp_run_end *end, tp_body_state *last, tp_tilting *tilting,
                                     const tp_run *run);

/* Did options.stop say so? */
bool tp_tilting_stopped(const tp_tilting *tilting);
/* Tell options.progress of the bracket. */
void tp_tilting_tell(const tp_tilting *tilting, double least_deg, double most_deg);

double tp_tilt_radians(double degrees);
double tp_tilt_degrees(double radians);

#endif
