/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Stress locked in on facets before a path, as its contact counts them. */

#ifndef TP_TILT_TRACTIONS_H
#define TP_TILT_TRACTIONS_H

#include "quasi_static/path.h"
#include "scene/scene.h"

/* By facet and point of the contact of the body, to be freed; NULL where the scene gives none. Bad
 * input where it gives some on a facet that bears none of the block. */
TP_MUST_USE tp_status tp_tilt_tractions_of(tp_path_traction **tractions, const tp_rigid_body *body,
                                           const tp_tilt_test_description *test,
                                           tp_message *message);

#endif
