/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The least tilt, or horizontal acceleration, of all azimuths up to which a solid is held on its
 * contacts (on_contacts.h). */

#ifndef TP_SOLID_TILT_LEAST_WAY_H
#define TP_SOLID_TILT_LEAST_WAY_H

#include "solid_contacts/hold.h"
#include "solid_tilt/hold_frame.h"

/* A load, and unit ones towards the azimuths. */
typedef struct tp_level_loads {
  const tp_scene *tilted; /* NULL: level; else at the tilt of this scene */
  tp_hold_load load, east, north;
} tp_level_loads;

/* Level, its weight and ways along the base: t is the tangent of a tilt. Tilted, its weight without
 * what the scene's earthquake lifts, and ways along the horizon: t is an acceleration in g. */
void tp_level_loads_init(tp_level_loads *loads, const tp_hold_frame *frame, const tp_scene *tilted);
void tp_level_loads_clear(tp_level_loads *loads);

/* Up to which t towards an azimuth; false when memory is exhausted. */
TP_MUST_USE bool tp_level_limit(tp_hold_limit *limit, tp_hold *hold, const tp_level_loads *loads,
                                const tp_hold_frame *frame, double azimuth_deg);

typedef struct tp_least_way {
  bool is_known;      /* every azimuth that was tried was told */
  bool is_endless;    /* held at any t towards all of them */
  tp_near t;          /* the least */
  double azimuth_deg; /* towards which it was found, to `azimuth_error` */
  double azimuth_error;
  double twist[TP_WRENCH]; /* the motion that begins there */
} tp_least_way;

TP_MUST_USE bool tp_least_way_find(tp_least_way *least, tp_hold *hold, const tp_level_loads *loads,
                                   const tp_hold_frame *frame);

#endif
