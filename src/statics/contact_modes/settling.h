/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What follows from the sets of a node at once: blocks that are at rest, contacts between these,
 * and modes that nogoods exclude. */

#ifndef TP_CONTACT_MODES_SETTLING_H
#define TP_CONTACT_MODES_SETTLING_H

#include "contact_modes/search_state.h"

/* False: nothing is left; then `refuted` is a refuted node that the state is part of. `work` grows
 * by what it took. */
bool tp_search_settle(tp_modes_node *refuted, long *work, tp_search_state *state,
                      tp_nogoods *nogoods);

#endif
