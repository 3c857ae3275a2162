/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Random scenes as numbers, to be changed in known ways and written as scene files. */

#ifndef TP_TEST_RANDOM_SCENES_H
#define TP_TEST_RANDOM_SCENES_H

#include "random_effects.h"
#include "random_polygons.h"
#include "topple.h"

#include <arb.h>
#include <flint/fmpq.h>

/* A vertex (x, y) is written as (XX x + XY y + MOVE_X, YX x + YY y + MOVE_Y). */
enum { XX, XY, YX, YY, MOVE_X, MOVE_Y, BEYOND_LEFT, BEYOND_RIGHT, FRICTION, TILT, NUMBERS };
enum { MAP_NUMBERS = MOVE_Y + 1 };

typedef struct random_scene {
  polygon outline, hole, part; /* hole and part: without vertices where there is none */
  polygon profile;             /* from left to right; without vertices: the base is mated */
  long part_weight;            /* kN/m3 */
  bool beyond_stated, has_friction, has_tilt;
  int unit;
  fmpq numbers[NUMBERS];
  random_effects effects; /* none where drawn by random_scene_draw alone */
} random_scene;

enum { BLOCK_WEIGHT = 26 }; /* kN/m3 */

/* Whole numbers of a scene before its map are multiples of this, so that shares of its sizes are
 * whole. */
enum { GRAIN = 8 };

/* Blocks of three kinds (stars; teeth and rough undersides below upright or leaning bodies; with
 * overhangs) on bases that are mated or touch here and there, some of them degenerate on purpose:
 * small whole coordinates tie pivots and put centroids above them, friction equals tilt, tilts are
 * 0, 45 and 90. Some are small, large, far off, or of many digits. */
void random_scene_draw(random_scene *scene, random_numbers *state);
void random_scene_copy(random_scene *copy, const random_scene *scene);
/* A vertex of one of its rings, or of its profile, in scene lengths. */
void random_scene_vertex(fmpq_t x, fmpq_t y, const random_scene *scene, const polygon *ring,
                         long k);
void random_scene_clear(random_scene *scene);

/* The scene's map. */
void random_scene_map(fmpq_t x, fmpq_t y, const random_scene *scene, long from_x, long from_y);
void random_scene_number(FILE *file, const char *before, const fmpq *value, const char *after);

enum { UNITS = 6 };
typedef struct random_unit {
  const char *name;
  fmpq metres;
} random_unit;
extern const random_unit random_units[UNITS];

/* As a scene file; to be freed. */
char *random_scene_text(const random_scene *scene);

#endif
