/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A load on a tilted table in rationals, beside the load's wrench in balls.
 *
 * Pressures and weights that are spread over a line are summed by Simpson's rule, which is exact
 * for products of two linear functions, in coordinates of the world, where gravity points straight
 * down and water lies level. Tilts have a rational sine and cosine, so that all of it is exact. */

#ifndef TP_TEST_LOAD_STAGE_H
#define TP_TEST_LOAD_STAGE_H

#include "exact_vectors.h"
#include "random_numbers.h"

#include "load/loads.h"

enum { STAGE_BITS = 128, STAGE_SCRATCH = 6 };

/* A random setting of a load at a random tilt, mirrored or not. */
typedef struct load_stage {
  random_numbers *state; /* of the random numbers */
  tp_scene scene;
  tp_load_setting setting;
  fmpq weight, x, y, toe_x, heel_x, heel_y, thickness; /* what the balls of the setting are */
  fmpq sine, cosine;
  tp_wrench wrench;   /* for the load under test */
  exact_wrench truth; /* in the world, about the scene's origin */
  exact_point at;     /* room for the test */
  fmpq t[STAGE_SCRATCH];
} load_stage;

void load_stage_init(load_stage *s, random_numbers *state);
void load_stage_clear(load_stage *s);

/* A number of the scene, with a denominator that no ball holds. */
void load_stage_draw(load_stage *s, tp_quantity *quantity, long least, long most);

/* Add to the truth a force of the world, or one that turns with the block, at a point of the block.
 */
void load_stage_add(load_stage *s, const fmpq_t fx, const fmpq_t fy, const fmpq_t x,
                    const fmpq_t y);
void load_stage_add_turning(load_stage *s, const fmpq_t fx, const fmpq_t fy, const fmpq_t x,
                            const fmpq_t y);

/* The wrench holds the truth, and is as sharp as it should be, where no force is above `force` and
 * none farther than `reach` from the origin. */
void load_stage_check(const load_stage *s, const char *load, const fmpq_t force, long reach);

/* For Simpson's rule at 0, 1 and 2 halves: the weight of the k-th, in sixths. */
long simpson_sixths(int k);

/* A line of the block whose length is a whole number of scene lengths, (dx, dy), and numbers of kPa
 * at its ends, now and then 0. */
typedef struct stage_line {
  tp_line_load load;
  long dx, dy, length;
} stage_line;

void stage_line_init(stage_line *line, load_stage *s);
void stage_line_clear(stage_line *line);

/* s->at = the point of the line at k halves, in metres and mirrored; force = the newtons of that
 * point of Simpson's rule for each scene length of the line. */
void stage_line_point(fmpq_t force, load_stage *s, const stage_line *line, int k);

#endif
