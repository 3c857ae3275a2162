/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Contact forces of the pressing contacts at a moment, the rates of the motion, and the least
 * projection of place and speed back onto closed gaps. */

#include "rigid_contact/smooth.h"

#include <math.h>
#include <string.h>

static void set_law_contact(tp_law_contact *own, const tp_gap *gap, const tp_pressing *pressing) {
  *own = (tp_law_contact){.least = -gap->across_rate,
                          .rest = -gap->along_rate,
                          .friction = pressing->friction,
                          .slip = pressing->sticks ? 0 : -pressing->side};
  memcpy(own->across, gap->across, sizeof own->across);
  memcpy(own->along, gap->along, sizeof own->along);
}

bool tp_smooth_at(tp_smooth_moment *moment, tp_smooth *smooth, double time,
                  const tp_motion_state *state) {
  const tp_contact_system *system = smooth->system;
  tp_law law = {.count = smooth->count, .contacts = moment->contacts};
  tp_law_solution *s = &moment->solution;
  smooth->evaluations++;
  memcpy(law.inertia, system->inertia, sizeof law.inertia);
  const tp_turned_block block = tp_turned_block_at(state);
  tp_contact_system_free(moment->free, system, time);
  memcpy(law.free, moment->free, sizeof law.free);
  s->count = 0;
  for (int k = 0; k < smooth->count; k++) {
    const tp_pressing *own = smooth->pressing + k;
    moment->gaps[k] = tp_gap_moving(&system->shapes, &own->pair, &block);
    set_law_contact(moment->contacts + k, moment->gaps + k, own);
    s->edges[s->count++] = (tp_law_edge){k, own->sticks ? -1 : own->side};
    if (own->sticks) s->edges[s->count++] = (tp_law_edge){k, 1};
  }
  if (!tp_law_solve(s, &law)) return false;
  moment->friction_power = 0;
  for (int k = 0; k < s->count; k++) {
    const tp_law_contact *own = moment->contacts + s->edges[k].contact;
    moment->friction_power +=
        s->factors[k] * s->edges[k].side * own->friction * tp_gap_speed(own->along, state->speed);
  }
  return true;
}

tp_motion_state tp_smooth_state(const double numbers[TP_MOTION_NUMBERS]) {
  return (tp_motion_state){{numbers[0], numbers[1], numbers[2]},
                           {numbers[3], numbers[4], numbers[5]}};
}

void tp_smooth_numbers(double numbers[TP_MOTION_NUMBERS], const tp_motion_state *state,
                       double work) {
  memcpy(numbers, state->place, sizeof state->place);
  memcpy(numbers + 3, state->speed, sizeof state->speed);
  numbers[6] = work;
}

bool tp_smooth_rates(double *rates, void *context, double time, const double *numbers) {
  tp_smooth *smooth = context;
  const tp_motion_state state = tp_smooth_state(numbers);
  tp_smooth_moment moment;
  if (!tp_smooth_at(&moment, smooth, time, &state)) return false;
  rates[6] = moment.friction_power;
  for (int e = 0; e < 3; e++) {
    rates[e] = state.speed[e];
    rates[3 + e] = moment.solution.x[e];
    rates[6] += smooth->system->inertia[e] * moment.free[e] * state.speed[e];
  }
  return true;
}

/* The least change of `free`, in the metric of the inertia, that gives each row its value. */
static bool least_change(double changed[3], const tp_contact_system *system,
                         const tp_law_contact *rows, int count) {
  tp_law law = {.count = count, .contacts = rows};
  tp_law_solution s = {.count = count};
  memcpy(law.inertia, system->inertia, sizeof law.inertia);
  memcpy(law.free, changed, sizeof law.free);
  for (int k = 0; k < count; k++) s.edges[k] = (tp_law_edge){k, -1};
  if (!tp_law_solve(&s, &law)) return false;
  memcpy(changed, s.x, sizeof s.x);
  return true;
}

double tp_smooth_project(tp_motion_state *state, const tp_smooth *smooth) {
  tp_law_contact rows[TP_LAW_EDGES];
  const tp_contact_system *system = smooth->system;
  double moved[3] = {0};
  int count = 0;
  tp_turned_block block = tp_turned_block_at(state);
  for (int k = 0; k < smooth->count; k++) {
    const tp_gap gap = tp_gap_moving(&system->shapes, &smooth->pressing[k].pair, &block);
    rows[k] = (tp_law_contact){.least = -gap.width};
    memcpy(rows[k].across, gap.across, sizeof gap.across);
  }
  if (least_change(moved, system, rows, smooth->count)) {
    for (int e = 0; e < 3; e++) state->place[e] += moved[e];
  }
  block = tp_turned_block_at(state);
  for (int k = 0; k < smooth->count; k++) {
    const tp_gap gap = tp_gap_moving(&system->shapes, &smooth->pressing[k].pair, &block);
    rows[count] = (tp_law_contact){0};
    memcpy(rows[count++].across, gap.across, sizeof gap.across);
    if (!smooth->pressing[k].sticks) continue;
    rows[count] = (tp_law_contact){0};
    memcpy(rows[count++].across, gap.along, sizeof gap.along);
  }
  (void)least_change(state->speed, system, rows, count);
  return fabs(moved[0]) + fabs(moved[1]) + fabs(moved[2]);
}

void tp_smooth_stop(double speed[3], const tp_contact_system *system, const double (*rows)[3],
                    int count) {
  tp_law_contact kept[TP_LAW_EDGES];
  int kept_count = 0;
  double stopped[3];
  for (int k = 0; k < count && kept_count < TP_LAW_EDGES; k++) {
    kept[kept_count] = (tp_law_contact){0};
    memcpy(kept[kept_count].across, rows[k], sizeof kept[kept_count].across);
    memcpy(stopped, speed, sizeof stopped);
    if (least_change(stopped, system, kept, kept_count + 1)) kept_count++;
  }
  if (kept_count > 0) (void)least_change(speed, system, kept, kept_count);
}
