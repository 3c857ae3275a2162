/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Proofs that are known of other loads and of other friction, proven of those at hand. */

#ifndef TP_CONTACT_MODES_RENEWING_H
#define TP_CONTACT_MODES_RENEWING_H

#include "contact_modes/known_proofs.h"
#include "contact_modes/refutation.h"

/* What they refute of motions with these blocks at rest, as nogoods. `work` grows by what it took;
 * none is asked where it is above `most_work`. `room` is a node. */
TP_MUST_USE tp_status tp_known_proofs_renew(tp_known_proofs *known, tp_nogoods *nogoods,
                                            tp_modes_node *room, long *work, long most_work,
                                            const tp_modes_question *question, const bool *still,
                                            tp_message *message);

#endif
