/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A test by the quasi-static path (quasi_static/path.h). */

#ifndef TP_TILT_PATH_H
#define TP_TILT_PATH_H

#include "tilt/trial.h"

/* A ramp from level; or the least tilt at which the block, set down there, finds no equilibrium,
 * with the path of the highest at which it does. */
TP_MUST_USE tp_status tp_tilting_path(tp_tilting *tilting, double least_deg, double most_deg);

#endif
