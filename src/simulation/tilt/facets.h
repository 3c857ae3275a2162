/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The facets of the base that a test names, with where they lie: events and reactions count the
 * facets of the base, as a block may come down on any of them; statics counts those of the contact.
 * Both numbers stand side by side. */

#ifndef TP_TILT_FACETS_H
#define TP_TILT_FACETS_H

#include "rigid_body/body.h"
#include "topple_tilt_test.h"

/* Those on which the block rests at the start, and those of the case's events and reactions, by
 * their numbers; false when memory is exhausted. */
TP_MUST_USE bool tp_tilt_facets_fill(tp_tilt_case *own, const tp_rigid_body *body,
                                     const tp_problem *problem);

#endif
