/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Where facets of another friction begin beside those of a contact. */

#ifndef TP_PROBLEM_FACET_BESIDES_H
#define TP_PROBLEM_FACET_BESIDES_H

#include "problem/facet_friction.h"

/* Fills in the `besides`, in the order of facets; all else of `friction` is known. Entries of the
 * scene whose facets the block does not touch are noted, with what their friction counts for. */
TP_MUST_USE tp_status tp_facet_besides_find(tp_facet_friction *friction, const tp_scene *scene,
                                            const tp_base *base, const tp_lattice *lattice,
                                            const tp_contact *contact, tp_notes *notes,
                                            tp_message *message);

#endif
