/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* How a mesh was thinned, in a solid and as notes on it. A support is the hull of vertices within a
 * band, of which some are left: it lies within that of the mesh, and the centroid is that of the
 * mesh, so that no tilt is told greater than it is. */

#ifndef TP_SOLID_TILT_THINNED_H
#define TP_SOLID_TILT_THINNED_H

#include "solid_tilt/solid_body.h"
#include "solid_tilt/solid_given.h"

/* Of a body with the unit and the bands given. */
TP_MUST_USE tp_status tp_thinning_tell(tp_solid *solid, const tp_solid_body *body,
                                       const tp_solid_given *given, tp_message *message);

#endif
