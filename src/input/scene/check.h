/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What a scene may hold, so far as it can be said without geometry: one place for the reader of
 * files and for the calls that build a scene in memory. Every check says where and what to do. */

#ifndef TP_SCENE_CHECK_H
#define TP_SCENE_CHECK_H

#include "scene/scene.h"

typedef enum tp_rule {
  TP_RULE_ANY,
  TP_RULE_ABOVE_ZERO,
  TP_RULE_NOT_NEGATIVE,
  TP_RULE_ANGLE_BELOW_90, /* [0, 90), of friction */
  TP_RULE_ANGLE_TO_90,    /* [0, 90], of tilt */
  TP_RULE_AZIMUTH,        /* [0, 360] */
  TP_RULE_JRC,
  TP_RULE_UNIT_WEIGHT, /* of rock */
  TP_RULE_BEYOND,      /* of a base past its block */
  TP_RULE_BULGE,       /* of an arc */
  TP_RULE_SHARE,       /* [0, 1] */
  TP_RULE_DIP,         /* [-90, 90], of a bolt */
  TP_RULE_COUNT        /* a whole number from 1 on, of rows of bolts */
} tp_rule;

/* Zero, or of a size that a double can tell. */
TP_MUST_USE tp_status tp_check_range(const fmpq_t value, const char *name, tp_place place,
                                     tp_message *message);
TP_MUST_USE tp_status tp_check_rule(tp_rule rule, const fmpq_t value, const char *name,
                                    tp_place place, tp_message *message);

/* Is it the block of a scene of one, not what many have in common? */
TP_MUST_USE tp_status tp_check_one_block(const tp_block_description *block, tp_message *message);

/* A whole number of teeth, as it goes into `count`. */
TP_MUST_USE tp_status tp_check_tooth_count(long *count, const fmpq_t value, const char *what,
                                           tp_place place, tp_message *message);
/* By the lesser height of the teeth, mean_height less half the amplitude. */
TP_MUST_USE tp_status tp_check_amplitude(const fmpq_t height, tp_place place, tp_message *message);
TP_MUST_USE tp_status tp_check_flat(const fmpq_t flat, const fmpq_t width, tp_place place,
                                    tp_message *message);
/* Two points, from left to right. */
TP_MUST_USE tp_status tp_check_mean_plane(const tp_polyline *plane, tp_place place,
                                          tp_message *message);
/* phi_b + i, Eq. (6). */
TP_MUST_USE tp_status tp_check_patton(const fmpq_t sum, tp_place place, tp_message *message);
/* Eq. (9): the angle is at least the residual one, and the stress below JCS. */
TP_MUST_USE tp_status tp_check_tilt_test(const fmpq_t angle_deg, const fmpq_t stress_kpa,
                                         const fmpq_t residual_deg, const fmpq_t jcs_mpa,
                                         tp_place place, tp_message *message);

/* A number of a facet of the base, as it goes into `number`; and the last of several, or the end of
 * a stretch, behind the first. */
TP_MUST_USE tp_status tp_check_facet_number(long *number, const fmpq_t value, tp_place place,
                                            tp_message *message);
TP_MUST_USE tp_status tp_check_facet_range(const tp_facet_friction_description *facets,
                                           tp_message *message);

/* What one thing of a scene needs of another, or cannot stand beside; `place` is of the first. */
TP_MUST_USE tp_status tp_check_parts_weighed(const tp_scene *scene, tp_place place,
                                             tp_message *message);
TP_MUST_USE tp_status tp_check_loads_weighed(const tp_scene *scene, tp_place place,
                                             tp_message *message);
/* One of its forms, and what belongs to that. */
TP_MUST_USE tp_status tp_check_water(const tp_scene *scene, tp_message *message);
TP_MUST_USE tp_status tp_check_law_weighed(const tp_scene *scene, tp_place place,
                                           tp_message *message);
TP_MUST_USE tp_status tp_check_contact_width(const tp_scene *scene, tp_message *message);
/* Frictions of facets: of a scene that has one angle for the others. */
TP_MUST_USE tp_status tp_check_facet_friction(const tp_scene *scene, tp_place place,
                                              tp_message *message);
TP_MUST_USE tp_status tp_check_arcs_on_outline(const tp_scene *scene, tp_place place,
                                               tp_message *message);
TP_MUST_USE tp_status tp_check_repair(const tp_scene *scene, tp_place place, tp_message *message);
/* `plain`: the ellipse has nothing of what it cannot have. */
TP_MUST_USE tp_status tp_check_ellipse_plain(bool plain, tp_place place, tp_message *message);

/* `key` narrows or widens a mated base. */
TP_MUST_USE tp_status tp_check_base_is_mated(const tp_scene *scene, const char *key, tp_place place,
                                             tp_message *message);
TP_MUST_USE tp_status tp_check_base_not_whole(const tp_scene *scene, tp_place place,
                                              tp_message *message);

/* The block is shifted along its base: along a mated one, to where it rests, and by how much. */
TP_MUST_USE tp_status tp_check_joint(const tp_scene *scene, tp_place place, tp_message *message);

/* All of these of a scene that was built, and is used now. */
TP_MUST_USE tp_status tp_check_built(const tp_scene *scene, tp_message *message);

/* Of many blocks: each that can move has a unit weight, or none has. */
TP_MUST_USE tp_status tp_check_block_weights(const tp_scene *scene, tp_message *message);
/* Of each bolt it is known where its far end holds. */
TP_MUST_USE tp_status tp_check_bolt_ends(const tp_scene *scene, tp_message *message);
/* Of many blocks: is an earthquake given a way that they have? */
TP_MUST_USE tp_status tp_check_block_shaking(const tp_scene *scene, tp_message *message);
/* Can water in and about many blocks have what a key says? */
TP_MUST_USE tp_status tp_check_block_water(const tp_water_description *water, const char *key,
                                           tp_place place, tp_message *message);
/* A scene of many that was built has nothing of one block on its base, and is complete; and one of
 * one block has nothing of many. */
TP_MUST_USE tp_status tp_check_built_blocks(const tp_scene *scene, tp_message *message);
TP_MUST_USE tp_status tp_check_built_alone(const tp_scene *scene, tp_message *message);

#endif
