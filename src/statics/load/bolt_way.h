/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The way of a bolt through the block to the rock behind. */

#ifndef TP_LOAD_BOLT_WAY_H
#define TP_LOAD_BOLT_WAY_H

#include "load/outline.h"
#include "number/ball.h"
#include "scene/scene.h"

/* From a point of the block along a direction to where the block ends, in scene lengths, and the
 * edge of the ring that it ends on; -1 where it runs along its edge out of it. */
long tp_bolt_way(arb_t way, const tp_polyline *ring, const fmpq_t x, const fmpq_t y,
                 const fmpq_t direction_deg, long bits);

/* Refuse an anchor of which a row holds no part of the block; and a bolt that goes out of the block
 * where no rock is, or is not longer than its way there. */
TP_MUST_USE tp_status tp_bolt_check(const tp_scene *scene, const tp_anchor_description *anchor,
                                    const tp_polyline *ring, tp_message *message);

#endif
