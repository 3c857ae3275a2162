/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The factor of safety by strength reduction: by how much tan(phi), cohesion and bond may be
 * divided until the limit comes down to a given tilt.
 *
 * The limit falls with the strength, so two factors with proven limits on either side of the tilt
 * enclose it. */

#ifndef TP_REDUCTION_H
#define TP_REDUCTION_H

#include "limit/limit.h"

typedef enum tp_reduction_kind {
  TP_REDUCTION_FACTOR,
  TP_REDUCTION_UNBOUNDED, /* it stands at the tilt without any strength */
  TP_REDUCTION_NONE       /* no strength would hold it there */
} tp_reduction_kind;

/* The question's cones are scaled for it and left as they were. `degrees` is the tilt; `factor` is
 * known to 10^-digits of its size. */
tp_limit_outcome tp_reduction_find(tp_reduction_kind *kind, arb_t factor,
                                   const tp_limit_question *question, tp_cones *cones,
                                   const arb_t degrees, int digits);

#endif
