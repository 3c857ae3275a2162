/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Contacts of the assemblage are pieces of those that the search knows. */

#include "block_system/system_start.h"

#include "block_system/collapse.h"

#include <math.h>
#include <stdlib.h>

/* A point of a contact: within it, where both ends are closed. */
static bool is_closed(const tp_resting_contact *c, const tp_lattice *l, tp_mode_set mode,
                      long point) {
  const bool first = (mode & tp_modes_closed(0)) != 0, second = (mode & tp_modes_closed(1)) != 0;
  if (c->ends == 1 || tp_lattice_same_point(l, point, c->of.ends[0])) return first;
  return tp_lattice_same_point(l, point, c->of.ends[1]) ? second : first && second;
}

static tp_touch_state state_of(const tp_moving_search *m, long contact, int end) {
  const tp_assemblage *a = m->resting->assemblage;
  const long own = m->resting->pieces[contact].contact;
  const tp_mode_set mode = m->proven[own].mode;
  const long point = a->contacts[contact].ends[end];
  return !is_closed(m->resting->contacts + own, &a->lattice, mode, point) ? TP_TOUCH_OPENS
         : (mode & TP_MODES_FORWARD) != 0                                 ? TP_TOUCH_SLIPS_FORWARD
         : (mode & TP_MODES_BACK) != 0                                    ? TP_TOUCH_SLIPS_BACK
                                                                          : TP_TOUCH_STICKS;
}

tp_status tp_system_start_set(tp_system_case *own, tp_moving_search *m, tp_message *message) {
  tp_system_start *start = &own->start;
  const tp_assemblage *a = m->resting->assemblage;
  start->motions = calloc((size_t)a->count + 1, sizeof *start->motions);
  start->touches = calloc((size_t)a->contact_count + 1, sizeof *start->touches);
  if (start->motions == NULL || start->touches == NULL) {
    return tp_fail_memory(message, "the motions");
  }
  start->motion_count = (size_t)a->count;
  start->touch_count = (size_t)a->contact_count;
  start->divisor = exp(m->x);
  start->tilt_angle_deg = own->tilt_angle_deg.value;
  for (long k = 0; k < a->contact_count; k++) {
    start->touches[k] = (tp_system_touch){state_of(m, k, 0), state_of(m, k, 1)};
  }
  for (long r = 0; r < m->resting->rows; r++) m->accelerations[r] *= -1;
  own->has_start = true;
  return tp_collapse_motions(start->motions, a, m->accelerations, message);
}
