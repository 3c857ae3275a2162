/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Three numbers by contact; of a convex function of the pull the greatest value is at one of them.
 */

#include "contact_modes/bond_pull.h"

static const tp_near *bond_of(const tp_modes_question *q, int load, long contact) {
  return q->bond[load] + 2 * contact;
}

bool tp_bond_is_given(const tp_modes_question *q, long contact) {
  if (q->bond[0] == NULL || q->resting->contacts[contact].ends == 1) return false;
  bool given = false;
  for (int load = 0; load < q->load_count; load++) {
    const tp_near *bond = bond_of(q, load, contact);
    given = given || !tp_near_is_zero(bond[0]) || !tp_near_is_zero(bond[1]);
  }
  return given;
}

bool tp_bond_varies(const tp_modes_node *n, const tp_modes_question *q, long contact) {
  const tp_force_column *along = &q->resting->contacts[contact].along;
  if ((n->sets[contact] & TP_MODES_WHOLE) == 0 || !tp_bond_is_given(q, contact)) return false;
  return !(tp_modes_rests(n, along->row[0]) && tp_modes_rests(n, along->row[1]));
}

bool tp_bonds_differ(const tp_modes_question *q) {
  if (q->bond[0] == NULL || q->load_count == 1) return false;
  for (long k = 0; k < 2 * q->resting->contact_count; k++) {
    const tp_near one = q->bond[0][k], other = q->bond[1][k];
    if (one.value != other.value || one.error != other.error) return true;
  }
  return false;
}

void tp_bond_powers(double powers[TP_BOND_WAYS], const tp_near bond[2], const double u[2]) {
  powers[0] = bond[0].value * u[0] + bond[1].value * u[1];
  powers[1] = bond[1].value * (u[1] - u[0]);
  powers[2] = bond[0].value * (u[0] - u[1]);
}

tp_near tp_bond_power(const tp_modes_question *q, int load, long contact, const tp_near *y) {
  const tp_resting_contact *c = q->resting->contacts + contact;
  const tp_near *bond = bond_of(q, load, contact);
  const tp_near first = tp_resting_along(c->normal + 0, y);
  const tp_near second = tp_resting_along(c->normal + 1, y);
  const tp_near apart = tp_near_minus(second, first);
  const tp_near all = tp_near_plus(tp_near_times(bond[0], first), tp_near_times(bond[1], second));
  return tp_near_larger(all, tp_near_larger(tp_near_times(bond[1], apart),
                                            tp_near_times(bond[0], tp_near_neg(apart))));
}
