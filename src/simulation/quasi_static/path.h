/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The quasi-static path of a block on a table whose tilt rises slowly: from equilibrium to
 * equilibrium until none is left (docs/tilt_path.md).
 *
 * The block is rigid; every facet of its contact has normal springs that do not pull and shear
 * springs, per area, and slips by Coulomb's law, each facet as a whole. Displacements are small
 * against the block: the geometry is that of the start, and the balance exact to first order in
 * them. In this order displacements are inverse to the stiffness and angles do not depend on it,
 * but on the ratio of shear to normal stiffness alone, and on that only where the way to the
 * failure decides. What a finite stiffness adds (the weight moves as springs give) is told beside.
 *
 * Between events the states are solved for one by one, and not added up: an error at one tilt is
 * not carried to the next. At each the forces balance within `imbalance` of the weight. A tilt at
 * which no equilibrium is left is one from which the block, slowed by a drag in proportion to its
 * mass, moves off for good; the direction is then one in which a rigid block can begin to move from
 * rest (docs/onset.md), so that the collapse never lies below the onset, nor above the limit. */

#ifndef TP_QUASI_STATIC_PATH_H
#define TP_QUASI_STATIC_PATH_H

#include "rigid_body/history.h"

/* Stress locked in on a facet before the start: normal stress at its ends in the order of
 * tp_rigid_body.closed (linear between), and shear stress, above 0 where it pushes the block along
 * the facet's tangent. Where a normal stress is below 0 the joint is open; of a contact in a point
 * `to_pa` is not read. */
typedef struct tp_path_traction {
  double from_pa, to_pa, shear_pa;
} tp_path_traction;

typedef struct tp_path_settings {
  double normal_pa_m, shear_pa_m;    /* stiffness of the contact per area */
  double from_angle, to_angle;       /* of the table, radians: set down at the first, tilted to the
                                        other, not below it, below a quarter of a turn */
  double tolerance;                  /* of the angles of events and of the collapse, radians */
  double moments_every;              /* of the history, radians; 0: at events alone */
  double point_length_m;             /* that a contact in a point stands for; 0: the extent / 100 */
  bool weight_moves;                 /* with the block: the collapse for these very springs; false:
                                        in the limit of stiff ones */
  bool asks_softening;               /* both, see tp_path_result.softening */
  long most_events;                  /* and jumps: the run is undecided after as many */
  const tp_path_traction *tractions; /* by facet and point of the contact; NULL: none */
  bool (*stop)(void *context);       /* as of tp_run; NULL: nothing stops it */
  void *context;
} tp_path_settings;

/* Stiffnesses of the paper's section 4.3, from level to 89.9 degrees, within 1e-6 degrees. */
tp_path_settings tp_path_settings_default(void);

/* How the block begins to move. */
typedef struct tp_path_motion {
  tp_mechanism mechanism; /* TP_SLIDES, TP_TOPPLES, TP_SLIDES_AND_TOPPLES, TP_LEAVES_BASE */
  tp_xy direction;        /* of the centroid, and */
  double turning_m;       /* its turning times the block's extent: together of length 1 */
  bool has_centre;
  tp_xy centre; /* of rotation, metres from the centroid: where it topples, of the contact */
} tp_path_motion;

typedef struct tp_path_result {
  tp_run_end end;        /* TP_RUN_STANDS: up to the last angle; TP_RUN_MOVES: it collapses;
                            TP_RUN_UNDECIDED, TP_RUN_NO_MEMORY */
  bool stood;            /* there is an equilibrium at the first angle */
  double stands_to;      /* the last angle with an equilibrium, radians; of none the first one */
  double collapses_at;   /* the least angle found without one */
  tp_path_motion motion; /* where it collapses */
  double imbalance;   /* of forces, at most, over the weight; of moments over weight times extent */
  double closure_m;   /* by which the weight closes the whole contact on the average */
  double moved_m;     /* largest displacement of a contact in the last equilibrium; without bound
                         towards a tilt at which the block topples, where the weight does not move */
  bool has_softening; /* with asks_softening, where it collapses: */
  double softening;   /* radians by which it would collapse sooner on these very springs */
  long jumps;         /* times that it gave way and came to rest at the same tilt */
  double first_jump;  /* the angle of the first */
  long events, solves; /* what it took */
} tp_path_result;

/* Bad input where a setting is none, or where the springs are so soft that the displacements are
 * not small: the message says what would do. `history` may be NULL; what it holds is added to. */
TP_MUST_USE tp_status tp_path_run(tp_path_result *result, const tp_rigid_body *body,
                                  const tp_path_settings *settings, tp_history *history,
                                  tp_message *message);

#endif
