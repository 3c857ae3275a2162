/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Results of a body that lies as is given. */

#ifndef TP_SOLID_TILT_SOLVE_SOLID_H
#define TP_SOLID_TILT_SOLVE_SOLID_H

#include "solid_tilt/solid_body.h"
#include "solid_tilt/solid_given.h"

/* Into a solid of zeros, to be freed also on failure: of what lies above where a plane cuts it.
 * Bands that are not given are put into `given`. */
TP_MUST_USE tp_status tp_solid_find(tp_solid *solid, const tp_solid_body *body,
                                    tp_solid_given *given, tp_message *message);

/* A scene's solid; `whole` false: without its poses and roses, for tables of many. */
TP_MUST_USE tp_status tp_solid_solve_scene(tp_solid **solid, const tp_scene *scene, bool whole,
                                           tp_message *message);

#endif
