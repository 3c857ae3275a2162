/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Test for a mode that is a pure slide: one ray, along the axis of a contact line. */

#include "motion/mode.h"

bool tp_mode_slides(const tp_mode *mode, const tp_twists *twists) {
  return mode->ray_count == 1 && twists->rays[mode->rays[0]].axis >= 0;
}
