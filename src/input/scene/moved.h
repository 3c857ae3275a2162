/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A copy of a scene whose points are moved. It owns these, and shares all else with the scene,
 * which must outlive it. */

#ifndef TP_SCENE_MOVED_H
#define TP_SCENE_MOVED_H

#include "scene/scene.h"

/* Where a point goes, exactly; NULL: it stays. */
typedef struct tp_point_map {
  void (*move)(fmpq_t x, fmpq_t y, const void *context);
  const void *context;
} tp_point_map;

/* Begin a copy that owns nothing yet. */
void tp_moved_begin(tp_scene *copy, const tp_scene *scene);

/* Fill it: false when memory is exhausted; what there is by then is tp_moved_clear's too. Rings are
 * the scene's own, or those that its block comes to; what else lies on the block turns by an angle
 * with it, anchors' directions too. */
TP_MUST_USE bool tp_moved_rings(tp_scene *copy, const tp_scene *scene, const tp_polyline *outline,
                                const tp_polyline *holes, const tp_point_map *map);
TP_MUST_USE bool tp_moved_block(tp_scene *copy, const tp_scene *scene, const fmpq_t turn_deg,
                                const tp_point_map *map);
TP_MUST_USE bool tp_moved_profile(tp_scene *copy, const tp_scene *scene, const tp_point_map *map);
/* Of the loads alone: part of what tp_moved_block does, and what a copy that owns nothing else
 * gives back. */
TP_MUST_USE bool tp_moved_loads(tp_scene *copy, const tp_scene *scene, const fmpq_t turn_deg,
                                const tp_point_map *map);
void tp_moved_clear_loads(tp_scene *copy);
void tp_moved_clear(tp_scene *copy);

/* Line loads of a copy, all of whose numbers are its own. */
void tp_moved_clear_lines(tp_line_load *loads, long count);

#endif
