/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A profile whose coordinates lie along the horizontal and the vertical, or anyhow else, turned
 * onto its mean plane. */

#ifndef TP_ROUGHNESS_TURN_H
#define TP_ROUGHNESS_TURN_H

#include "roughness/course.h"

/* As tp_course_from_chain, turned; `turned_deg` is the angle of the mean plane against x. */
TP_MUST_USE tp_status tp_course_turned(tp_course *course, tp_bounded *turned_deg,
                                       const tp_polyline *chain, double scale, tp_message *message);

#endif
