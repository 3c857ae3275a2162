/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The pull of a tensile bond as a motion begins with modes of a node (docs/onset.md, "Cohesion and
 * bonds").
 *
 * A contact that opens at an end pulls with all of its bond, at its middle: that pull is part of
 * the loads w. One that stays closed at both ends pulls by any share of its bond, anywhere along
 * it, or not at all. So its pull differs from that in w by one of
 *
 *     b0 n0 + b1 n1,    b1 (n1 - n0),    b0 (n0 - n1)
 *
 * or by something between these, with b0 n0 + b1 n1 = the whole bond at its middle, n0 and n1 the
 * normals at its ends. Where both ends stay closed none of this does work. */

#ifndef TP_CONTACT_MODES_BOND_PULL_H
#define TP_CONTACT_MODES_BOND_PULL_H

#include "contact_modes/node.h"

enum { TP_MODES_WHOLE = TP_MODES_FIRST_CLOSED & TP_MODES_SECOND_CLOSED, TP_BOND_WAYS = 3 };

/* Has a contact a bond, by any of the loads of the question? */
bool tp_bond_is_given(const tp_modes_question *question, long contact);

/* May its pull differ from that in the loads: can it stay closed at both ends, between blocks that
 * are not both at rest? */
bool tp_bond_varies(const tp_modes_node *node, const tp_modes_question *question, long contact);

/* Do bonds differ from one load of the question to the other? */
bool tp_bonds_differ(const tp_modes_question *question);

/* The power of each difference from `bond`, b0 and b1, with u, the openings at both ends; one of
 * them is not below zero. */
void tp_bond_powers(double powers[TP_BOND_WAYS], const tp_near bond[2], const double u[2]);

/* The greatest power of these with accelerations y, by row, under a load of the question. */
tp_near tp_bond_power(const tp_modes_question *question, int load, long contact, const tp_near *y);

#endif
