/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What the calls that build a scene in memory share: numbers by their rules into the scene, all of
 * a call or none. The rules are those of the reader of files (scene/check.h). */

#ifndef TP_SCENE_BUILDING_BUILD_H
#define TP_SCENE_BUILDING_BUILD_H

#include "scene/check.h"
#include "scene/exact.h"
#include "scene/members.h"
#include "scene/scene.h"

#include <stddef.h>

/* The most numbers of one call. */
enum { TP_BUILD_MOST = 6 };

/* An argument of a call, by its name. */
typedef struct tp_given {
  const char *name;
  tp_exact value;
  tp_rule rule;
} tp_given;

/* The numbers of one call, read. */
typedef struct tp_build {
  tp_scene *scene;
  tp_place place; /* the call */
  tp_message *message;
  long count;
  fmpq values[TP_BUILD_MOST];
} tp_build;

/* Can the scene be changed by `call`: was it not read from a file? */
TP_MUST_USE tp_status tp_build_begin(tp_build *build, tp_scene *scene, const char *call,
                                     tp_message *message);

/* Read the arguments and look at them; tp_build_end gives the numbers back, however it went. */
TP_MUST_USE tp_status tp_build_read(tp_build *build, const tp_given *given, long count);
void tp_build_end(tp_build *build);

/* Put number `index` into the scene; it is taken out of the build. */
void tp_build_put(tp_build *build, tp_quantity *quantity, long index);

/* A call of one number, by its key in a scene file. */
TP_MUST_USE tp_status tp_build_set(tp_scene *scene, const char *call, const char *key,
                                   tp_exact value, tp_message *message);

/* Make room for one more of `count` items, and name its place, which counts from 1. */
TP_MUST_USE tp_status tp_build_grow(tp_build *build, void **items, long count, size_t size);

/* A hole or a part more of a block; the numbers of the build are given back. */
TP_MUST_USE tp_status tp_build_hole(tp_build *build, tp_block_description *block,
                                    tp_coordinates outline);
TP_MUST_USE tp_status tp_build_part(tp_build *build, tp_block_description *block,
                                    tp_coordinates outline, tp_exact unit_weight_kn_m3);

/* Is `number` that of one of `count` things of a kind, from 1 on? */
TP_MUST_USE tp_status tp_build_find(const tp_build *build, size_t number, long count,
                                    const char *what);

/* The number of a facet, as a call has it. */
TP_MUST_USE tp_status tp_build_facet_number(const tp_build *build, long *number, size_t facet);

/* Nothing is known of the base but that it is mated, or not. */
void tp_base_drop(tp_base_description *base);

/* Make the profile of the base by its rule, which has one. */
TP_MUST_USE tp_status tp_build_profile(tp_scene *scene, tp_message *message);

/* An anchor, a bolt or a force: where it pulls, and by one number or two which way, at their
 * members of a tp_anchor_description. */
typedef struct tp_pull {
  tp_exact x, y, force_kn;
  bool passive;
  tp_given way[2];
  size_t members[2];
} tp_pull;

/* Add it to its list. */
TP_MUST_USE tp_status tp_build_pull(tp_scene *scene, const char *call, tp_list_kind list,
                                    const tp_pull *pull, tp_message *message);

/* The scene has loads, first by this call. */
void tp_build_note_load(tp_build *build);

#endif
