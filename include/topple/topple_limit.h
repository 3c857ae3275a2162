/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The static limit of a case. Included by topple.h. */

#ifndef TOPPLE_LIMIT_H
#define TOPPLE_LIMIT_H

#include "topple_basics.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The static limit (limit analysis with Coulomb friction on the contact facets): beyond it no
 * forces of the base hold the block; below it some do. */
typedef enum tp_limit_kind {
  TP_LIMIT_NOT_ASKED, /* the scene gives no friction angle */
  TP_LIMIT_AT_ANGLE,
  TP_LIMIT_INTERLOCKED, /* forces hold it at every tilt up to 90 degrees */
  TP_LIMIT_NOWHERE,     /* no forces hold it at any tilt, or at single ones alone */
  TP_LIMIT_UNDECIDED    /* at the precision allowed */
} tp_limit_kind;

/* A force of the base on the block at the limit, as a share of the block's weight: along an edge of
 * the friction cone at an end of a facet. */
typedef struct tp_reaction {
  tp_bounded x_m, y_m;         /* where it acts */
  tp_bounded share_x, share_y; /* of the weight, along x and y of the scene */
  bool of_facet;     /* false: of a base that extends past the toe, where the scene's ends */
  size_t facet;      /* from left to right along the contact, those in a point included */
  bool at_right_end; /* of the facet */
  bool against_slip; /* friction acts up-dip; else down-dip */
} tp_reaction;

/* The limit of a case on one base (mechanics.md, section 6). */
typedef struct tp_limit {
  tp_limit_kind kind; /* is it at an angle? */
  bool too_dear; /* undecided, it or its factor, since the proof takes more work than is allowed */
  tp_bounded
      friction_angle_deg; /* if kind != TP_LIMIT_NOT_ASKED: at the normal stress of the limit */
  tp_bounded critical_angle_deg; /* if kind == TP_LIMIT_AT_ANGLE: below 0: it does not even hold on
                                    level ground */
  tp_mechanism mechanism;        /* TP_SLIDES, TP_TOPPLES, TP_SLIDES_AND_TOPPLES, TP_INTERLOCKED */
  bool tie;                      /* another mechanism has the same limit: */
  tp_mechanism tied_with;        /* if tie: that one */
  long tie_bits;     /* 0: exactly; else half of so many bits do not distinguish the two */
  bool turns_up_dip; /* against the sense of toppling */
  bool has_centre;   /* of rotation */
  tp_bounded centre_x_m, centre_y_m; /* where it is: a contact point where it topples */
  bool has_facet;                    /* along which it slides */
  tp_bounded facet_x0_m, facet_y0_m, facet_x1_m, facet_y1_m; /* if has_facet: its two ends */
  size_t reaction_count;                                     /* 1 or 2; 0 where there is no angle */
  tp_reaction reactions[2]; /* of the base, which hold the block at the limit, on the verge */
  tp_fos fos; /* by strength reduction: the divisor of tan(phi), cohesion and bond with which forces
                 just hold it at the scene's tilt */
  tp_mechanism fos_mechanism; /* what happens there; TP_MECHANISM_UNDECIDED where there is no fos */
  bool base_beyond_toe;       /* of the base that this is the limit for: it extends past the toe */
} tp_limit;

/* Forces on the block over its weight, along x and y of the scene, and their moment about the
 * centroid of the weight over the weight, counter-clockwise positive. */
typedef struct tp_wrench_share {
  tp_bounded share_x, share_y; /* along x and y */
  tp_bounded moment_m;         /* about the centroid, in metres */
} tp_wrench_share;

/* All that acts on the block at the limit: with the reactions it cancels. */
typedef struct tp_limit_balance {
  bool known;               /* there is a limit at an angle: */
  tp_wrench_share applied;  /* if known: the weight and all loads at that tilt */
  tp_wrench_share strength; /* if known: cohesion and bonds that are used up, beside the reactions
                             */
  tp_wrench_share sum;      /* if known: of these and of the reactions: 0 within its bound */
} tp_limit_balance;

#ifdef __cplusplus
}
#endif

#endif
