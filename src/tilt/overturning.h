/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The least shaking that overturns a block, or throws it off its base: of a block that turns off
 * the end of its base no quarter of a turn is waited for. Stronger shaking may spare a block that
 * weaker shaking overturns, so what is found is the least of those tried. A run that is not decided
 * spares no block and ends the search, which is then not converged. */

#ifndef TP_OVERTURNING_H
#define TP_OVERTURNING_H

#include "shaking/shaking.h"
#include "tilt/trial.h"

/* A block at the tilt of its release, and the shaking of its base, `factor` times the scene's now;
 * the tilting's shaking is that, and its own->converged whether all runs were decided. */
typedef struct tp_overturning {
  tp_tilting *tilting;
  tp_base_shaking *shaking;
  double factor;
} tp_overturning;

/* Is it overturned (TP_VERDICT_MOVES), or spared (TP_VERDICT_STANDS)? */
TP_MUST_USE tp_status tp_overturning_look(tp_tilt_verdict *verdict, tp_overturning *overturning,
                                          double factor);

/* Two factors at which it was not the same, narrowed until they differ by less than `tolerance` of
 * the second: by halves, as long as runs are decided. `upper`: what became of it at the second. */
TP_MUST_USE tp_status tp_overturning_narrow(double between[2], tp_overturning *overturning,
                                            tp_tilt_verdict upper, double tolerance);

/* Of a scene: factors from 1/16 to 16 are tried upwards in steps of 2^(1/4), and the first that
 * overturns it and the one before it are narrowed to 1e-3. The shaking is the scene's again then.
 */
TP_MUST_USE tp_status tp_tilting_overturning(tp_tilting *tilting, tp_base_shaking *shaking);

#endif
