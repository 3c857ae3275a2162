/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Bolts and anchors of a scene: what follows from their dip, spacing and rows. */

#ifndef TP_SCENE_ANCHOR_H
#define TP_SCENE_ANCHOR_H

#include "scene/scene.h"

/* Of its pull, from x towards y in the scene's own frame. */
void tp_anchor_direction(fmpq_t degrees, const tp_scene *scene,
                         const tp_anchor_description *anchor);

/* In the world's frame a bolt goes up-dip unless its side is said, which its mean plane tells: that
 * is not known yet. */
bool tp_anchor_waits(const tp_scene *scene, const tp_anchor_description *anchor);
/* It is known now: what rises to the right is 1, to the left -1. Bolts that wait on a level plane
 * are refused, unless the scene tilts to one side alone. */
TP_MUST_USE tp_status tp_anchors_take_side(tp_scene *turned, const tp_scene *scene, int rises,
                                           tp_message *message);
/* Has a moved scene found its side so? */
bool tp_anchor_took_side(const tp_scene *scene, const tp_anchor_description *anchor);

long tp_anchor_rows(const tp_anchor_description *anchor);

/* Where the bolt of a row holds, counted from 0. */
void tp_anchor_point(fmpq_t x, fmpq_t y, const tp_anchor_description *anchor, long row);

/* Of one bolt, in kN: the force given, or the capacity of a passive one. */
const tp_quantity *tp_anchor_bolt_force(const tp_anchor_description *anchor);

/* Of a row on the whole thickness, in kN. */
void tp_anchor_row_force(fmpq_t kn, const tp_scene *scene, const tp_anchor_description *anchor);

/* A bolt has more than a direction and a force. */
bool tp_anchor_is_bolt(const tp_anchor_description *anchor);

/* Refuse bolts, and forces on many blocks, of which direction, side or force do not follow, and
 * forces above a capacity. */
TP_MUST_USE tp_status tp_anchors_check(const tp_scene *scene, tp_message *message);

#endif
