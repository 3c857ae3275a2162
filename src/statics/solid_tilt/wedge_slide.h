/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The factor of safety of a wedge against sliding (Hoek and Bray, Rock Slope Engineering, 3rd ed.
 * 1981), in balls: by wedge_law.h, with R the weight, less k_v of it, with k_h of it towards the
 * azimuth of an earthquake, or the worst of all where the scene gives none, and the water's
 * pressure p times areas. Where an earthquake pulls it up the line of both joints strength acts
 * against that. The least factor, and the least horizontal acceleration at which the factor is 1,
 * of all azimuths, by wedge_circle.h. */

#ifndef TP_SOLID_TILT_WEDGE_SLIDE_H
#define TP_SOLID_TILT_WEDGE_SLIDE_H

#include "solid_tilt/wedge_shape.h"
#include "topple.h"

/* With so many azimuths of its own. Fails when memory is exhausted; to be cleared also then. */
TP_MUST_USE tp_status tp_wedge_slide(tp_solid_wedge *result, const tp_wedge_shape *shape,
                                     const tp_scene *scene, size_t azimuths, tp_message *message);
void tp_solid_wedge_clear(tp_solid_wedge *wedge);

#endif
