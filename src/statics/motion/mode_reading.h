/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The modes of a question at one tilt in doubles with bounds, as functions of the share of their
 * strength (motion/mode_shares.h). Moments over a length of the question, by powers of two, which
 * round nothing. */

#ifndef TP_MOTION_MODE_READING_H
#define TP_MOTION_MODE_READING_H

#include "motion/mode_shares.h"
#include "motion/motion.h"
#include "motion/strength.h"

/* Of motions at the strength as given, with all modes kept. */
typedef struct tp_mode_reading {
  const tp_motion_question *question;
  const tp_motions *motions;
  tp_vector loads;
  slong length; /* 2^length: about a length of the question */
  tp_ball_line line;
  bool keeps_balls; /* of the mode read last */
  tp_ball_line balls[TP_SHARE_LINES + TP_SHARE_FREE + 2];
  tp_share_line *planes; /* of the interior; NULL: not read yet */
  tp_strength strength;
  tp_motion_outcome outcome; /* of what cohesion and bonds do */
} tp_mode_reading;

void tp_mode_reading_init(tp_mode_reading *reading, const tp_motion_question *question,
                          const tp_motions *motions, const arb_t degrees);
void tp_mode_reading_clear(tp_mode_reading *reading);

/* A mode at the tilt; false where there is no room for it, or no memory. */
TP_MUST_USE bool tp_mode_read(tp_share_mode *to, tp_mode_reading *reading,
                              const tp_motion_mode *mode);

#endif
