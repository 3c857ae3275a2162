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

#include "topple_limit.h"
#include "topple_onset.h"

#ifdef __cplusplus
extern "C" {
#endif

/* `count` outlines, one after another, in one array x0, y0, x1, y1, ... that stays the caller's. */
typedef struct tp_outlines {
  size_t count;        /* of outlines */
  const double *xy;    /* their points */
  size_t vertices;     /* of every outline; where they differ: */
  const size_t *first; /* vertex first[k] to first[k + 1] - 1 are outline k's: count + 1 of them */
} tp_outlines;

/* All of `vertices` vertices, as an array of shape (count, vertices, 2). */
tp_outlines tp_outlines_of(const double *xy, size_t count, size_t vertices);
/* Each of its own number, as an array of shape (first[count], 2). */
tp_outlines tp_outlines_ragged(const double *xy, size_t count, const size_t *first);

/* How many blocks are computed. */
typedef struct tp_blocks_options {
  size_t size;    /* of this struct, as `…_default()` has it */
  size_t threads; /* that compute; 0: as many as the process may run on; 1: none is started */
  bool simple;    /* the caller vouches that no outline meets itself: where doubles decide, that is
                     not checked. Of an outline that does, the angle then means nothing */
  bool limit; /* verdicts: find the static limit and the onset, where there is a friction angle */
  bool strength_reduction; /* verdicts: and the factor of safety of the limit, where a tilt */
  tp_direction towards;    /* which way the table is tilted */
} tp_blocks_options;

/* All threads, checked, with limit and strength reduction, towards the left. */
void tp_blocks_options_init(tp_blocks_options *options, size_t size);
static inline tp_blocks_options tp_blocks_options_default(void) {
  tp_blocks_options options;
  tp_blocks_options_init(&options, sizeof options);
  return options;
}

/* What became of the blocks: counts that add up to all of them. */
typedef struct tp_blocks_summary {
  size_t done;          /* TP_OK */
  size_t without;       /* TP_NO_ANSWER: no pivot is admissible */
  size_t undecided;     /* TP_UNDECIDED, at the precision allowed */
  size_t bad;           /* TP_BAD_INPUT */
  size_t climbed;       /* of them all, those that doubles did not decide */
  size_t first_bad;     /* the first block that is bad input, where there is one, */
  tp_message complaint; /* and what is wrong with it; else empty */
} tp_blocks_summary;

/* Area, centroid and second moments of area about the centroid: powers 1 to 4 of the unit that the
 * coordinates are in. */
typedef struct tp_area_moments {
  tp_bounded area;                   /* int dA */
  tp_bounded centroid_x, centroid_y; /* where the outline's own coordinates lie */
  tp_bounded second_moment_xx, second_moment_yy, second_moment_xy; /* int x^2, y^2, x y dA */
} tp_area_moments;

/* Of one outline of `count` vertices x0, y0, x1, y1, ... That it does not meet itself is not
 * checked: the sums of Green's theorem are taken over it as it is. TP_BAD_INPUT for fewer than
 * three vertices, coordinates that are no finite numbers, and an area of exactly 0. */
TP_MUST_USE tp_status tp_outline_moments(tp_area_moments *moments, const double *xy, size_t count,
                                         tp_message *message);

/* Columns for the same of many. */
typedef struct tp_moment_columns {
  double *area, *area_error;                         /* as in tp_area_moments */
  double *centroid_x, *centroid_x_error;             /* x of the centroid */
  double *centroid_y, *centroid_y_error;             /* and y */
  double *second_moment_xx, *second_moment_xx_error; /* int x^2 dA */
  double *second_moment_yy, *second_moment_yy_error; /* int y^2 dA */
  double *second_moment_xy, *second_moment_xy_error; /* int x y dA */
  tp_status *status;                                 /* TP_OK, or TP_BAD_INPUT */
} tp_moment_columns;

/* tp_outline_moments of many. Of the options, `threads` counts. */
TP_MUST_USE tp_status tp_outlines_moments(const tp_moment_columns *columns,
                                          tp_blocks_summary *summary, const tp_outlines *outlines,
                                          const tp_blocks_options *options, tp_message *message);

/* The tilt at which moments of the weight let a block turn about the admissible pivot that lets go
 * first (Eq. 2): atan2(x arm, y arm) of the centroid about it, -180 to 180 degrees. */
typedef struct tp_critical_columns {
  double *angle_deg, *error_deg; /* the error at most 1e-9 of the angle */
  long *pivot;                   /* the vertex of the outline, from 0, that it turns about, or -1 */
  tp_status *status;             /* TP_NO_ANSWER where no pivot is admissible */
} tp_critical_columns;

/* What tp_solve tells of each as critical angle of its governing pivot. A filter in doubles with a
 * proven bound decides nearly all; the others climb by exact arithmetic, and are counted. */
TP_MUST_USE tp_status tp_blocks_critical_angles(const tp_critical_columns *columns,
                                                tp_blocks_summary *summary,
                                                const tp_outlines *outlines,
                                                const tp_blocks_options *options,
                                                tp_message *message);

/* A number for each block, or one for all: NaN, where the block has none. */
typedef struct tp_numbers {
  const double *each; /* a number for each; NULL: */
  double all;         /* one for all */
} tp_numbers;

/* One number for all blocks. */
tp_numbers tp_numbers_of(double all);

/* An array with a number for each, which stays the caller's. */
tp_numbers tp_numbers_each(const double *each);

/* Columns for the verdicts of many. */
typedef struct tp_verdict_columns {
  tp_mechanism *mechanism; /* at the tilt; without one, the first as the table is tilted */
  tp_mechanism *first;     /* what happens first as the table is tilted from level, and where */
  double *first_angle_deg, *first_error_deg;       /* the tilt at which that happens */
  double *critical_angle_deg, *critical_error_deg; /* by moments, as above */
  tp_limit_kind *limit_kind;                       /* the static limit (topple_limit.h) */
  double *limit_angle_deg, *limit_error_deg;       /* its tilt, where it is at one */
  tp_onset_kind *onset_kind;                       /* the onset of motion (topple_onset.h) */
  double *onset_angle_deg, *onset_error_deg;       /* its tilt, likewise */
  double *fos, *fos_error; /* the governing factor of safety, where there is a tilt and a number */
  tp_status *status;       /* TP_UNDECIDED: of it some is, and the rest holds */
} tp_verdict_columns;

/* The full verdict of each block by tp_solve, with its friction angle and its tilt in degrees. */
TP_MUST_USE tp_status tp_blocks_solve(const tp_verdict_columns *columns, tp_blocks_summary *summary,
                                      const tp_outlines *outlines, tp_numbers friction_angle_deg,
                                      tp_numbers tilt_angle_deg, const tp_blocks_options *options,
                                      tp_message *message);

#ifdef __cplusplus
}
#endif

#endif
