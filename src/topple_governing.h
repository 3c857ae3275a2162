/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The factor of safety that governs a case: the least over the ways in which the block can move,
 * each by the definition that its way has in practice. Included by topple.h.
 *
 * Where it turns about a point, moments; where it slides, shear strength. The two agree on what
 * fails (both are 1 at the limit of their way) and on nothing else: a slender column has a factor
 * of 2 against toppling and of 70 against sliding. The least of them governs. */

#ifndef TOPPLE_GOVERNING_H
#define TOPPLE_GOVERNING_H

#include "topple_basics.h"

#ifdef __cplusplus
extern "C" {
#endif

/* How a factor of safety is defined. */
typedef enum tp_fos_definition {
  TP_FOS_BY_MOMENTS,   /* what stabilises over what overturns, about a pivot (Eq. 2) */
  TP_FOS_BY_SHEAR,     /* shear strength over shear force along the facet that slides:
                          tan(phi) / tan(tilt - i) for the weight alone */
  TP_FOS_BY_ROUGHNESS, /* on the mean plane, with phi + i for its strength (Eq. 6):
                          tan(phi + i) / tan(tilt) */
  TP_FOS_BY_REDUCTION  /* the divisor of all shear strength at which contact forces just hold it */
} tp_fos_definition;

/* moments, shear strength, shear strength with roughness, or strength reduction. */
const char *tp_fos_definition_name(tp_fos_definition definition);

/* The factor against one way to move. */
typedef struct tp_factor {
  tp_fos_definition definition; /* by which it is reckoned */
  tp_mechanism mechanism; /* against which; by reduction, what happens at the strength reduced */
  size_t pivot;           /* by moments: of the case's */
  bool toe;               /* it is the end of the contact down-dip */
  bool counts; /* false: the contact stands in the way of this motion, shown for comparison */
  tp_fos fos;  /* the factor itself */
} tp_factor;

/* One by each definition, at most. */
enum { TP_FACTORS_MAX = 4 };

/* The factor that governs, and those that it is the least of. */
typedef struct tp_governing_fos {
  tp_fos fos;      /* the least of those that count; TP_FOS_UNDEFINED: it does not stand at all */
  bool has_factor; /* it is that of ... */
  size_t factor;   /* ... this one of the factors */
  bool tie;        /* one against another mechanism is the same, as far as their bounds tell */
  bool up_dip;     /* none: at this tilt it lets go up-dip */
  bool beyond;     /* none: it lets go at a lesser tilt, though forces would hold it at this one */
  bool sliding_judged; /* false: the scene gives no friction angle */
  bool complete;       /* every way is judged and decided; false: `fos` is an upper bound */
  size_t factor_count; /* of those that are known */
  tp_factor factors[TP_FACTORS_MAX]; /* those that there are */
} tp_governing_fos;

#ifdef __cplusplus
}
#endif

#endif
