/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The linear program of forces between blocks (Livesley 1978):
 *
 *     maximise s subject to  A f + w0 + s w1 = 0,  f >= 0.
 *
 * Three rows a free block: force in x, in y and moment about its own point. Four columns a contact
 * of edges, two a corner: at each end the two edges n + t tan(phi) and n - t tan(phi) of the
 * friction cone, pushing the first block to its left and the second one back. Tensile strength
 * moves the apex of the cone of both ends by half its force, which is part of w0; and cohesion is a
 * column more, along t, from 0 to twice its force, of which w0 has the half back. Loads other than
 * weights are part of w0 too. All entries are enclosed. */

#ifndef TP_ASSEMBLAGE_FORCE_PROGRAM_H
#define TP_ASSEMBLAGE_FORCE_PROGRAM_H

#include "assemblage/contact_frame.h"

/* Of a contact, over its length, in units of force over length of the assemblage: N >= -tension and
 * |T| <= cohesion + (N + tension) tangent, as of a bond in statics of one block. */
typedef struct tp_contact_strength {
  tp_near tangent, cohesion, tension;
} tp_contact_strength;

/* What else acts on a row: always, and times the two parts of the direction of gravity, which turns
 * as all is tilted. */
typedef struct tp_applied_load {
  tp_near steady, down[2];
} tp_applied_load;

/* What acts on a weight of one: always, and times s; and what else acts. */
typedef struct tp_weight_loads {
  tp_near dead[2], live[2];
  tp_near down[2];                /* the direction of gravity */
  const tp_applied_load *applied; /* borrowed, by row; NULL: nothing */
  const tp_near *push;            /* borrowed, by row: times s besides; NULL: nothing */
} tp_weight_loads;

/* The least load s that is looked for: 45 degrees to the other side. */
#define TP_LEAST_LOAD (-1.0)

typedef struct tp_force_program {
  const tp_assemblage *assemblage;
  long rows, count;
  long *block;              /* by number of a free block: which it is */
  tp_force_column *columns; /* those of one contact follow each other */
  long *first;              /* by contact, and `count` at the end; cones before cohesion; of some
                               programs a contact has none */
  tp_near *dead, *live;     /* w0 and w1, by row */
} tp_force_program;

/* Weights act downwards (-y) and s times the weights towards -x, or towards x: by s = tan(tilt) all
 * is tilted to that side, or s is a pseudo-static coefficient. */
tp_weight_loads tp_weight_loads_tilted(bool towards_left);

/* `strengths` are by contact. On failure `program` is cleared. */
TP_MUST_USE tp_status tp_force_program_init(tp_force_program *program,
                                            const tp_assemblage *assemblage,
                                            const tp_contact_strength *strengths,
                                            const tp_weight_loads *loads, tp_message *message);
void tp_force_program_clear(tp_force_program *program);

/* The work of the force of one column on twists by row, in doubles. */
double tp_force_column_work(const tp_force_column *column, const double *twists);

#endif
