/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Shifts of a block at which its first contact, or its first turn, may become another: a vertex of
 * its outline, or its centroid, lies upright over a point of the profile. They are rational. */

#ifndef TP_REST_EVENTS_H
#define TP_REST_EVENTS_H

#include "rest/bodies.h"

/* The one nearest to the middle of those in the open interval; false: there is none. */
bool tp_event_within(fmpq_t event, const tp_bodies *bodies, const fmpq_t low, const fmpq_t high);

#endif
