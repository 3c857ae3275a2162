/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What the facets of a profile tell, each straight from a point to the next: lengths, heights,
 * slopes, with their bounds. */

#ifndef TP_ROUGHNESS_SLOPES_H
#define TP_ROUGHNESS_SLOPES_H

#include "roughness/course.h"

typedef struct tp_slopes {
  tp_bounded length, along, amplitude, rms_height, mean_height;
  tp_bounded mean_slope, absolute_slope, z2, effective_angle_deg, rp;
  tp_bounded sf; /* sum of dy^2 dx over the length: a structure function where dx is even */
} tp_slopes;

tp_slopes tp_slopes_measure(const tp_course *course);

/* The facets that face a block which slides to each side, by tp_direction. `along` is of the whole
 * profile. */
void tp_slopes_facing(tp_profile_facing facing[2], const tp_course *course, tp_bounded along);

#endif
