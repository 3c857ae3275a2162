/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The factor of safety that governs a case. Included by topple.h.
 *
 * There are two factors of the onset of motion (topple_onset.h), each the greatest up to which no
 * motion can begin: on driving loads, by which the loads that drive the block are multiplied, and
 * by strength reduction, by which all strength is divided. The lesser governs. It is below 1
 * exactly where a motion can begin at the scene's tilt, and passes 1 without a leap. Of a block
 * that moves the factor by strength counts only where strength decides when the motion begins.
 *
 * The formulas of the field, moments about a pivot (Eq. 2) and shear strength over shear force, are
 * those two factors of one mechanism. They are listed, and count where that mechanism is the one
 * that begins; else contact forces or other mechanisms prevent it. */

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
  TP_FOS_BY_REDUCTION, /* the divisor of all strength at which a motion can just begin, or, where
                          more strength lets one begin, its multiple: tp_onset.fos */
  TP_FOS_BY_DRIVING    /* the multiple of the driving loads at which a motion can just begin:
                          tp_onset.fos_driving, topple_block_system.h */
} tp_fos_definition;

/* moments, shear strength, shear strength with roughness, strength reduction, or driving loads. */
const char *tp_fos_definition_name(tp_fos_definition definition);

/* Does the factor of a way count? */
typedef enum tp_factor_standing {
  TP_FACTOR_COUNTS,
  TP_FACTOR_BLOCKED,   /* no: this motion is blocked by a facet */
  TP_FACTOR_PREVENTED, /* no: another motion begins before this one, which is no factor of the onset
                        */
  TP_FACTOR_UNEVEN,    /* no: facets along which it would slide differ in friction, and how they
                          share the load is not given; by strength they count as they are */
  TP_FACTOR_SMOOTH,    /* no: there is no shear strength to divide */
  TP_FACTOR_UNAFFECTED /* no: a change of strength does not decide when the motion begins */
} tp_factor_standing;

/* counts, blocked, prevented, uneven, smooth or unaffected. */
const char *tp_factor_standing_name(tp_factor_standing standing);

/* The factor against one way to move. */
typedef struct tp_factor {
  tp_fos_definition definition; /* by which it is defined */
  tp_mechanism mechanism;       /* against which: the motion with which it begins */
  size_t pivot;                 /* if definition == TP_FOS_BY_MOMENTS: the pivot's index */
  bool toe;                     /* it is the end of the contact down-dip */
  bool counts;                  /* false: it is shown for comparison, as `standing` says */
  tp_fos fos;                   /* the factor itself */
  tp_factor_standing standing;  /* why it counts, or not */
  bool raised; /* by strength: more of it lets a motion begin, or less would stop it */
} tp_factor;

/* How many there are. Of one block there is one by each at most, and one by moments that does not
 * count. */
enum { TP_FOS_DEFINITIONS = 5, TP_FACTORS_MAX = 6 };

/* Has a case the factor of safety that is required? Open: undecided. */
typedef enum tp_design { TP_DESIGN_MET, TP_DESIGN_NOT_MET, TP_DESIGN_OPEN } tp_design;

/* The factor that governs, and those that it is the least of. */
typedef struct tp_governing_fos {
  tp_fos fos;           /* TP_FOS_UNDEFINED: it does not stand at all */
  bool has_factor;      /* it is that of one of the factors */
  size_t factor;        /* if has_factor: the index of that one */
  bool has_utilisation; /* `fos` is a number certainly above 0, and complete: */
  tp_bounded
      utilisation; /* 1 / FoS, the share of the resistance that is used; above 1 the block moves */
  bool has_required_fos;       /* the scene gives one: */
  tp_bounded required_fos;     /* that it asks of every case */
  tp_design meets_required;    /* if has_required_fos: has the case it certainly (tp_case_meets)? */
  bool has_design_utilisation; /* both are there: */
  tp_bounded design_utilisation; /* required_fos / FoS, at most 1 where it is met; with partial
                                    factors E_d / R_d */
  bool tie;    /* one against another mechanism is the same, as far as their bounds decide */
  bool up_dip; /* none: at this tilt it fails up-dip */
  bool beyond; /* none: it fails at a lower tilt, though forces would hold it at this one */
  bool sliding_judged; /* false: the scene gives no friction angle */
  bool complete;       /* every way is judged and decided; false: `fos` is an upper bound */
  size_t factor_count; /* of those that are known */
  tp_factor factors[TP_FACTORS_MAX]; /* those that there are */
  double at_least, at_most; /* proven bounds of the factor, also where `fos` is undecided: 0 and
                         infinite where nothing is known, both infinite where it is unbounded */
} tp_governing_fos;

#ifdef __cplusplus
}
#endif

#endif
