/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* No other block is accelerated by the reaction, so that a row of a contact meets one of the two at
 * most on each of its sides. */

#include "contact_modes/pushed.h"

tp_pushed tp_pushed_by(const tp_bearing_reaction *own, const tp_modes_node *n,
                       const tp_resting *r) {
  tp_pushed p = {.row = {-1, -1}};
  for (int side = 0; side < 2; side++) {
    const long row = own->column->row[side];
    if (tp_modes_rests(n, row)) continue;
    double wrench[3];
    for (int e = 0; e < 3; e++) wrench[e] = own->sign * own->column->entry[side][e].value;
    p.row[side] = row;
    tp_resting_accelerate_double(p.y[side], r->assemblage->blocks + r->block[row / 3], wrench);
  }
  return p;
}

double tp_pushed_along(const tp_pushed *p, const tp_force_column *c) {
  double sum = 0;
  for (int side = 0; side < 2; side++) {
    for (int own = 0; own < 2 && c->row[side] >= 0; own++) {
      if (p->row[own] != c->row[side]) continue;
      for (int e = 0; e < 3; e++) sum += c->entry[side][e].value * p->y[own][e];
    }
  }
  return sum;
}

double tp_pushed_power(const tp_pushed *p, const tp_near *loads) {
  double sum = 0;
  for (int own = 0; own < 2; own++) {
    for (int e = 0; e < 3 && p->row[own] >= 0; e++)
      sum += loads[p->row[own] + e].value * p->y[own][e];
  }
  return sum;
}
