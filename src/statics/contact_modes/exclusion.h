/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Is every motion of blocks at rest excluded? By branch and bound over what contacts do: sets of
 * modes are divided until each is refuted (contact_modes/refutation.h), from the ground on. */

#ifndef TP_CONTACT_MODES_EXCLUSION_H
#define TP_CONTACT_MODES_EXCLUSION_H

#include "contact_modes/known_proofs.h"

typedef struct tp_exclusion {
  bool is_proven; /* no motion can begin */
  bool has_left;  /* else: one combination of modes is left, `left` */
  long work;      /* so far, in entries of linear programs; an exclusion ends unproven where it is
                     above `most_work` */
  long most_work;
  tp_mode_set *left;      /* by contact, of the caller */
  tp_known_proofs *known; /* of exclusions before, to which this one adds its own; or NULL */
} tp_exclusion;

TP_MUST_USE tp_status tp_exclusion_find(tp_exclusion *exclusion, const tp_modes_question *question,
                                        tp_message *message);

/* Are the blocks in equilibrium without any friction? Then none can begin, whatever strength joints
 * have; the question needs no friction. */
TP_MUST_USE tp_status tp_exclusion_frictionless(bool *proven, long *work,
                                                const tp_modes_question *question,
                                                tp_message *message);

#endif
