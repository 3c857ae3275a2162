/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The turn of a shaken block against time, as a strip below its frames: its curve, the balance
 * angle dashed, its peak marked. Geometry and words for all drawings of it; y grows downwards. */

#ifndef TP_REPORT_TILT_TURN_H
#define TP_REPORT_TILT_TURN_H

#include "report/tilt_svg.h"

typedef struct tp_turn_strip {
  const tp_tilt_case *own;
  double width, height; /* 0: the block does not rock, and there is no strip */
  double end_s, most_deg;
} tp_turn_strip;

tp_turn_strip tp_turn_strip_of(const tp_tilt_view *view);

double tp_turn_strip_x(const tp_turn_strip *strip, double time_s);
double tp_turn_strip_y(const tp_turn_strip *strip, double turned_deg);

/* The balance angle to the side of the peak, as the turn has its sign; false: none is known. */
bool tp_turn_strip_balance(double *turned_deg, const tp_turn_strip *strip);

void tp_turn_strip_words(tp_text *text, const tp_turn_strip *strip, const tp_language *language,
                         bool comma);

/* As SVG, `top` below the top of the drawing. */
void tp_turn_strip_svg(tp_text *text, const tp_turn_strip *strip, double top,
                       const tp_language *language, bool comma);

#endif
