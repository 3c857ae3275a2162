/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Directions of a tilted solid in the axes of its mesh, as rational numbers to 2^-100: the unit
 * vectors u upwards, e east and n north as it lies (solid/azimuth.h has their formulas), and of a
 * tilt by d towards t = e sin a + n cos a
 *     down = -u cos d + t sin d,
 * a share k_h of the weight horizontally towards the azimuth q, with c = cos(q - a), w = sin(q - a)
 * and s = e cos a - n sin a, the strike,
 *     k_h (c (t cos d + u sin d) + w s). */

#ifndef TP_SOLID_TILT_HOLD_FRAME_H
#define TP_SOLID_TILT_HOLD_FRAME_H

#include "scene/scene.h"
#include "solid_contacts/hold_proof.h"

#include <arb.h>

typedef struct tp_hold_frame {
  arb_struct axes[3][3]; /* east, north, up */
} tp_hold_frame;

/* `up` is not zero, of any length. */
void tp_hold_frame_init(tp_hold_frame *frame, const fmpz up[3]);
void tp_hold_frame_clear(tp_hold_frame *frame);

/* An axis: 0 east, 1 north, 2 up; times -1 where `down`. */
void tp_hold_frame_axis(tp_hold_load *load, const tp_hold_frame *frame, int axis, bool down);

/* Of the weight, one, at the tilt of a scene what rests on the base: its part across it. */
void tp_hold_frame_rest(tp_hold_load *load, const tp_hold_frame *frame, const tp_scene *scene);

/* Along the base as it lies, towards an azimuth. */
void tp_hold_frame_way(tp_hold_load *load, const tp_hold_frame *frame, const fmpq_t azimuth);

/* The weight, one, and the earthquake of a scene at its tilt. */
void tp_hold_frame_scene(tp_hold_load *load, const tp_hold_frame *frame, const tp_scene *scene);

/* At that tilt the weight alone, less what the earthquake lifts of it. */
void tp_hold_frame_weight(tp_hold_load *load, const tp_hold_frame *frame, const tp_scene *scene);

/* What drives it at that tilt: the load less what rests, with the earthquake or without. */
void tp_hold_frame_drive(tp_hold_load *load, const tp_hold_frame *frame, const tp_scene *scene,
                         bool shaken);

/* At that tilt, one along the horizon towards an azimuth. */
void tp_hold_frame_shake(tp_hold_load *load, const tp_hold_frame *frame, const tp_scene *scene,
                         const fmpq_t azimuth);

#endif
