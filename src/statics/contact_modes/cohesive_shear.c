/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Two blocks slip alike along a line, and cohesion acts along all of it while a point of it is
 * closed: so each piece of a joint has what all of them allow together. */

#include "contact_modes/cohesive_shear.h"

#include <math.h>

/* How a line may slip, a bit each; 0: a piece has no such mode. */
enum { STICKS = 1, FORWARD = 2, BACK = 4, ANY = STICKS | FORWARD | BACK };

static unsigned slips_of(tp_mode_set set) {
  return ((set & TP_MODES_STICK) != 0 ? STICKS : 0) |
         ((set & TP_MODES_FORWARD) != 0 ? FORWARD : 0) | ((set & TP_MODES_BACK) != 0 ? BACK : 0);
}

/* As all pieces that are certainly closed do; where none is, as any does. */
static unsigned slips_of_line(bool *opens, const tp_modes_node *n, const tp_resting *r, long line) {
  unsigned of_closed = ANY, of_any = 0;
  *opens = true;
  for (long k = line; k < r->contact_count; k++) {
    if (r->contacts[k].line != line) continue;
    const unsigned own = slips_of(n->sets[k]);
    of_any |= own;
    if ((n->sets[k] & TP_MODES_OPEN) != 0) continue;
    of_closed &= own;
    *opens = false;
  }
  return *opens ? of_any : of_closed;
}

static void take(tp_cohesive_shear *s, tp_near shear) {
  if (shear.value - shear.error < s->least.value - s->least.error) s->least = shear;
  if (shear.value + shear.error > s->most.value + s->most.error) s->most = shear;
}

tp_cohesive_shear tp_cohesive_shear_of(const tp_modes_node *n, const tp_modes_question *q,
                                       long contact) {
  const tp_near least = q->cohesion[0][contact], most = q->cohesion[1][contact], none = {0, 0};
  tp_cohesive_shear s = {none, none};
  if (tp_near_is_zero(most)) return s;
  bool opens = true;
  const unsigned slips = slips_of_line(&opens, n, q->resting, q->resting->contacts[contact].line);
  if (!opens && slips != 0) s = (tp_cohesive_shear){{INFINITY, 0}, {-INFINITY, 0}};
  if ((slips & (STICKS | FORWARD)) != 0) take(&s, tp_near_neg(most));
  if ((slips & (STICKS | BACK)) != 0) take(&s, most);
  if ((slips & FORWARD) != 0) take(&s, tp_near_neg(least));
  if ((slips & BACK) != 0) take(&s, least);
  return s;
}
