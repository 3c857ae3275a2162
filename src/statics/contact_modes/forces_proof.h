/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A proof by forces (contact_modes/refutation.h), evaluated with bounds from its reactions c and
 * its share s of the loads: whatever these are, y = M^-1 (A c + s w) is theirs, so that they may be
 * of another question. Of loads between two, w . y and e . y are greatest at one of both. */

#ifndef TP_CONTACT_MODES_FORCES_PROOF_H
#define TP_CONTACT_MODES_FORCES_PROOF_H

#include "contact_modes/reactions.h"

typedef struct tp_forces_proof {
  const tp_modes_node *node; /* which blocks rest; what joints with cohesion or bonds may do */
  const tp_modes_question *question;
  const tp_bearing_reactions *reactions;
  const double *factors; /* by reaction */
  double share;
  tp_near *wrenches, *y; /* room, by row; y of blocks that rest is 0 */
} tp_forces_proof;

/* Sets y, with this load; is w . y + C (t . y) < 0 for all that cohesion may be, and
 * with all pulls of bonds? */
bool tp_forces_proof_drives(tp_forces_proof *proof, int load);

/* Takes from a refuted node the modes in which the reactions do work, or forces resist y. */
void tp_forces_proof_widen(tp_modes_node *refuted, const tp_forces_proof *proof);

#endif
