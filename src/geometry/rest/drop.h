/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A block set down from above, upright along gravity, to where it first touches its base.
 *
 * The height to fall is the least of the heights of the block's vertices over the edges of the
 * profile, and of the edges on its underside over the vertices of the profile: exact, a minimum of
 * rational numbers. */

#ifndef TP_REST_DROP_H
#define TP_REST_DROP_H

#include "rest/candidates.h"
#include "rest/touch.h"

/* Shift the block in its pose onto the base. `height` is what it fell; below zero it was lifted.
 * `beside`: nothing of it stands over the profile, and nothing was done. `pairs`: empty, and the
 * caller's to clear; where they are more than is allowed, which they tell, the status is to be
 * passed over. */
TP_MUST_USE tp_status tp_drop(fmpq_t height, bool *beside, tp_candidates *pairs, tp_bodies *bodies,
                              tp_touches *touches, tp_message *message);

#endif
