/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The least tilt of all azimuths up to which a solid is held on its contacts (on_contacts.h). */

#ifndef TP_SOLID_TILT_LEAST_WAY_H
#define TP_SOLID_TILT_LEAST_WAY_H

#include "solid_contacts/hold.h"
#include "solid_tilt/hold_frame.h"

/* Loads as the solid lies. */
typedef struct tp_level_loads {
  tp_hold_load down, east, north;
} tp_level_loads;

void tp_level_loads_init(tp_level_loads *loads, const tp_hold_frame *frame);
void tp_level_loads_clear(tp_level_loads *loads);

/* Up to which t towards an azimuth. False when memory is exhausted. */
TP_MUST_USE bool tp_level_limit(tp_hold_limit *limit, tp_hold *hold, const tp_level_loads *loads,
                                const tp_hold_frame *frame, double azimuth_deg);

typedef struct tp_least_way {
  bool is_known;      /* every azimuth that was tried was told */
  bool is_endless;    /* held at any tilt towards all of them */
  tp_near t;          /* the tangent of the least tilt */
  double azimuth_deg; /* towards which it was found, to `azimuth_error` */
  double azimuth_error;
  double twist[TP_WRENCH]; /* the motion that begins there */
} tp_least_way;

TP_MUST_USE bool tp_least_way_find(tp_least_way *least, tp_hold *hold, const tp_level_loads *loads,
                                   const tp_hold_frame *frame);

#endif
