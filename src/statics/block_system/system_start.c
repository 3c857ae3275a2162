/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Contacts of the assemblage are pieces of those that the search knows. */

#include "block_system/system_start.h"

#include "block_system/collapse.h"
#include "block_system/governing_case.h"

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

/* Twists of a collapse run against the motion. */
static tp_status set_motions(tp_system_motion *motions, const tp_moving_search *m,
                             tp_message *message) {
  const size_t rows = (size_t)m->resting->rows;
  double *against = calloc(rows + 1, sizeof *against);
  if (against == NULL) return tp_fail_memory(message, "the motions");
  for (size_t r = 0; r < rows; r++) against[r] = -m->accelerations[r];
  const tp_status status = tp_collapse_motions(motions, m->resting->assemblage, against, message);
  free(against);
  return status;
}

tp_status tp_system_start_set(tp_system_case *own, const tp_moving_search *m, tp_message *message) {
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
  own->has_start = true;
  return set_motions(start->motions, m, message);
}

tp_status tp_system_start_mechanism(tp_mechanism *mechanism, const tp_moving_search *m,
                                    tp_message *message) {
  const size_t count = (size_t)m->resting->assemblage->count;
  tp_system_motion *motions = calloc(count + 1, sizeof *motions);
  if (motions == NULL) return tp_fail_memory(message, "the motions");
  const tp_status status = set_motions(motions, m, message);
  if (status == TP_OK) *mechanism = tp_system_motions_mechanism(motions, count);
  free(motions);
  return status;
}
