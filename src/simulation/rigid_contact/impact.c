/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Search over all solutions of the impact law for one that does not add energy; restitution is
 * reduced by bisection where none does. */

#include "rigid_contact/impact.h"

#include <math.h>
#include <string.h>

enum { HALVINGS = 50 };

/* Rounding in the energy, as a share of it. */
static const double energy_rounding = 1e-12;

typedef struct search {
  const tp_contact_system *system;
  bool jam, any;
  double most, energy; /* that may be left, and that is */
  double speed[3];
} search;

static bool keep_one(void *context, const tp_law_solution *solution) {
  search *own = context;
  const double energy = tp_motion_energy(own->system, solution->x);
  if (energy > own->most) return true;
  if (own->any && (own->jam ? energy >= own->energy : energy <= own->energy)) return true;
  own->any = true;
  own->energy = energy;
  memcpy(own->speed, solution->x, sizeof own->speed);
  return true;
}

static bool try(tp_impact *impact, tp_touching *touching, const tp_contact_system *system,
                const tp_motion_state *state, double restitution, bool jam) {
  const double before = tp_motion_energy(system, state->speed);
  const tp_law law = tp_touching_impact(touching, system, state, restitution);
  search of = {.system = system, .jam = jam, .most = before * (1 + energy_rounding)};
  (jam ? tp_law_search_all : tp_law_search)(&law, keep_one, &of);
  if (!of.any) return false;
  memcpy(impact->speed, of.speed, sizeof impact->speed);
  impact->energy_lost = before - of.energy;
  impact->restitution = restitution;
  return true;
}

bool tp_impact_find(tp_impact *impact, tp_touching *touching, const tp_contact_system *system,
                    const tp_motion_state *state, double restitution) {
  if (try(impact, touching, system, state, restitution, false)) return true;
  double low = 0, high = restitution;
  if (!try(impact, touching, system, state, 0, false)) return false;
  for (int k = 0; k < HALVINGS; k++) {
    const double middle = (low + high) / 2;
    *(try(impact, touching, system, state, middle, false) ? &low : &high) = middle;
  }
  return true;
}

bool tp_impact_jam(tp_impact *impact, tp_touching *touching, const tp_contact_system *system,
                   const tp_motion_state *state) {
  return try(impact, touching, system, state, 0, true);
}
