/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The direction in which weights and earthquake act together on blocks as they lie, seen from one
 * direction of tilt: as if all were tilted to that side by atan(k_h / (1 - k_v)) more (section 10
 * of docs/mechanics.md). A part of the earthquake upwards counts where it is worse: k_v > 0. */

#ifndef TP_BLOCK_SYSTEM_RESULTANT_H
#define TP_BLOCK_SYSTEM_RESULTANT_H

#include "number/ball.h"
#include "scene/scene.h"

typedef struct tp_resultant {
  arb_t tilt_deg;       /* of the scene, to the side; below 0: it lies the other way */
  arb_t earthquake_deg; /* that the earthquake adds */
  bool beyond;          /* it is not certainly within 90 degrees of the normal: */
  tp_near tangent;      /* if not beyond: of the angle in all, to the side */
  double along_normal;  /* what the normal part is to the weight, rounded */
} tp_resultant;

/* Refused: an earthquake that lifts all weight. */
TP_MUST_USE tp_status tp_resultant_init(tp_resultant *resultant, const tp_scene *scene,
                                        bool towards_left, tp_message *message);
void tp_resultant_clear(tp_resultant *resultant);

/* The tilt at which the resultant has a tangent between two bounds. */
tp_bounded tp_resultant_tilt_deg(const tp_resultant *resultant, double low, double high);

/* And the horizontal acceleration, in g, that brings it there at the scene's tilt: tan of what is
 * left of the angle. False where that is 90 degrees or more. */
bool tp_resultant_acceleration(tp_bounded *acceleration, const tp_resultant *resultant, double low,
                               double high);

#endif
