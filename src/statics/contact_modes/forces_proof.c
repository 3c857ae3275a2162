/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* With s >= 0 and the cohesion of the whole question at each of two loads, s w . M^-1 w + C (t . y)
 * is convex in w, so that of loads between two it is greatest at one of both. So it is with bonds
 * of one size. Where these differ the loads do too, and s has to be 0: y is one then, and the power
 * is convex in bonds and loads together. */

#include "contact_modes/forces_proof.h"

#include "contact_modes/bond_pull.h"
#include "contact_modes/cohesive_shear.h"
#include "contact_modes/refuted_node.h"

static void find_y(tp_forces_proof *p, int load) {
  const tp_resting *r = p->question->resting;
  for (long k = 0; k < r->rows; k++) {
    p->wrenches[k] = tp_near_times((tp_near){p->share, 0}, p->question->loads[load][k]);
  }
  for (long k = 0; k < p->reactions->count; k++) {
    const tp_bearing_reaction *own = p->reactions->all + k;
    const tp_near factor = {own->sign * p->factors[k], 0};
    for (int side = 0; side < 2; side++) {
      const long row = own->column->row[side];
      for (int e = 0; e < 3 && !tp_modes_rests(p->node, row); e++) {
        p->wrenches[row + e] =
            tp_near_plus(p->wrenches[row + e], tp_near_times(factor, own->column->entry[side][e]));
      }
    }
  }
  for (long b = 0; b < r->rows / 3; b++) {
    tp_near *y = p->y + 3 * b;
    const tp_near *wrench = p->wrenches + 3 * b;
    y[0] = y[1] = y[2] = (tp_near){0, 0};
    const bool is_pushed =
        !tp_near_is_zero(wrench[0]) || !tp_near_is_zero(wrench[1]) || !tp_near_is_zero(wrench[2]);
    if (p->node->still[b] || !is_pushed) continue;
    tp_resting_accelerate(y, r->assemblage->blocks + r->block[b], p->wrenches + 3 * b);
  }
}

static tp_near cohesive_power(const tp_forces_proof *p, long contact) {
  const tp_force_column *along = &p->question->resting->contacts[contact].along;
  const tp_near none = {0, 0};
  if (tp_near_is_zero(p->question->cohesion[1][contact])) return none;
  if (tp_modes_rests(p->node, along->row[0]) && tp_modes_rests(p->node, along->row[1])) return none;
  const tp_cohesive_shear own = tp_cohesive_shear_of(p->node, p->question, contact);
  const tp_near slip = tp_resting_along(along, p->y);
  return tp_near_larger(tp_near_times(own.least, slip), tp_near_times(own.most, slip));
}

bool tp_forces_proof_drives(tp_forces_proof *p, int load) {
  const tp_resting *r = p->question->resting;
  tp_near power = {0, 0};
  if (p->share != 0 && tp_bonds_differ(p->question)) return false;
  find_y(p, load);
  for (long k = 0; k < r->contact_count; k++) {
    power = tp_near_plus(power, cohesive_power(p, k));
    if (!tp_bond_varies(p->node, p->question, k)) continue;
    power = tp_near_plus(power, tp_bond_power(p->question, load, k, p->y));
  }
  for (long k = 0; k < r->rows; k++) {
    power = tp_near_plus(power, tp_near_times(p->question->loads[load][k], p->y[k]));
  }
  return tp_near_sign(power) < 0;
}

void tp_forces_proof_widen(tp_modes_node *refuted, const tp_forces_proof *p) {
  for (long k = 0; k < p->reactions->count; k++) {
    const double factor = p->factors[k];
    const tp_factor_sign sign = factor > 0   ? TP_FACTOR_POSITIVE
                                : factor < 0 ? TP_FACTOR_NEGATIVE
                                             : TP_FACTOR_NONE;
    tp_refuted_node_bears(refuted, p->question->resting, p->reactions->all + k, sign);
  }
  tp_refuted_node_yields(refuted, p->node, p->question, p->y);
}
