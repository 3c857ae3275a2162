/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Many blocks held in arrays: their moments, their critical angles, their verdicts. Included by
 * topple.h.
 *
 *     const double xy[] = {0, 0, 50, 0, 50, 100, 0, 100, 0, 0, 80, 0, 80, 100, 0, 100};
 *     double angle_deg[2], error_deg[2];
 *     const tp_outlines outlines = tp_outlines_of(xy, 2, 4);
 *     const tp_blocks_options options = tp_blocks_options_default();
 *     const tp_critical_columns columns = {.angle_deg = angle_deg, .error_deg = error_deg};
 *     tp_blocks_summary summary;
 *     tp_status status =
 *         tp_blocks_critical_angles(&columns, &summary, &outlines, &options, &message);
 *
 * A block is an outline of doubles, taken as the binary numbers that they are, either way round,
 * its first point repeated at the end or not; x along the mean plane of the base, y normal to it.
 * It rests on a base mated with its underside, and has no loads but its weight: what tp_scene_new
 * makes of an outline. Each number goes into a column, an array with a place for every block; a
 * column that is NULL is not wanted. Every number has its proven bound in the column beside it:
 * |truth - value| <= error; a number that a block does not have is NaN.
 *
 * A block that is bad input stops nothing: its numbers are NaN, and its status says so. Any number
 * of threads gives the same bytes. A call that fails as a whole, for want of memory, may have
 * filled some of the columns. */

#ifndef TOPPLE_BLOCKS_H
#define TOPPLE_BLOCKS_H

#include "topple_governing.h"
#include "topple_limit.h"
#include "topple_onset.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Outlines, one after another in one array, which stays the caller's. */
typedef struct tp_outlines {
  size_t count;     /* of outlines */
  const double *xy; /* x0, y0, x1, y1, ... */
  size_t vertices;  /* of every outline; where they differ: */
  const size_t
      *first; /* outline k has the vertices first[k] to first[k + 1] - 1: count + 1 of them */
} tp_outlines;

/* Outlines of `vertices` vertices each: an array of shape (count, vertices, 2). */
tp_outlines tp_outlines_of(const double *xy, size_t count, size_t vertices);
/* Outlines of any number of vertices each: an array of shape (first[count], 2), and where in it
 * each one begins. */
tp_outlines tp_outlines_ragged(const double *xy, size_t count, const size_t *first);

/* How the blocks are computed. */
typedef struct tp_blocks_options {
  size_t size;    /* of this struct, as `…_default()` has it */
  size_t threads; /* that compute; 0: as many as the process may run on; 1: none is started */
  bool simple;    /* the caller vouches that no outline meets itself: where doubles decide, that is
                     not checked. Of an outline that does, the angle then means nothing */
  bool limit; /* verdicts: find the static limit and the onset, where there is a friction angle */
  bool strength_reduction; /* verdicts: and the factor of safety of the limit, where a tilt */
  tp_direction towards;    /* which way the table is tilted */
} tp_blocks_options;

/* The defaults: all threads, checked, with limit and strength reduction, towards the left. */
void tp_blocks_options_init(tp_blocks_options *options, size_t size);
static inline tp_blocks_options tp_blocks_options_default(void) {
  tp_blocks_options options;
  tp_blocks_options_init(&options, sizeof options);
  return options;
}

/* Summary of the blocks: the first four counts add up to all of them. */
typedef struct tp_blocks_summary {
  size_t done;          /* TP_OK */
  size_t without;       /* TP_NO_ANSWER: no pivot is admissible */
  size_t undecided;     /* TP_UNDECIDED, at the precision allowed */
  size_t bad;           /* TP_BAD_INPUT */
  size_t climbed;       /* of them all, those that doubles did not decide */
  size_t first_bad;     /* the first block that is bad input, from 0, where there is one, */
  tp_message complaint; /* and what is wrong with it; else empty */
} tp_blocks_summary;

/* Moments of area of an outline, in powers of the unit that its coordinates are in. */
typedef struct tp_area_moments {
  tp_bounded area;                   /* above 0 */
  tp_bounded centroid_x, centroid_y; /* where it lies */
  tp_bounded second_moment_xx, second_moment_yy,
      second_moment_xy; /* about the centroid: int x^2 dA, int y^2 dA, int x y dA */
} tp_area_moments;

/* Of one outline of `count` vertices x0, y0, x1, y1, ... by Green's theorem (mechanics.md, section
 * 2). That it does not meet itself is not checked: the sums are taken over it as it is.
 * TP_BAD_INPUT for fewer than three vertices, coordinates that are no finite numbers, and an area
 * of exactly 0. Of 6 vertices it takes less than a microsecond. */
TP_MUST_USE tp_status tp_outline_moments(tp_area_moments *moments, const double *xy, size_t count,
                                         tp_message *message);

/* Columns for the moments of many outlines: each of `count` places, or NULL. */
typedef struct tp_moment_columns {
  double *area, *area_error;                         /* the area, and its error */
  double *centroid_x, *centroid_x_error;             /* the centroid along x */
  double *centroid_y, *centroid_y_error;             /* and along y */
  double *second_moment_xx, *second_moment_xx_error; /* int x^2 dA about it */
  double *second_moment_yy, *second_moment_yy_error; /* int y^2 dA */
  double *second_moment_xy, *second_moment_xy_error; /* int x y dA */
  tp_status *status;                                 /* TP_OK or TP_BAD_INPUT */
} tp_moment_columns;

/* The same of many outlines. Of the options, `threads` counts. */
TP_MUST_USE tp_status tp_outlines_moments(const tp_moment_columns *columns,
                                          tp_blocks_summary *summary, const tp_outlines *outlines,
                                          const tp_blocks_options *options, tp_message *message);

/* Columns for critical angles: each of `count` places, or NULL. */
typedef struct tp_critical_columns {
  double *angle_deg; /* -180 to 180; above 90 it never topples, below 0 not even level */
  double *error_deg; /* at most 1e-9 of the angle */
  long *pivot;       /* the vertex of the outline as given, from 0, that it turns about, or -1 */
  tp_status *status; /* TP_NO_ANSWER where no pivot is admissible */
} tp_critical_columns;

/* The tilt at which moments of the weight let each block turn about the admissible pivot that
 * begins to move first (Eq. 2 of Alejano et al.): atan2(x arm, y arm) of the centroid about it, as
 * tp_solve has it. A filter in doubles with a proven bound decides nearly all; the others climb by
 * exact arithmetic, and are counted. */
TP_MUST_USE tp_status tp_blocks_critical_angles(const tp_critical_columns *columns,
                                                tp_blocks_summary *summary,
                                                const tp_outlines *outlines,
                                                const tp_blocks_options *options,
                                                tp_message *message);

/* A number for each block, or one for all; NaN, where a block has none. */
typedef struct tp_numbers {
  const double *each; /* of `count` places; NULL: */
  double all;         /* the one for all */
} tp_numbers;

/* One for all. */
tp_numbers tp_numbers_of(double all);
/* One for each. */
tp_numbers tp_numbers_each(const double *each);

/* Columns for verdicts: each of `count` places, or NULL. Of a block that is bad input every
 * mechanism and kind is undecided. */
typedef struct tp_verdict_columns {
  tp_mechanism *mechanism; /* at the tilt; without one, the first as the table is tilted */
  tp_mechanism *first;     /* what happens first as the table is tilted from level, */
  double *first_angle_deg, *first_error_deg;       /* and where */
  double *critical_angle_deg, *critical_error_deg; /* by moments, of the governing pivot */
  tp_limit_kind *limit_kind;                       /* of the static limit (topple_limit.h) */
  double *limit_angle_deg, *limit_error_deg;       /* where it is at an angle */
  tp_onset_kind *onset_kind;                       /* of the onset of motion (topple_onset.h) */
  double *onset_angle_deg, *onset_error_deg;       /* where it is at an angle */
  double *fos, *fos_error; /* the governing factor of safety, where there is a tilt and a number */
  tp_status *status;       /* TP_UNDECIDED: of it some is, and the rest holds */
  tp_mechanism *fos_mechanism; /* against which that factor is; undecided where there is none */
  tp_fos_definition *fos_definition; /* by which it is defined; by moments where there is none */
  double *fos_moments, *fos_moments_error; /* of moments, about the pivot that is the least safe */
  double *fos_sliding, *fos_sliding_error; /* of shear strength */
} tp_verdict_columns;

/* The verdict of each block, by doubles with bounds or else by tp_solve, with its friction angle, 0
 * to below 90 degrees, and its tilt, 0 to 90 degrees. */
TP_MUST_USE tp_status tp_blocks_solve(const tp_verdict_columns *columns, tp_blocks_summary *summary,
                                      const tp_outlines *outlines, tp_numbers friction_angle_deg,
                                      tp_numbers tilt_angle_deg, const tp_blocks_options *options,
                                      tp_message *message);

#ifdef __cplusplus
}
#endif

#endif
