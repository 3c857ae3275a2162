/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* All points of a scene, turned into the frame of its mean plane (problem/world.h). */

#ifndef TP_PROBLEM_WORLD_TURN_H
#define TP_PROBLEM_WORLD_TURN_H

#include "scene/moved.h"

typedef struct tp_turn {
  int rises;      /* 1: the mean plane rises to the right, so that it dips to the left; -1; 0 */
  fmpq_t dip_deg; /* 0 and above */
  fmpq_t x, y;    /* of the point that stays, in scene lengths */
  fmpq_t cosine, sine;
} tp_turn;

void tp_turn_init(tp_turn *turn);
void tp_turn_clear(tp_turn *turn);

/* Cosine, sine, dip and which way it rises, for a plane with the direction (u, v), u > 0. */
void tp_turn_set(tp_turn *turn, const fmpq_t u, const fmpq_t v);

/* The turn by which a scene that dips as `of` does lies tilted by so many degrees more, with the
 * same point that stays; and the direction of the mean plane of `of` after it. */
void tp_turn_by(tp_turn *turn, const fmpq_t degrees, const tp_turn *of);
void tp_turn_direction(fmpq_t cosine, fmpq_t sine, const tp_turn *of, const tp_turn *turn);

/* A point turned: x' = x0 + c (x - x0) + s (y - y0), about the one that stays. */
void tp_turn_point(fmpq_t x, fmpq_t y, const tp_turn *turn);
/* The inverse of that, exactly: x = x0 + (c (x' - x0) - s (y' - y0)) / (c² + s²). */
void tp_turn_back_point(fmpq_t x, fmpq_t y, const tp_turn *turn);

/* Fill a copy of the scene (scene/moved.h) with its turned points, the ends of its contact named by
 * vertices of its outline where they are kept. False when memory is exhausted. */
TP_MUST_USE bool tp_turn_scene(tp_scene *turned, const tp_turn *turn, const tp_scene *scene,
                               bool keeps_ends, long first, long last);

#endif
