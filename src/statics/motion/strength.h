/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Cohesion and bonds in the modes of motion: what a mode has to overcome beside friction.
 *
 * By Mohr and Coulomb's law what slips is sheared against its slip by all of its cohesion. All
 * facets on one straight line slip alike, so that where a point of the line stays closed its
 * cohesion is that of all of them, however many pieces they are written in: against the slip, or,
 * where the point sticks, anything up to it either way. A facet whose middle opens is pulled there
 * by all of its bond; one that slides in one piece by any share of it, and more than all would do
 * no harm: a pull adds friction, so that the slide begins without. So the loads w at which a mode
 * can begin are those of friction alone (motion/bounds.h) less what is fixed, plus what may be
 * anything within its bounds, plus the pulls of slides. */

#ifndef TP_MOTION_STRENGTH_H
#define TP_MOTION_STRENGTH_H

#include "motion/mode.h"
#include "motion/question.h"

/* Lines that may stick at once, beyond which a mode is too dear; along one axis slide two families
 * at most, that face each other, with two ends each. */
enum { TP_STRENGTH_FREE = 16, TP_STRENGTH_PULLS = 4 };

typedef struct tp_strength {
  tp_vector fixed;          /* on the block, */
  tp_vector cohesion, bond; /* the sum of these: of lines that slip, of facets that open */
  arb_t most_pull;          /* all bonds of facets that slide in one piece (tp_strength_add_pull) */
  long free_count;
  tp_vector free[TP_STRENGTH_FREE];           /* times anything from -1 to 1, */
  long sticks[TP_STRENGTH_FREE];              /* each for a point that sticks */
  long pull_count, pulled[TP_STRENGTH_PULLS]; /* at points of the cones */
  tp_vector pulls[TP_STRENGTH_PULLS]; /* turned round, times anything above zero, as M r and -e */
  /* of all modes alike: */
  long *capacity_of; /* by point: that of which it is the first end, or -1 */
  tp_vector bonds;   /* all of them, as pulls on the block */
} tp_strength;

void tp_strength_init(tp_strength *strength);
void tp_strength_clear(tp_strength *strength);
/* All forces over another one. */
void tp_strength_divide(tp_strength *strength, const arb_t force, long bits);

/* Of one mode, in the question's units; all that are put into one `strength` are of one question.
 * What slides costs as much as there are facets; what turns, as there are of the directions of its
 * closed contacts. */
TP_MUST_USE tp_motion_outcome tp_strength_find(tp_strength *strength,
                                               const tp_motion_question *question,
                                               const tp_normals *normals, const tp_twists *twists,
                                               const tp_mode *mode);

/* Adds a factor on t of a point in units of the least whole numbers along t, the same for all
 * facets of one direction. */
void tp_strength_add_pull(arb_t sum, const arb_t factor, const tp_motion_question *question,
                          long point);

/* What cohesion and bonds do is the same in modes of one number, as far as planes of a ray and an
 * edge in common tell: those whose closed contacts lie on one straight line have that of the line,
 * from 1 on; any other 0. Without cohesion all that turn, or open all, have 1, and share all
 * planes: all bonds hold them (tp_strength_bonds_alone). Where the line sticks in one mode and
 * slips in another, such a plane has what holds on the side of the slip. */
TP_MUST_USE tp_motion_outcome tp_strength_number(long *number, const tp_motion_question *question,
                                                 const tp_normals *normals, const tp_twists *twists,
                                                 const tp_mode *mode);

/* Is there no cohesion on any line? */
bool tp_strength_bonds_alone(const tp_motion_question *question);

#endif
