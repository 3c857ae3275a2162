/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Newton's law for blocks of which each contact has one mode, as linear equations:
 *
 *     M Z q - A f = w
 *
 * with Z the accelerations that closed ends and sticking allow, exactly (contact_modes/
 * rigid_groups.h), q their shares, and f a normal force an end that is closed, with friction of its
 * own where it slips, and a shear force a contact that sticks. Rows are about centroids. */

#ifndef TP_CONTACT_MODES_MODE_EQUATIONS_H
#define TP_CONTACT_MODES_MODE_EQUATIONS_H

#include "contact_modes/trial_mode.h"

#include <arb_mat.h>

enum { TP_EQUATION_BITS = 192 };

typedef struct tp_mode_equations {
  const tp_beginning_question *question;
  const tp_rigid_groups *groups;
  const tp_trial_mode *trial;
  long count;                 /* of the columns: shares first, then forces */
  long *normal_at, *shear_at; /* 2 and 1 a contact: columns of its forces; -1: it has none */
  arb_mat_t columns, right, factors;
  double *preference;
} tp_mode_equations;

/* All but `question`, `groups` and `trial`, which are given. Factors begin as the forces
 * of the question. On failure cleared. */
TP_MUST_USE tp_status tp_mode_equations_init(tp_mode_equations *equations, tp_message *message);
void tp_mode_equations_clear(tp_mode_equations *equations);

/* Which way a contact's friction acts against a slip: 1 forward, -1 back; 0: it does not slip. */
int tp_trial_slip(const tp_trial_mode *trial);

/* a of a block in one free acceleration, in units of the assemblage, over 2^scale. */
void tp_mode_acceleration(arb_struct a[3], const tp_mode_equations *equations, long block,
                          long share);

#endif
