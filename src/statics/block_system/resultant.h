/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Weights and earthquake on blocks as they lie, seen from one direction of tilt (section 10 of
 * docs/mechanics.md).
 *
 * With weights alone and no cohesion a common factor on all changes nothing: weights act along the
 * normal and, times s, along the base, and the resultant has s = tan(tilt + atan(k_h / (1 - k_v))).
 * Else weights act as they do at the tilt, and s is the coefficient of an earthquake. Its vertical
 * part counts where it is to act (block_system/vertical_part.h). */

#ifndef TP_BLOCK_SYSTEM_RESULTANT_H
#define TP_BLOCK_SYSTEM_RESULTANT_H

#include "assemblage/force_program.h"
#include "load/lie.h"
#include "number/ball.h"
#include "scene/scene.h"

typedef struct tp_resultant {
  arb_t tilt_deg;                 /* of the scene, to the side; below 0: it lies the other way */
  arb_t earthquake_deg;           /* that the earthquake adds */
  arb_t along, across;            /* 1 - k_v and k_h */
  bool left;                      /* the side */
  bool beyond;                    /* it is not certainly within 90 degrees of the normal: */
  tp_weight_loads loads;          /* if not beyond: at the scene's tilt */
  tp_near target;                 /* and the load that is there, by s */
  const tp_applied_load *applied; /* borrowed */
  double along_normal;            /* what a load of one in `loads` is to the weight, rounded */
} tp_resultant;

/* Has the scene a case that goes to a side? On a slope up-dip too where an earthquake may act that
 * way. */
bool tp_scene_asks_side(const tp_scene *scene, bool left);

/* Are loads to that side needed? Down-dip of a slope also where an earthquake up-dip alone is asked
 * for: without the earthquake the blocks are driven there. */
bool tp_scene_needs_side(const tp_scene *scene, bool left);

/* How far the scene is tilted to a side; below 0 to the other one. */
void tp_scene_side_tilt(fmpq_t degrees, const tp_scene *scene, bool towards_left);

/* How its axes lie then. */
void tp_scene_lie(tp_lie *lie, const tp_scene *scene, bool towards_left);

typedef struct tp_resultant_case {
  bool towards_left;
  bool is_measured; /* weights are held against strength or loads that are given in forces */
  bool vertical_acts;
  bool is_static; /* without the scene's earthquake */
} tp_resultant_case;

/* `applied`, borrowed, are loads that are given in forces, or NULL. Refused: an earthquake that
 * lifts all weight. */
TP_MUST_USE tp_status tp_resultant_init(tp_resultant *resultant, const tp_scene *scene,
                                        const tp_resultant_case *of, const tp_applied_load *applied,
                                        tp_message *message);
void tp_resultant_clear(tp_resultant *resultant);

/* The load that is there as nothing shakes, by s; where it is measured, with the vertical part of
 * the earthquake. Not where the tilt is 90 degrees or more. */
tp_near tp_resultant_at_rest(const tp_resultant *resultant, bool is_measured);

/* The loads at another tilt, in radians, where they are measured. */
tp_weight_loads tp_resultant_at(const tp_resultant *resultant, double tilt);

/* The tilt, in degrees, at which the resultant has a tangent between two bounds. */
tp_bounded tp_resultant_tilt_deg(const tp_resultant *resultant, double low, double high);

/* And the horizontal acceleration, in g, that brings it there at the scene's tilt: tan of what is
 * left of the angle, times 1 - k_v. False where that is 90 degrees or more. */
bool tp_resultant_acceleration(tp_bounded *acceleration, const tp_resultant *resultant, double low,
                               double high);

/* Likewise the one that turns the resultant as another tilt does. */
bool tp_resultant_acceleration_of(tp_bounded *acceleration, const tp_resultant *resultant,
                                  double tilt_deg);

#endif
