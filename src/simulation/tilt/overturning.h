/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Which shaking overturns a block, or throws it off its base: of a block that turns off the end of
 * its base no quarter of a turn is waited for. Stronger shaking may spare a block that weaker
 * shaking overturns: what overturns it are ranges of the factor on the scene's shaking, islands, of
 * any width. So nothing is told but of factors that were run: no search by halves finds the least.
 * A run that is not decided spares no block and ends the search, which is then not converged. */

#ifndef TP_TILT_OVERTURNING_H
#define TP_TILT_OVERTURNING_H

#include "shaking/shaking.h"
#include "tilt/trial.h"

/* A block at the tilt of its release, and the shaking of its base; the tilting's shaking is that,
 * and its own->converged whether all runs were decided. */
typedef struct tp_overturning {
  tp_tilting *tilting;
  tp_base_shaking *shaking;
} tp_overturning;

/* Is it overturned (TP_VERDICT_MOVES), or spared (TP_VERDICT_STANDS), by `factor` times the scene's
 * shaking? */
TP_MUST_USE tp_status tp_overturning_look(tp_tilt_verdict *verdict, tp_overturning *overturning,
                                          double factor);

/* Two factors at which it was not the same, narrowed until they differ by less than `tolerance` of
 * the second: by halves, as long as runs are decided. `upper`: what became of it at the second. */
TP_MUST_USE tp_status tp_overturning_narrow(double between[2], tp_overturning *overturning,
                                            tp_tilt_verdict upper, double tolerance);

/* Are the options' factors a grid, or none? */
TP_MUST_USE tp_status tp_overturning_check(const tp_tilt_options *options, tp_message *message);

/* Of a scene: the factors of the options' grid are tried, or where they give none 65 from 1/16 to
 * 16, and then the octave below the least that overturns it by steps of 2^(1/128), again below any
 * that is found there. Where the outcome changes from one factor to the next the two are narrowed
 * to 1e-3. Of 193 factors, and 10 more for each change at most, each a run. The shaking is the
 * scene's again then. Grids and ranges go to the tilting's own case, whose ranges are to be freed.
 */
TP_MUST_USE tp_status tp_tilting_overturning(tp_tilting *tilting, tp_base_shaking *shaking);

/* The same of a block that its own shaking does not overturn, for the factors of the octave below 1
 * alone. A run that is not decided ends the search; the grid has what was tried before it. */
TP_MUST_USE tp_status tp_tilting_overturning_below(tp_tilting *tilting, tp_base_shaking *shaking);

#endif
