/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What a random scene calls for besides outline, base, friction and tilt: rounded corners, arcs, an
 * ellipse, loads, laws of friction. Numbers stand in the order of how they change with the size of
 * the scene; points are vertices before the scene's map. */

#ifndef TP_TEST_RANDOM_EFFECTS_H
#define TP_TEST_RANDOM_EFFECTS_H

#include "random_numbers.h"

#include <flint/fmpq.h>
#include <stdbool.h>
#include <stdio.h>

enum { CORNERS_MOST = 3, ARCS_MOST = 2, LINES_MOST = 2, ANCHORS_MOST = 2 };

enum {
  RADII, /* scene lengths */
  WATER_HEIGHT = RADII + CORNERS_MOST,
  ELLIPSE_WIDTH,
  ELLIPSE_HEIGHT,
  ELLIPSE_FLAT,
  CRACK_HEIGHT,
  CRACK_DISTANCE,
  ICE_THICKNESS,
  STRESSES, /* kPa: two for each pressure, one for each surcharge */
  SURCHARGES = STRESSES + 2 * LINES_MOST,
  BOND = SURCHARGES + LINES_MOST,
  COHESION,
  STRENGTH,
  TEST_STRESS,
  ICE_STRESS,
  FORCES, /* kN */
  PLAIN_NUMBERS = FORCES + ANCHORS_MOST,
  DIRECTIONS = PLAIN_NUMBERS,
  DIPS = DIRECTIONS + ANCHORS_MOST,
  HORIZONTAL = DIPS + ANCHORS_MOST,
  VERTICAL,
  WATER_WEIGHT,
  JRC,
  TEST_ANGLE,
  ROUGHNESS,
  THICKNESS, /* scene lengths that stay where the section is scaled */
  SPACING,
  EFFECT_NUMBERS
};

enum {
  AT_CORNERS,
  AT_ARCS = AT_CORNERS + CORNERS_MOST, /* both ends of each */
  AT_PRESSURES = AT_ARCS + 2 * ARCS_MOST,
  AT_SURCHARGES = AT_PRESSURES + 2 * LINES_MOST,
  AT_ANCHORS = AT_SURCHARGES + 2 * LINES_MOST,
  AT_BETWEEN = AT_ANCHORS + ANCHORS_MOST,
  EFFECT_POINTS = AT_BETWEEN + 2
};

typedef enum random_law { LAW_NONE, LAW_PATTON, LAW_JRC, LAW_TEST, LAW_ROUGHNESS } random_law;
typedef enum random_place { AT_LEFT_END, AT_RIGHT_END, AT_VERTEX } random_place;
typedef enum random_towards { TOWARDS_BOTH, TOWARDS_LEFT, TOWARDS_RIGHT } random_towards;

/* Water of a level, and what is wetted by it. */
typedef enum random_uplift { UPLIFT_NONE, UPLIFT_TRIANGULAR, UPLIFT_FULL } random_uplift;
typedef enum random_faces { FACES_BEHIND, FACES_FRONT, FACES_BOTH } random_faces;

typedef struct random_effects {
  fmpq numbers[EFFECT_NUMBERS];
  long x[EFFECT_POINTS], y[EFFECT_POINTS];
  int corners, arcs, pressures, surcharges, anchors; /* how many */
  int bulges[ARCS_MOST];                             /* in 16ths */
  random_place places[CORNERS_MOST];
  bool paper_model, ellipse, seismic, water, stays_level, uplift, passive[ANCHORS_MOST];
  bool has_between;
  random_law law;
  random_towards towards;
  /* random_site.c: on a slope; water of a level; the last pressures are a lining's; bolts by their
   * dip */
  bool slope, sited, crack, ice, lined, lining_passive, bolted, spaced[ANCHORS_MOST];
  random_uplift uplift_kind;
  random_faces faces;
  int unit_of_site;
} random_effects;

struct random_scene;

/* Up to all of them at once. */
void random_effects_draw(struct random_scene *scene, random_numbers *state);

/* The block at its place, on top of those. */
void random_site_draw(struct random_scene *scene, random_numbers *state);
void random_site_write_water(FILE *file, const random_effects *effects);
void random_site_write_tilt(FILE *file, const struct random_scene *scene);

bool random_effects_load(const random_effects *effects); /* any besides the weight */

/* Cohesion or a bond? */
bool random_effects_allow(const random_effects *effects);

/* Do they turn with the block? Loads, laws and the ends of the underside belong to the table. */
bool random_effects_turn(const random_effects *effects);

/* Is the edge between these two vertices an arc, or does a line load act on it? */
bool random_effects_need_edge(const random_effects *effects, const long from[2], const long to[2]);

void random_effects_mirror(random_effects *effects);

/* Lengths times the factor; stresses times its first power, forces its second. */
void random_effects_lengthen(random_effects *effects, const fmpq *factor);
void random_effects_load_more(random_effects *effects, const fmpq *factor);

/* Parts of a scene file, each beginning with a new line. */
void random_effects_write_block(FILE *file, const struct random_scene *scene);
void random_effects_write_between(FILE *file, const struct random_scene *scene);
void random_effects_write_loads(FILE *file, const struct random_scene *scene);
void random_effects_write_friction(FILE *file, const struct random_scene *scene);
void random_effects_write_tilt(FILE *file, const struct random_scene *scene);

#endif
