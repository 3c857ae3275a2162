/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Ways out from the scene's values, and the scene at other values of its symbols. */

#ifndef TP_DERIVE_CHECK_WALK_H
#define TP_DERIVE_CHECK_WALK_H

#include "derive/conditions.h"
#include "derive/model.h"

/* A formula and what it is of. */
typedef struct tp_checked_formula {
  const tp_model *model;
  tp_direction towards;
  bool onset;                         /* of the onset of motion; else of the static limit */
  long friction;                      /* the symbol tan(phi) */
  const fmpz_mpoly_q_struct *tangent; /* of the angle */
  const tp_conditions *conditions;
} tp_checked_formula;

/* Numbers that a walk changes: with more the first ones. A text holds a double with its exponent.
 */
enum { TP_WALK_SYMBOLS = 12, TP_WALK_TEXT = 32 };

/* A number of the scene that is a symbol of the formula. */
typedef struct tp_walk_number {
  const char *key;     /* as the scene calls it */
  const tp_node *node; /* where it stands there */
  long symbol;
  bool is_friction; /* in degrees; its symbol is tan(phi) */
  double own;       /* the scene's value */
} tp_walk_number;

typedef struct tp_walk {
  const tp_checked_formula *formula;
  size_t count;
  tp_walk_number numbers[TP_WALK_SYMBOLS];
} tp_walk;

/* By how far each number goes, in logarithms where all are above zero. */
typedef struct tp_walk_direction {
  double of[TP_WALK_SYMBOLS];
} tp_walk_direction;

/* Values of all numbers as the scene is given them, and of all symbols. */
typedef struct tp_walk_point {
  char texts[TP_WALK_SYMBOLS][TP_WALK_TEXT]; /* empty: as the scene has it */
  arb_ptr values;
} tp_walk_point;

TP_MUST_USE tp_status tp_walk_init(tp_walk *walk, const tp_checked_formula *formula,
                                   tp_message *message);

void tp_walk_point_init(tp_walk_point *point, const tp_walk *walk);
void tp_walk_point_clear(tp_walk_point *point, const tp_walk *walk);

/* The values at a distance in a direction; false where a number leaves its range. */
bool tp_walk_go(tp_walk_point *point, const tp_walk *walk, const tp_walk_direction *direction,
                double distance);

/* The first condition from `from` on that does not hold there, certainly, or -1. */
long tp_walk_fails(const tp_walk *walk, const tp_walk_point *point, long from);
/* Do all hold, certainly? */
bool tp_walk_holds(const tp_walk *walk, const tp_walk_point *point);

/* What the solver says there, beside the formula; fails when memory is exhausted. */
TP_MUST_USE tp_status tp_walk_solve(tp_check_verdict *verdict, const tp_walk *walk,
                                    const tp_walk_point *point, tp_message *message);

/* "c = 7.41, friction_angle_deg = 44": what differs from the scene; NULL when memory is exhausted.
 */
char *tp_walk_write(const tp_walk *walk, const tp_walk_point *point);

#endif
