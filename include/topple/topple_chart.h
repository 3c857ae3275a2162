/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The public library's charts: curves and borders, as tables and as figures. Included by topple.h.
 */

#ifndef TOPPLE_CHART_H
#define TOPPLE_CHART_H

#include "topple_solve.h"
#include "topple_study.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Numbers of the caller, TP_CHART_LIST_MAX at most: a chart has as many colours that the
 * colour-blind distinguish. More are bad input. */
enum { TP_CHART_LIST_MAX = 6 };

/* A list of them. */
typedef struct tp_chart_list {
  size_t count;         /* of the values */
  const double *values; /* which stay the caller's */
} tp_chart_list;

/* From one number to another. */
typedef struct tp_chart_range {
  double from, to; /* from < to */
} tp_chart_range;

/* FoS against tilt about planar, peak and valley axes (Fig. 16 of Alejano et al.): by Eqs. (15),
 * (16), with the A^2 / (12 y^2) that is right, and (17); or, for each number of sub-blocks, of the
 * exact block. A panel for each relative amplitude and number of sub-blocks. */
typedef struct tp_chart_fos_options {
  size_t size;                       /* of this struct, as `…_default()` has it */
  tp_chart_list inverse_slenderness; /* dx / y, 0 to 10 */
  tp_chart_list amplitude;           /* A / y, 0 to 0.5 */
  tp_chart_list sub_blocks;          /* none: by the equations; else whole, 2 to 1000 */
  tp_chart_range tilt_deg;           /* within 0 to 90 */
} tp_chart_fos_options;

/* The defaults: dx / y of 0.5, 0.75 and 1, A / y of 0.1, by the equations, from 5 to 60 degrees.
 * `size` is that of the struct as the caller knows it. */
void tp_chart_fos_options_init(tp_chart_fos_options *options, size_t size);
static inline tp_chart_fos_options tp_chart_fos_options_default(void) {
  tp_chart_fos_options options;
  tp_chart_fos_options_init(&options, sizeof options);
  return options;
}

/* The chart, to be freed by tp_chart_free. TP_UNDECIDED, TP_DEPENDENCY_FAILED. */
TP_MUST_USE tp_status tp_chart_fos(tp_chart **chart, const tp_chart_fos_options *options,
                                   tp_message *message);

/* Mechanism maps for a planar and for a rough base (Fig. 18), with the blocks of Table 7, and with
 * the borders between the motions that begin from rest, of slabs and of sawtooth blocks. */
typedef struct tp_chart_mechanisms_options {
  size_t size;                /* of this struct, as `…_default()` has it */
  double friction_deg;        /* above 0 */
  double roughness_angle_deg; /* i; friction + i at most 80. Below 2 no blocks are placed */
  double amplitude;           /* A / y, 0 to 0.5 */
} tp_chart_mechanisms_options;

/* The defaults: 30 degrees, i of 10 degrees, A / y of 0.01. `size` is that of the struct as the
 * caller knows it. */
void tp_chart_mechanisms_options_init(tp_chart_mechanisms_options *options, size_t size);
static inline tp_chart_mechanisms_options tp_chart_mechanisms_options_default(void) {
  tp_chart_mechanisms_options options;
  tp_chart_mechanisms_options_init(&options, sizeof options);
  return options;
}

/* The chart, to be freed by tp_chart_free. TP_UNDECIDED, TP_DEPENDENCY_FAILED. */
TP_MUST_USE tp_status tp_chart_mechanisms(tp_chart **chart,
                                          const tp_chart_mechanisms_options *options,
                                          tp_message *message);

/* Critical angles about peak and valley against A / y, for the ranges of Fig. 14. To be freed by
 * tp_chart_free. TP_UNDECIDED, TP_DEPENDENCY_FAILED. */
TP_MUST_USE tp_status tp_chart_ranges(tp_chart **chart, tp_message *message);

/* A number of a scene and the range that it is taken through; `key` as in tp_find_options, or
 * `tilt`, the tilt angle in degrees. */
typedef struct tp_chart_axis {
  const char *key;      /* which number */
  tp_chart_range range; /* in the units of the scene, or degrees */
} tp_chart_axis;

/* The mechanism map of a scene that tilts in one direction and has a friction angle. At most one
 * axis is the tilt. Over two other numbers it shows the first motion; where the scene has a tilt
 * angle (or lies as it does in the world), what the block does at that tilt, which the title says.
 * Every border is a root: on its two sides, as close as doubles lie, the
 * certified mechanism differs. A change and its reversal between two of the points that are tried
 * at, 241 along a scalar or a grid of 49 by 49, may be missed. Along one scalar it has the borders
 * between motions from rest as well (tp_onset.ranges). */
typedef struct tp_chart_map_options {
  size_t size;           /* of this struct, as `…_default()` has it */
  const tp_scene *scene; /* not changed */
  tp_chart_axis x, y;    /* to the right, and upwards */
  bool any_tilt;         /* the first motion, whatever the scene's tilt */
  bool governing_fos;    /* contours of the factor of safety that governs at the scene's tilt, which
                            a map over two numbers but the tilt can have; else of angles */
  tp_chart_list levels;  /* of the contours; none: 1, 1.1, 1.3, 1.5, 2; of angles round numbers */
} tp_chart_map_options;

/* The defaults: the tilt from 0 to 90 degrees upwards; the scene and x are to be given. `size` is
 * that of the struct as the caller knows it. */
void tp_chart_map_options_init(tp_chart_map_options *options, size_t size);
static inline tp_chart_map_options tp_chart_map_options_default(void) {
  tp_chart_map_options options;
  tp_chart_map_options_init(&options, sizeof options);
  return options;
}

/* The map, to be freed by tp_chart_free. TP_NO_ANSWER where the scene has none in the whole range;
 * TP_UNDECIDED, TP_DEPENDENCY_FAILED. */
TP_MUST_USE tp_status tp_chart_map(tp_chart **chart, const tp_chart_map_options *options,
                                   tp_message *message);

/* What a study came to: the probability against tilt with its band, the distribution of the angle
 * at which samples begin to move by outcome, rank correlations of that angle with what
 * varies, and how the estimate settled. And that angle against each number that varies, of the
 * first
 * 8. To be freed by tp_chart_free. TP_NO_ANSWER where no sample has such an angle. */
TP_MUST_USE tp_status tp_chart_study(tp_chart **chart, const tp_study_result *result,
                                     tp_message *message);
TP_MUST_USE tp_status tp_chart_study_scatter(tp_chart **chart, const tp_study_result *result,
                                             tp_message *message);

/* Free it with all that it holds; NULL is allowed. */
void tp_chart_free(tp_chart *chart);

/* The chart's numbers: a row for every point, with its error. `*text` is allocated with malloc and
 * is the caller's to free. */
TP_MUST_USE tp_status tp_report_chart_csv(char **text, const tp_chart *chart);
TP_MUST_USE tp_status tp_report_chart_json(char **text, const tp_chart *chart);

/* What a chart can be written as. */
typedef enum tp_chart_format {
  TP_CHART_SVG,
  TP_CHART_PDF,
  TP_CHART_PNG,
  TP_CHART_CSV
} tp_chart_format;

/* The format that the name `path` ends in; false for another ending. */
bool tp_chart_format_read(tp_chart_format *format, const char *path);

/* Write the chart into the file `path`, whole or not at all; one that is there keeps its owner and
 * mode, and one that the chart was computed from is bad input. All but CSV are drawn by gnuplot,
 * which must be installed. TP_SYSTEM_FAILED where it is not, or the file cannot be written. */
TP_MUST_USE tp_status tp_report_chart_file(const char *path, const tp_chart *chart,
                                           tp_chart_format format, tp_message *message);

#ifdef __cplusplus
}
#endif

#endif
